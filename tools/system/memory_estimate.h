#pragma once

#include <cstddef>
#include <cstdint>

namespace geolloyd {

/// What a run works on and what it does; what is not known or not wanted is 0.
struct RunSize {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t edges = 0;
  std::uint64_t nodes = 0;
  std::uint64_t links = 0;  ///< arcs in one direction, before repeated ones go
  std::uint64_t seeds = 0;
  std::uint64_t samples = 0;         ///< rays of a picture
  std::uint64_t fine_vertices = 0;   ///< of the surface on which the first seeds come to rest
  std::uint64_t property_bytes = 0;  ///< of colours, labels and so on that are carried
  std::size_t threads = 1;
  bool has_triangle_nodes = false;  ///< of the graph
  bool has_field = false;
  bool has_curvature_field = false;
  bool has_cross_field = false;   ///< and that of crosses
  bool is_reference = false;      ///< the engine
  bool has_coarse_graph = false;  ///< on which the first seeds come to rest
  bool has_ground_truth = false;  ///< for the result or for the remesh
  bool has_dual = false;          ///< its dual is made
};

/// What a run of `remesh` works on; without a picture, `samples` is 0.
struct RemeshSize {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t edges = 0;
  std::uint64_t fine_vertices = 0;  ///< of the surface on which sites move, its long edges split
  std::uint64_t remesh_vertices = 0;
  std::uint64_t samples = 0;
  std::uint64_t property_bytes = 0;
  std::size_t threads = 1;
  bool has_field = false;
};

// Upper estimates of the most memory held at once, bytes: 1 to 1.5 times what is, from some hundred
// thousand triangles on, and up to twice that for a picture or ground truth without a relaxation.

/// Of reading a mesh, when only the size of its file is known: a lower estimate, that.
std::uint64_t memory_to_read(std::uint64_t file_bytes);
/// Of finding the edges and the facts of a mesh that has been read.
std::uint64_t memory_to_check(std::uint64_t vertices, std::uint64_t triangles,
                              std::uint64_t property_bytes = 0);
/// Of repairing a mesh that has been read.
std::uint64_t memory_to_repair(std::uint64_t vertices, std::uint64_t triangles);
/// Of a whole run of `relax`; no other command that relaxes or draws takes more.
std::uint64_t memory_to_run(const RunSize& size);
/// Of a whole run of `remesh`.
std::uint64_t memory_to_remesh(const RemeshSize& size);
/// Of drawing a mesh alone.
std::uint64_t memory_to_draw(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t samples,
                             std::uint64_t property_bytes = 0);
/// Of judging a mesh of `triangles`, beside another of `others`, or none.
std::uint64_t memory_to_judge(std::uint64_t triangles, std::uint64_t others);
/// Of making a mesh of as many triangles as another, `times` over, by cutting these.
std::uint64_t memory_to_subdivide(std::uint64_t triangles, std::uint64_t times);
/// Of making a shape.
std::uint64_t memory_to_generate(std::uint64_t triangles);

}  // namespace geolloyd

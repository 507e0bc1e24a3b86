#pragma once

#include <cstdint>

namespace geolloyd {

/// What a command works on. What it has none of is 0.
struct WorkSize {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t property_bytes = 0;
  std::uint64_t nodes = 0;          ///< of the graph
  std::uint64_t arcs = 0;           ///< in both directions
  std::uint64_t fine_vertices = 0;  ///< of the surface on which the sites of a remesh move
  std::uint64_t sites = 0;          ///< seeds, or vertices of the remesh
  std::uint64_t samples = 0;        ///< rays of a picture
  std::uint64_t threads = 1;
  bool has_field = false;
  bool has_cross_field = false;  ///< and that of crosses
  bool has_ground_truth = false;
};

// The most memory that a command holds at once, bytes: a sum over what it works on, and for `relax`
// the largest of four. The coefficients are as low as they can be with no estimate below a peak
// that bench/studies/memory measured; tests/program/memory_test.cpp holds the program to them.

/// Reading a mesh, its edges and facts.
std::uint64_t bytes_to_read(const WorkSize& size);
/// `relax`, and all commands that need a graph.
std::uint64_t bytes_to_relax(const WorkSize& size);
std::uint64_t bytes_to_remesh(const WorkSize& size);
std::uint64_t bytes_to_repair(const WorkSize& size);
/// A picture of the mesh alone.
std::uint64_t bytes_to_draw(const WorkSize& size);
/// Judging a remesh, beside an original if that has triangles; the field is the original's.
std::uint64_t bytes_to_judge(const WorkSize& remesh, const WorkSize& original);
/// Making a mesh of so many triangles, from one of `before`.
std::uint64_t bytes_to_make(std::uint64_t triangles, std::uint64_t before);

}  // namespace geolloyd

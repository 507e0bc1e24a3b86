#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// A translation, then a scaling by a power of two, after which every coordinate of a mesh is
/// between -1 and 1.
struct SurfaceFrame {
  Vec3 middle = Vec3::Zero();
  double scale = 1;

  [[nodiscard]] Vec3 to_unit(const Vec3& p) const { return (p - middle) * scale; }
  [[nodiscard]] Vec3 to_mesh(const Vec3& p) const { return p / scale + middle; }
};

/// Of the corners of a mesh's triangles.
SurfaceFrame frame_of(const Mesh& mesh, Executor& executor = sequential());

/// The surface on which sites move: the usable triangles of a mesh, cut apart where they are not a
/// manifold, so that every edge has one or two of them, with edges split that are long for their
/// size.
struct SurfaceInput {
  SurfaceFrame frame;
  FineMesh fine;
  std::vector<TriangleId> origin;  ///< per triangle of `fine`: the mesh's, in which it lies
  bool has_flips = false;  ///< edges were flipped: `origin` is a triangle of the mesh near by
  std::vector<std::array<VertexId, 2>> boundary_edges;  ///< of `fine`, with one triangle; ascending
  std::vector<std::array<VertexId, 2>> feature_edges;   ///< of `fine`, with two; ascending
  std::vector<VertexId> fixed_vertices;                 ///< of `fine`; ascending, each once
  std::vector<std::uint32_t> part;  ///< per vertex of `fine`: its connected part, by first vertex
  std::size_t parts = 0;
  std::size_t vertices_cut = 0;  ///< of the mesh: became several
  bool was_cut_short = false;    ///< edges are left that are long: there were vertices enough
};

struct SurfaceInputOptions {
  std::span<const TriangleId> duplicates;  ///< of the mesh: left out
  double longest_edge = 0;                 ///< mesh units; 0: none is split
  /// Per vertex of the mesh: how long edges are to be there, in multiples of the spacing of evenly
  /// spread sites; above 0. Empty: 1 everywhere.
  std::span<const double> sizes;
  std::span<const Metric> metric;  ///< per vertex of the mesh, of FineMesh; empty: none
  std::size_t vertex_limit = 0;    ///< no edge is split from there on
  double most_pieces = 0;  ///< of long edges: where there would be more, needles are split in a way
                           ///< that needs fewer (split_needles.h); 0: in no case
  std::span<const TrianglePair> features;
  std::span<const VertexId> fixed_vertices;  ///< of the mesh; those of no triangle are passed over
};

/// Per part.
std::vector<std::int64_t> euler_characteristics(const SurfaceInput& input);

SurfaceInput make_surface_input(const Mesh& mesh, const SurfaceInputOptions& options,
                                Executor& executor = sequential());

/// Values per vertex of the mesh that `input` was made of, at vertices of `input.fine`: linear
/// within triangles.
std::vector<double> at_fine_vertices(const Mesh& mesh, const SurfaceInput& input,
                                     std::span<const double> values,
                                     Executor& executor = sequential());

/// The same surface with other sizes, per vertex of `input.fine`, and its edges split that are long
/// for them. `options` are those that it was made with.
SurfaceInput with_sizes(SurfaceInput input, std::vector<double> sizes, SurfaceInputOptions options,
                        Executor& executor = sequential());

}  // namespace geolloyd

#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/substrate/split_edges.h"

namespace geolloyd {

/// About how many pieces split_long_edges() makes of the edges of a mesh. Of needles side by side
/// that is far more than the surface has room for sites, as each of their edges has a row of pieces
/// of its own.
double pieces_of_long_edges(const Mesh& mesh, const EdgeSizes& sizes, double longest,
                            Executor& executor = sequential());

/// Halves edges that are longer than `longest` times the smaller size of their ends, until none is
/// or the mesh has `vertex_limit` vertices: always the longest for its size. Before, and after
/// each, edges between flat triangles are flipped until they are Delaunay, so that needles within a
/// face become triangles between what is near, and a face has about as many vertices as its area
/// and its border need, however it was triangulated. All that is a bound on work:
/// split_long_edges() is faster, keeps all edges and is right for all other meshes.
///
/// Flips move the surface by at most a 32nd of what is long, those at a place together, but for
/// flips that move it by a 32nd of that: they pass for flat. Vertices stay, also boundary edges and
/// feature edges, or their halves, and the topology. The mesh has edges of one or two triangles
/// (cut_apart.h). `origin` has an entry per triangle; that of a triangle that was flipped is near
/// it, no more.
///
/// `features`: pairs of entries of `origin`, ascending. Returns what became of the edges between
/// them, ascending.
std::vector<std::array<VertexId, 2>> split_needles(Mesh& mesh, std::vector<TriangleId>& origin,
                                                   EdgeSizes& sizes, double longest,
                                                   std::size_t vertex_limit,
                                                   std::span<const TrianglePair> features);

}  // namespace geolloyd

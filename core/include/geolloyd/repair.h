#pragma once

#include <cstddef>
#include <vector>

#include "geolloyd/mesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// A hole is filled where either of the two holds.
struct RepairOptions {
  std::size_t hole_edges = 0;  ///< it has at most so many edges
  double hole_share = 0.05;    ///< it is at most as long as this share of the diagonal of the
                               ///< bounding box of its component
};

/// Makes a manifold: each edge has one or two triangles, each vertex one fan of them. Neighbours
/// have the same orientation, but in components that have none. What is not repaired keeps its
/// place and order; a mesh without flaws is returned to the bit. The steps, in this order:
///
/// 1. Triangles that name a vertex twice and duplicate triangles are left out, then vertices with
///    several fans are cut into one for each.
/// 2. A component is left out if all its triangles are slivers, or if each lies on one of another
///    component that stays. A sliver is lower than a millionth of its longest edge.
/// 3. Two boundary edges in the same place are joined, if no other edge is there, or none of their
///    component.
/// 4. Slivers go: short edges collapse, long edges flip.
/// 5. A component in which neighbours disagree is oriented: outward if it is closed, else as most
///    of its area is.
/// 6. Small holes are filled with the triangles that bend least (Liepa 2003).
///
/// No step leaves more non-manifold edges or boundary loops than the mesh cut apart has. Throws
/// InvalidInput where the mesh is not valid or an option makes no sense.
struct RepairedMesh repair(const Mesh& mesh, const RepairOptions& options = {},
                           Runtime& runtime = all_threads());

/// What a repair did, and what it had to leave.
struct Repairs {
  std::size_t repeated_vertex_triangles = 0;  ///< left out
  std::size_t duplicate_triangles = 0;        ///< left out: same vertices, or same places
  std::size_t vertices_cut = 0;               ///< of the input: where it was no manifold
  std::size_t vertices_merged = 0;            ///< with others in the same place
  std::size_t slivers_removed = 0;            ///< triangles without area, by any means
  std::size_t slivers_left = 0;
  std::size_t triangles_turned = 0;         ///< the orientation of so many was reversed
  std::size_t unorientable_components = 0;  ///< like a Moebius strip; as they were
  std::size_t holes_filled = 0;
  std::size_t triangles_added = 0;  ///< to fill holes
  std::size_t holes_left = 0;       ///< small enough, but a filling would fold, or touch or pass
                                    ///< through the surface
  std::size_t unused_vertices = 0;  ///< of no triangle of the input; left out

  /// Whether the mesh is another one now.
  [[nodiscard]] bool any() const;
};

struct RepairedMesh {
  Mesh mesh;
  std::vector<VertexId> vertex_origin;  ///< per vertex: that of the input; of several merged, the
                                        ///< smallest
  std::vector<TriangleId> triangle_origin;  ///< per triangle: that of the input, or no_id where it
                                            ///< fills a hole
  Repairs repairs;
};

}  // namespace geolloyd

#pragma once

#include <cmath>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/executor.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// A straight way over the surface crosses at most so many edges. That is some three edges far.
inline constexpr int most_crossings = 5;
/// A way is left out where a detour by a vertex of a crossed edge is longer by less than this
/// share: two shorter ways then do as well.
inline constexpr double least_detour = 3e-3;

/// A place in the plane into which the triangles on the way are unfolded. The way begins at 0, 0.
struct UnfoldedPlace {
  double x;
  double y;
};

/// An edge that straight ways cross, as they see it: its right end, its left end, and between which
/// directions they come.
struct CrossedEdge {
  const CrossedEdge* before;  ///< crossed before this one, or null
  CornerId corner;            ///< opposite to it, where the ways come from
  VertexId right;
  VertexId left;
  UnfoldedPlace right_place;
  UnfoldedPlace left_place;
  UnfoldedPlace rightmost;  ///< direction
  UnfoldedPlace leftmost;
  int crossings;  ///< with this one
};

/// A straight way between two vertices that crosses an edge or more.
struct GeodesicShortcut {
  VertexId from;
  VertexId to;
  double length;
  UnfoldedPlace end;
  CornerId last_corner;     ///< at `to`, opposite to the last edge
  const CrossedEdge* last;  ///< the others by `before`
};

/// Where a way goes through one triangle.
struct StraightPiece {
  TriangleId triangle;
  Vec3 displacement;
};

/// Straight ways over the surface: geodesics that meet no vertex between their ends. They do not
/// cross edges of one triangle or of more than two. Each is found once, from its smaller vertex, by
/// unfolding the triangles that a vertex sees through the edges around it. O(1) for each corner.
class GeodesicShortcuts {
 public:
  GeodesicShortcuts(const Mesh& mesh, const MeshEdges& edges, Executor& executor);

  /// Calls visit(way) for each way from `v` to a larger vertex.
  template <class Visit>
  void visit(VertexId v, Visit&& visit) const {
    for (const CornerId corner : fans_[v]) look(first_edge(corner), v, visit);
  }

  /// Calls visit(piece) for each triangle on the way, the last one first.
  template <class Visit>
  void visit_pieces(const GeodesicShortcut& way, Visit&& visit) const {
    Vec3 end = mesh_.positions[way.to];
    TriangleId triangle = triangle_of(way.last_corner);
    for (const CrossedEdge* edge = way.last; edge != nullptr; edge = edge->before) {
      const Vec3 start = crossing(*edge, way.end);
      visit(StraightPiece{triangle, end - start});
      end = start;
      triangle = triangle_of(edge->corner);
    }
    visit(StraightPiece{triangle, end - mesh_.positions[way.from]});
  }

 private:
  [[nodiscard]] CrossedEdge first_edge(CornerId corner) const;
  [[nodiscard]] UnfoldedPlace unfolded(const CrossedEdge& edge, CornerId corner,
                                       bool is_forward) const;
  [[nodiscard]] Vec3 crossing(const CrossedEdge& edge, const UnfoldedPlace& end) const;

  static double turn(const UnfoldedPlace& from, const UnfoldedPlace& to) {
    return from.x * to.y - from.y * to.x;
  }
  static double length(const UnfoldedPlace& p) { return std::sqrt(p.x * p.x + p.y * p.y); }
  [[nodiscard]] static bool has_short_detour(const CrossedEdge* last, const UnfoldedPlace& end);

  // The ways through an edge: to the vertex beyond, if it is seen, and through the two edges there.
  template <class Visit>
  void look(const CrossedEdge& edge, VertexId from, Visit&& visit) const {
    const CornerId corner = opposite_[edge.corner];
    if (corner == no_id) return;
    const VertexId beyond = apex(mesh_, corner);
    const bool is_forward = edge.right == edge_start(mesh_, corner);
    const UnfoldedPlace place = unfolded(edge, corner, is_forward);
    const bool is_left = turn(edge.rightmost, place) > 0;
    const bool is_right = turn(place, edge.leftmost) > 0;
    if (is_left && is_right && beyond > from && !has_short_detour(&edge, place)) {
      visit(GeodesicShortcut{from, beyond, length(place), place, corner, &edge});
    }
    if (edge.crossings == most_crossings) return;
    if (is_left) {
      look({&edge, is_forward ? corner_at_end(corner) : corner_at_start(corner), edge.right, beyond,
            edge.right_place, place, edge.rightmost, is_right ? place : edge.leftmost,
            edge.crossings + 1},
           from, visit);
    }
    if (is_right) {
      look({&edge, is_forward ? corner_at_start(corner) : corner_at_end(corner), beyond, edge.left,
            place, edge.left_place, is_left ? place : edge.rightmost, edge.leftmost,
            edge.crossings + 1},
           from, visit);
    }
  }

  const Mesh& mesh_;
  Buffer<UnfoldedPlace> apex_;      // per corner: by the edge opposite, from its start, as the axis
  std::vector<CornerId> opposite_;  // per corner: that across the edge; or no_id
  Bucketed<CornerId> fans_;         // corners at each vertex
};

}  // namespace geolloyd

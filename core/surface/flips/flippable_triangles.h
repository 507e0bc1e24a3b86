#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace geolloyd {

/// The triangles of a manifold, each with those beyond its edges. Edges can be flipped, and
/// triangles replaced. A part of a manifold is one, too, but for vertices whose triangles are not
/// all there.
class FlippableTriangles {
 public:
  FlippableTriangles(std::size_t vertices, std::span<const Triangle> triangles);

  /// An edge as one of its triangles sees it: opposite to its corner.
  struct Side {
    TriangleId triangle = no_id;
    std::uint32_t corner = 0;
  };
  /// a: the side's corner; b, c: the edge; d: the corner beyond it.
  struct Quad {
    VertexId a, b, c, d;
  };

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] const Triangle& operator[](std::size_t t) const { return triangles_[t]; }
  [[nodiscard]] VertexId corner(TriangleId t, std::uint32_t k) const {
    return triangles_[t][k % 3];
  }

  /// no_id: the edge is on the boundary.
  [[nodiscard]] TriangleId across(Side side) const { return across_[side.triangle][side.corner]; }

  /// Calls visit(triangle) for each at a vertex, once.
  template <class Visit>
  void visit_around(VertexId v, Visit&& visit) const {
    const TriangleId first = one_at_[v];
    if (first == no_id) return;
    visit(first);
    for (const std::uint32_t turn : {1U, 2U}) {
      TriangleId before = first;
      TriangleId now = across_[first][(corner_of(first, v) + turn) % 3];
      while (now != no_id && now != first) {
        visit(now);
        const std::uint32_t k = corner_of(now, v);
        const TriangleId one = across_[now][(k + 1) % 3];
        const TriangleId other = across_[now][(k + 2) % 3];
        const TriangleId after = one != before ? one : other;
        before = now;
        now = after;
      }
      if (now == first) return;
    }
  }
  [[nodiscard]] std::size_t count_around(VertexId v) const;  ///< triangles
  [[nodiscard]] bool is_inside(VertexId v) const;            ///< no edge of it has one triangle
  [[nodiscard]] bool is_edge(VertexId a, VertexId b) const;
  /// Of an edge; no triangle where there is no such edge.
  [[nodiscard]] Side side_of(VertexId b, VertexId c) const;

  /// Whether there are two triangles, with one orientation.
  [[nodiscard]] bool has_quad(Side side) const;
  [[nodiscard]] Quad quad_of(Side side) const;
  /// The two triangles become (a, b, d) and (a, d, c).
  void flip(Side side);

  /// A triangle with other corners. With corners of no_id there is none any more; its id is free.
  struct Replacement {
    TriangleId triangle;
    Triangle corners;
  };
  static constexpr Triangle none = {no_id, no_id, no_id};
  /// Some triangles by others that fill the same place. Ids and vertices one past the last make the
  /// arrays longer.
  void replace(std::span<const Replacement> replacements);
  [[nodiscard]] bool exists(TriangleId t) const { return triangles_[t] != none; }

 private:
  struct SideOfEdge {
    std::array<VertexId, 2> edge;  // ascending
    Side side;
  };
  void add_sides(TriangleId t, std::vector<SideOfEdge>& sides) const;
  void connect(std::vector<SideOfEdge> sides);
  void make_room(const Replacement& replacement);
  [[nodiscard]] std::uint32_t corner_of(TriangleId t, VertexId v) const {
    return triangles_[t][0] == v ? 0 : (triangles_[t][1] == v ? 1 : 2);
  }
  // The corner of `t` across whose opposite edge `other` is.
  [[nodiscard]] std::uint32_t corner_before(TriangleId t, TriangleId other) const {
    return across_[t][0] == other ? 0 : (across_[t][1] == other ? 1 : 2);
  }

  std::vector<Triangle> triangles_;
  std::vector<std::array<TriangleId, 3>> across_;  // per triangle: beyond the edge opposite to each
                                                   // corner
  std::vector<TriangleId> one_at_;                 // per vertex; no_id: it has none
};

}  // namespace geolloyd

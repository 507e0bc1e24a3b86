#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/flips/gliding_remesh.h"

namespace geolloyd {

/// A copy of the part of a remesh about a vertex, to try things on. Vertices and triangles have
/// their own numbers here; the centre is 0. What a split adds has the next numbers, here and in the
/// remesh.
class GlidePatch {
 public:
  /// The triangles at all vertices within `rings` edges.
  GlidePatch(const GlidingRemesh& remesh, VertexId centre, std::size_t rings);

  /// Vertices whose triangles are all here, and these triangles.
  struct Region {
    std::vector<VertexId> vertices;
    std::vector<TriangleId> triangles;
  };
  /// Within `rings` edges of these.
  [[nodiscard]] Region region_about(std::span<const VertexId> centres, std::size_t rings) const;
  /// What a region has become: without what is gone, and with what is new.
  [[nodiscard]] Region region_now(const Region& before) const;

  [[nodiscard]] bool can_flip(FlippableTriangles::Side side) const;
  void flip(FlippableTriangles::Side side);
  /// Whether both triangles would have some area, seen along the normal of those that are there.
  [[nodiscard]] bool is_upright_flipped(FlippableTriangles::Side side) const;

  /// The edge of a side: c becomes one with b, and both triangles are gone.
  [[nodiscard]] bool can_collapse(FlippableTriangles::Side side) const;
  void collapse(FlippableTriangles::Side side);
  /// Of a vertex, with two of its neighbours: a new vertex takes the triangles from `a` to `d`, in
  /// their order around it, and there is an edge between the two.
  struct Split {
    VertexId vertex, a, d;
  };
  /// Those after which no vertex has fewer than 4 neighbours.
  [[nodiscard]] std::vector<Split> splits_of(VertexId v) const;
  void split(const Split& split);
  /// The neighbours that both would have.
  [[nodiscard]] std::array<int, 2> neighbours_split(const Split& split) const;

  /// How many neighbours a vertex has beyond 6; below 0 where it has fewer. 0 on the boundary.
  [[nodiscard]] int excess(VertexId v) const { return excess_[v]; }
  /// Not on the boundary of the remesh.
  [[nodiscard]] bool is_inside(VertexId v) const { return is_inside_[v] != 0; }
  /// It can be moved, and all its triangles are here.
  [[nodiscard]] bool is_free(VertexId v) const {
    return is_inner_[v] != 0 && is_inside(v) && vertex_[v] >= remesh_->fit.held;
  }

  /// What irregular vertices cost: 1 for one edge too many or few, 5 for two, 8 for three...
  [[nodiscard]] int irregularity(const Region& region) const;
  [[nodiscard]] std::size_t count_irregular(const Region& region) const;

  [[nodiscard]] const FlippableTriangles& triangles() const { return triangles_; }
  [[nodiscard]] const Vec3& position(VertexId v) const { return position_[v]; }
  /// Of a triangle, asked for.
  [[nodiscard]] double area_at(VertexId v) const { return area_[v]; }
  /// In the remesh.
  [[nodiscard]] VertexId vertex(VertexId v) const { return vertex_[v]; }
  [[nodiscard]] TriangleId triangle(TriangleId t) const { return triangle_[t]; }
  [[nodiscard]] std::span<const VertexId> vertices() const { return vertex_; }
  /// Triangles of the remesh whose samples are nearest to a triangle, or were to one that is gone.
  [[nodiscard]] std::vector<TriangleId> samples_from(TriangleId t) const;

 private:
  struct Heir {
    TriangleId gone;
    TriangleId heir;
  };

  void add_rings(VertexId centre, std::size_t rings, std::vector<Triangle>& triangles);
  void take_vertices();
  void count_anew(VertexId v);
  [[nodiscard]] std::vector<VertexId> ring_of(VertexId v) const;
  [[nodiscard]] std::vector<VertexId> arc_of(const Split& split) const;

  const GlidingRemesh* remesh_;
  std::vector<VertexId> vertex_;      // per vertex: of the remesh
  std::vector<TriangleId> triangle_;  // per triangle: of the remesh
  FlippableTriangles triangles_;
  std::vector<std::uint8_t> is_inner_;  // per vertex: all its triangles are here
  std::vector<Vec3> position_;
  std::vector<double> area_;
  std::vector<std::uint8_t> is_inside_;
  std::vector<int> excess_;
  std::vector<Heir> heirs_;
};

}  // namespace geolloyd

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/flips/gliding_remesh.h"

namespace geolloyd {

/// A copy of the part of a remesh about a vertex, to try things on. Vertices and triangles have
/// their own numbers here; the centre is 0.
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

  [[nodiscard]] bool can_flip(FlippableTriangles::Side side) const;
  void flip(FlippableTriangles::Side side);
  /// Whether both triangles would have some area, seen along the normal of those that are there.
  [[nodiscard]] bool is_upright_flipped(FlippableTriangles::Side side) const;
  /// How many neighbours a vertex has beyond 6; below 0 where it has fewer. 0 on the boundary.
  [[nodiscard]] int excess(VertexId v) const { return excess_[v]; }
  /// Not on the boundary of the remesh.
  [[nodiscard]] bool is_inside(VertexId v) const { return is_inside_[v] != 0; }

  /// What irregular vertices cost: 1 for one edge too many or few, 5 for two, 8 for three...
  [[nodiscard]] int irregularity(const Region& region) const;
  [[nodiscard]] std::size_t count_irregular(const Region& region) const;

  [[nodiscard]] const FlippableTriangles& triangles() const { return triangles_; }
  [[nodiscard]] const Vec3& position(VertexId v) const { return position_[v]; }
  /// In the remesh.
  [[nodiscard]] VertexId vertex(VertexId v) const { return vertex_[v]; }
  [[nodiscard]] TriangleId triangle(TriangleId t) const { return triangle_[t]; }
  [[nodiscard]] std::span<const VertexId> vertices() const { return vertex_; }

 private:
  void add_rings(VertexId centre, std::size_t rings, std::vector<Triangle>& triangles);
  void take_vertices();

  const GlidingRemesh* remesh_;
  std::vector<VertexId> vertex_;      // per vertex: of the remesh
  std::vector<TriangleId> triangle_;  // per triangle: of the remesh
  FlippableTriangles triangles_;
  std::size_t inner_ = 0;  // the first vertices: all their triangles are here
  std::vector<Vec3> position_;
  std::vector<std::uint8_t> is_inside_;
  std::vector<int> excess_;
};

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// An edge's place in MeshEdges.
using EdgeId = std::uint32_t;

/// How sharply a mesh turns at its edges. Triangles of opposite orientation are taken as if one
/// were turned round. Refers to mesh and edges.
class EdgeAngles {
 public:
  EdgeAngles(const Mesh& mesh, const MeshEdges& edges, Executor& executor = sequential());

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const MeshEdges& edges() const { return edges_; }
  /// Of length 1; 0 where the triangle has no area.
  [[nodiscard]] const Vec3& normal(TriangleId t) const { return normal_[t]; }
  /// Of the angle between the normals on the two sides; nothing where there are not two triangles
  /// with an area.
  [[nodiscard]] std::optional<double> cosine(EdgeId e) const;
  /// Whether it has this cosine or a smaller one.
  [[nodiscard]] bool is_as_sharp(EdgeId e, double cosine) const;
  /// Mesh units.
  [[nodiscard]] double length(EdgeId e) const;
  /// Whether the two triangles of an edge have opposite orientations.
  [[nodiscard]] bool is_turned_round(EdgeId e) const;

 private:
  [[nodiscard]] bool has_area(TriangleId t) const { return dot(normal_[t], normal_[t]) > 0.5; }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<Vec3> normal_;  // per triangle
};

}  // namespace geolloyd

#pragma once

#include <algorithm>

#include "core/mesh/mesh.h"
#include "core/surface/substrate/split_edges.h"

namespace geolloyd {

/// Measures edges of a mesh that grows.
class EdgeRuler {
 public:
  /// All must live on.
  EdgeRuler(const Mesh& mesh, const EdgeSizes& sizes, double longest)
      : mesh_(mesh), sizes_(sizes), longest_(longest) {}

  [[nodiscard]] double length(VertexId a, VertexId b) const {
    const Vec3 edge = mesh_.positions[a] - mesh_.positions[b];
    if (sizes_.metric.empty()) return norm(edge);
    return (0.5 * (sizes_.metric[a] + sizes_.metric[b])).length(edge);
  }
  [[nodiscard]] double longest_at(VertexId a, VertexId b) const {
    const std::vector<double>& sizes = sizes_.sizes;
    return sizes.empty() ? longest_ : longest_ * std::min(sizes[a], sizes[b]);
  }
  [[nodiscard]] bool is_long(VertexId a, VertexId b) const {
    return length(a, b) > longest_at(a, b);
  }
  /// Above 1 for long edges.
  [[nodiscard]] double ratio(VertexId a, VertexId b) const {
    return length(a, b) / longest_at(a, b);
  }

 private:
  const Mesh& mesh_;
  const EdgeSizes& sizes_;
  double longest_;
};

}  // namespace geolloyd

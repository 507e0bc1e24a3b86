#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// A point of the surface that stands for some area, near a vertex of the remesh.
struct Sample {
  Vec3 point;
  double weight;
  RegionId near;
};

class SampleSet {
 public:
  virtual ~SampleSet() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual Sample operator[](std::size_t i) const = 0;
};

/// Points all over a surface: centroids of triangles where there are many, else centroids and
/// corners, by the rule that is exact for polynomials of degree 2. There are too many to be kept:
/// each is found when it is asked for.
class SurfaceSamples final : public SampleSet {
 public:
  /// At least `per_vertex` for each of the remesh.
  SurfaceSamples(const FineMesh& fine, std::span<const RegionId> labels, std::size_t vertices,
                 std::size_t per_vertex)
      : fine_(fine),
        labels_(labels),
        has_corners_(fine.triangle_count() < per_vertex * vertices),
        stride_(std::max<std::size_t>(1, fine.triangle_count() / (per_vertex * vertices))),
        centroids_((fine.triangle_count() + stride_ - 1) / stride_) {}

  [[nodiscard]] std::size_t size() const override {
    return centroids_ + (has_corners_ ? fine_.vertex_count() : 0);
  }
  [[nodiscard]] Sample operator[](std::size_t i) const override {
    const std::vector<Vec3>& p = fine_.positions;
    if (i < centroids_) {
      const auto t = static_cast<TriangleId>(i * stride_);
      const auto& [a, b, c] = fine_.triangles[t];
      const double share = has_corners_ ? 0.75 : static_cast<double>(stride_);
      return {(p[a] + p[b] + p[c]) / 3, share * fine_.area(t), labels_[a]};
    }
    const auto v = static_cast<VertexId>(i - centroids_);
    double area = 0;
    for (const TriangleId t : fine_.triangles_at(v)) area += fine_.area(t);
    return {p[v], area / 12, labels_[v]};
  }

 private:
  const FineMesh& fine_;
  std::span<const RegionId> labels_;
  bool has_corners_;
  std::size_t stride_;
  std::size_t centroids_;
};

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/features/feature_curve.h"

namespace geolloyd {

/// A polygon of vertices, open or closed, that is to become feature curves: finds the corners at
/// which it is to be cut.
class Polyline {
 public:
  Polyline(const FineMesh& mesh, std::vector<VertexId> vertices, bool is_closed);

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  /// Counted by the inverse sizing.
  [[nodiscard]] double sized_length() const { return arc_.back(); }

  /// Of a closed one: three sites on it would be closer together than they should.
  [[nodiscard]] bool is_subresolution_hole(double spacing) const;

  /// Places in `vertices` at which it turns most sharply within half a spacing to either side,
  /// ascending; no ends. It turns there by more than 50 degrees, or by 30 between straight sides.
  [[nodiscard]] std::vector<std::size_t> corners(double spacing) const;

  /// The section from one place to a later one, or around to it.
  [[nodiscard]] FeatureCurve curve(std::size_t from, std::size_t to) const;

 private:
  [[nodiscard]] std::size_t edges() const { return is_closed_ ? size() : size() - 1; }
  [[nodiscard]] const Vec3& position(std::size_t i) const {
    return mesh_.positions[vertices_[i % size()]];
  }
  [[nodiscard]] double inverse_sizing(std::size_t i) const {
    return mesh_.inverse_sizing_at(vertices_[i % size()]);
  }
  // Whether it goes on from vertex i; else that is an end.
  [[nodiscard]] bool goes_on(std::size_t i, bool forward) const {
    return is_closed_ || i != (forward ? size() - 1 : 0);
  }

  [[nodiscard]] Vec3 point_at(std::size_t i, double way) const;
  [[nodiscard]] double cosine_of_turn(std::size_t i, double reach) const;
  [[nodiscard]] bool is_corner(double cosine, std::size_t i, double reach) const;
  [[nodiscard]] bool is_sharpest(const std::vector<double>& turn, std::size_t i,
                                 double reach) const;

  const FineMesh& mesh_;
  std::vector<VertexId> vertices_;
  bool is_closed_;
  double length_ = 0;
  std::vector<double> arc_;
};

}  // namespace geolloyd

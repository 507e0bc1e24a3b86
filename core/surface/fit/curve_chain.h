#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/features/patches.h"

namespace geolloyd {

/// The edges of a remesh along a curve, and samples of the curve, each with its foot on them. Unit
/// frame.
class CurveChain {
 public:
  /// `labels` of the vertices of the surface: those of the remesh.
  CurveChain(const FineMesh& mesh, const FeatureCurve& curve, std::span<const RegionId> labels,
             const std::vector<Vec3>& remesh_positions);

  /// Of the remesh, in the order of the curve.
  [[nodiscard]] const std::vector<VertexId>& vertices() const { return vertices_; }
  void hold(std::size_t i) { is_held_[i] = 1; }

  /// Moves those that are not held to where the samples are nearest in the mean square. Vertices
  /// slide along the curve only where that makes a good difference, as where it bends between
  /// straight sides. No sample ends farther than the farthest one was.
  void fit();
  /// Puts vertex i back to where it was at first. False where it is.
  bool put_back(std::size_t i);
  /// The same for those about samples that are farther than the farthest one was, until none is.
  void put_back_far();

  [[nodiscard]] const Vec3& position(std::size_t i) const { return positions_[i]; }
  /// The point of the curve nearest to vertex i.
  [[nodiscard]] Vec3 point_near(std::size_t i) const;

 private:
  struct Sample {
    Vec3 point;
    double weight;
    std::size_t edge;  // where its foot is
    double share = 0;  // of the way along it
    Vec3 away = Vec3::Zero();
  };

  void add_vertices(const FeatureCurve& curve, std::span<const RegionId> labels,
                    std::vector<std::size_t>& place);
  void add_samples(const FineMesh& mesh, const FeatureCurve& curve,
                   const std::vector<std::size_t>& place);
  [[nodiscard]] std::size_t edges() const { return vertices_.size() - (is_loop_ ? 0 : 1); }
  [[nodiscard]] std::size_t after(std::size_t i) const {
    return i + 1 == vertices_.size() ? 0 : i + 1;
  }
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return i == 0 ? vertices_.size() - 1 : i - 1;
  }
  [[nodiscard]] double edge_length(std::size_t i) const {
    return norm(start_[after(i)] - start_[i]);
  }
  [[nodiscard]] bool is_straight() const;
  void find_feet();
  void find_foot(Sample& sample) const;
  [[nodiscard]] double largest_square() const;
  [[nodiscard]] double sum_of_squares() const;
  void fit_from_start(double stiffness);
  void move_vertices(double stiffness);
  [[nodiscard]] Vec3 within_reach(std::size_t i, const Vec3& position) const;

  bool is_loop_;
  std::vector<VertexId> vertices_;
  std::vector<std::uint8_t> is_held_;
  std::vector<Vec3> start_;
  std::vector<Vec3> positions_;
  std::vector<Sample> samples_;
  double largest_allowed_ = 0;  // square distance of a sample
};

}  // namespace geolloyd

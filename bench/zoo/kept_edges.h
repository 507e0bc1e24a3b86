#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bench/zoo/part.h"

namespace geolloyd::zoo {

/// How much of the sharp edges of a part a remesh has. Counted are those between faces that are
/// wider than an edge of the remesh, for nothing smaller can be asked of it; rims are narrower
/// where their diameter is.
class KeptEdges {
 public:
  KeptEdges(const Truth& truth, const Mesh& remesh, double diagonal);

  /// Of their length: what has a crease of the remesh within .2 % of the diagonal. Nothing without
  /// such edges.
  [[nodiscard]] std::optional<double> share() const;
  /// Vertices within that distance of a rim, on the rim that has fewest. Rims shorter than an edge
  /// do not count; nothing where there are no others.
  [[nodiscard]] std::optional<std::size_t> least_on_rim() const { return least_on_rim_; }

 private:
  struct Sample {
    Vec3 place;
    std::array<Vec3, 2> into;
  };

  [[nodiscard]] std::vector<Sample> samples_of(const std::vector<SharpEdge>& sharp) const;
  [[nodiscard]] bool is_beside_wide_faces(const Sample& sample) const;
  [[nodiscard]] bool is_on_narrow_rim(const Vec3& place) const;
  [[nodiscard]] bool has_crease(const Vec3& place) const;
  void count_on_rims(const Mesh& remesh);

  const Truth& truth_;
  double near_;     // mesh units
  double spacing_;  // of the remesh
  std::vector<Segment> creases_;
  std::size_t counted_ = 0;
  std::size_t kept_ = 0;
  std::optional<std::size_t> least_on_rim_;
};

}  // namespace geolloyd::zoo

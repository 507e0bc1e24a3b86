#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// Points on a surface, spread evenly by area: it is cut into as many pieces of equal area as there
/// are points, triangle after triangle, and each piece has one, at random. at() may be called by
/// many threads, and successive points are mostly near each other.
class SurfaceSamples {
 public:
  /// `triangle_area`: per triangle (mesh_measure.h), not negative. Keeps a reference to the mesh.
  /// Throws InvalidInput where it has no area.
  SurfaceSamples(const Mesh& mesh, std::span<const double> triangle_area, std::size_t count,
                 std::uint64_t random_seed);

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] Vec3 at(std::size_t sample) const;

 private:
  const Mesh& mesh_;
  std::size_t count_;
  std::uint64_t random_seed_;
  std::vector<double> area_until_;  // per triangle, itself included
};

}  // namespace geolloyd

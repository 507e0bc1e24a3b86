#include "tools/evaluation/distances/surface_samples.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "geolloyd/errors.h"

namespace geolloyd {

SurfaceSamples::SurfaceSamples(const Mesh& mesh, std::span<const double> triangle_area,
                               std::size_t count, std::uint64_t random_seed)
    : mesh_(mesh), count_(count), random_seed_(random_seed) {
  area_until_.reserve(mesh.triangle_count());
  double area = 0;
  for (const double of_triangle : triangle_area) {
    area += of_triangle;
    area_until_.push_back(area);
  }
  if (area == 0) throw InvalidInput("no triangle with an area, so no distance to measure");
}

// The square root spreads points evenly over a triangle (Osada et al. 2002).
Vec3 SurfaceSamples::at(std::size_t sample) const {
  const auto random = [&](std::uint64_t n) { return random_unit(random_seed_, 3 * sample + n); };
  const double share = (static_cast<double>(sample) + random(0)) / static_cast<double>(count_);
  const auto found =
      std::upper_bound(area_until_.begin(), area_until_.end() - 1, share * area_until_.back());
  const Triangle& t = mesh_.triangles[static_cast<std::size_t>(found - area_until_.begin())];
  const double root = std::sqrt(random(1));
  const double c = root * random(2);
  return (1 - root) * mesh_.positions[t[0]] + (root - c) * mesh_.positions[t[1]] +
         c * mesh_.positions[t[2]];
}

}  // namespace geolloyd

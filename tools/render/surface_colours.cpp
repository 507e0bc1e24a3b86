#include "tools/render/surface_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/base/rounding.h"
#include "core/properties/properties.h"

namespace geolloyd {
namespace {

std::vector<Colour> colours_of(std::span<const Property> properties) {
  const Triple parts = find_triple(properties, colour_names);
  if (parts[0] == nullptr) return {};
  std::vector<Colour> colours(size_of(*parts[0]), no_colour);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = intensity_at(*parts[c], i);
      if (std::isnan(part)) continue;
      colours[i][c] = static_cast<std::uint8_t>(round_to_whole(std::clamp(part, 0.0, 1.0) * 255));
    }
  }
  return colours;
}

}  // namespace

Colour SurfaceColours::at(const Scene& scene, std::size_t sample, const Colour& plain) const {
  const RayHit& hit = scene.hit[sample];
  if (!of_triangles.empty()) return of_triangles[hit.triangle];
  if (of_vertices.empty()) return plain;
  const std::array<double, 3> weight = {1 - hit.u - hit.v, hit.u, hit.v};
  const Triangle& corner = (corners.empty() ? scene.mesh.triangles : corners)[hit.triangle];
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += weight[i] * of_vertices[corner[i]][c];
    colour[c] = static_cast<std::uint8_t>(round_to_whole(std::clamp(sum, 0.0, 255.0)));
  }
  return colour;
}

SurfaceColours colours_of(const Properties& properties) {
  SurfaceColours colours;
  colours.of_vertices = colours_of(properties.of_vertices);
  if (!colours.of_vertices.empty()) colours.corners = properties.corner_values;
  if (colours.of_vertices.empty()) colours.of_triangles = colours_of(properties.of_triangles);
  return colours;
}

}  // namespace geolloyd

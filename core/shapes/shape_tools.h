#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "core/mesh/mesh.h"
#include "geolloyd/errors.h"

namespace geolloyd {

// What the generators of shapes.h share.

/// The smallest f >= 1 with `base` f^2 >= `triangles`. Throws InvalidInput for 0 triangles, and
/// where the mesh would have more corners than 32-bit ids can count.
inline std::uint32_t smallest_frequency(std::size_t triangles, std::uint64_t base) {
  if (triangles == 0) throw InvalidInput("shape: 0 triangles asked for; ask for at least 1");
  if (triangles <= most_triangles) {
    const std::uint64_t square = triangles / base;
    auto f = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(square)));
    while (base * f * f < triangles) ++f;
    if (base * f * f <= most_triangles) return static_cast<std::uint32_t>(f);
  }
  throw InvalidInput("shape: " + std::to_string(triangles) +
                     " triangles need ids beyond 32 bits; ask for fewer than 1,400,000,000");
}

/// Adds the quadrilateral a b c d, counter-clockwise, as two triangles, cut along its shorter
/// diagonal.
inline void add_quad(Mesh& mesh, VertexId a, VertexId b, VertexId c, VertexId d) {
  const Vec3 ac = mesh.positions[c] - mesh.positions[a];
  const Vec3 bd = mesh.positions[d] - mesh.positions[b];
  if (dot(ac, ac) <= dot(bd, bd)) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  } else {
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({b, c, d});
  }
}

/// The nearest float32 values, by Veltkamp's splitting (Dekker, 1971): the upper 24 of the 53 bits.
/// Casting to float and back would say so plainly, but GCC 12 drops both casts where it vectorises.
inline Vec3 rounded_to_float(const Vec3& p) {
  const Vec3 scaled = p * (0x1p29 + 1);
  return scaled - (scaled - p);
}

}  // namespace geolloyd

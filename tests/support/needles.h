#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/mesh/mesh.h"

// Meshes of needles, as CAD kernels write them: exact, and hundreds of times longer than wide.
namespace geolloyd {

/// A plate of length 1 with `teeth` + 1 vertices along one side, all joined to one corner of the
/// other.
inline Mesh needle_plate(std::uint32_t teeth, double width) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= teeth; ++i) {
    mesh.positions.emplace_back(static_cast<double>(i) / teeth, 0, 0);
  }
  mesh.positions.emplace_back(1, width, 0);
  mesh.positions.emplace_back(0, width, 0);
  const std::uint32_t hub = teeth + 2;
  for (std::uint32_t i = 0; i < teeth; ++i) mesh.triangles.push_back({i, i + 1, hub});
  mesh.triangles.push_back({teeth, teeth + 1, hub});
  return mesh;
}

/// A closed cylinder of length 1 about the z axis, each of its sides one long rectangle.
inline Mesh needle_cylinder(std::uint32_t sides, double radius) {
  Mesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (const double z : {0.0, 1.0}) mesh.positions.emplace_back(0, 0, z);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    mesh.triangles.push_back({i, j, sides + j});
    mesh.triangles.push_back({i, sides + j, sides + i});
    mesh.triangles.push_back({j, i, 2 * sides});
    mesh.triangles.push_back({sides + i, sides + j, 2 * sides + 1});
  }
  return mesh;
}

/// Needles that share nothing: each is a part of its own.
inline Mesh loose_needles(std::uint32_t count) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double y = 0.01 * i;
    mesh.positions.emplace_back(0, y, 0);
    mesh.positions.emplace_back(1, y, 0);
    mesh.positions.emplace_back(1, y + 1e-5, 0);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace geolloyd

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/mesh/mesh.h"
#include "tests/support/odd_surfaces.h"

// Solids whose edges are sharp, and known.
namespace geolloyd {

/// Rings of `sides` points about the z axis, from a point below to a point above. `profile` holds
/// radius and height of each ring.
inline Mesh turned_solid(std::uint32_t sides, double bottom, double top,
                         const std::vector<std::pair<double, double>>& profile) {
  Mesh mesh;
  for (const auto& [radius, height] : profile) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  const auto below = static_cast<VertexId>(mesh.vertex_count());
  mesh.positions.emplace_back(0, 0, bottom);
  mesh.positions.emplace_back(0, 0, top);
  const auto last = static_cast<VertexId>(sides * (profile.size() - 1));
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    mesh.triangles.push_back({below, next, i});
    mesh.triangles.push_back({below + 1, last + i, last + next});
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
      const VertexId here = ring * sides;
      const VertexId above = here + sides;
      mesh.triangles.push_back({here + i, here + next, above + next});
      mesh.triangles.push_back({here + i, above + next, above + i});
    }
  }
  return mesh;
}

/// Height 2, radius 1. From many sides on, a cylinder with caps.
inline Mesh sharp_prism(std::uint32_t sides) {
  return turned_solid(sides, -1, 1, {{1, -1}, {1, 1}});
}

/// Height 2, radius 1; its side is smooth but for the tip.
inline Mesh sharp_cone(std::uint32_t sides) {
  return turned_solid(sides, 0, 2, {{1, 0}});
}

/// A square plate of side 2 with a round hole of so many corners, a multiple of 8, through its
/// middle.
inline Mesh pierced_plate(double radius, double thickness, std::uint32_t corners) {
  Mesh mesh;
  for (std::uint32_t ring = 0; ring < 4;
       ++ring) {  // below and above outside, above and below inside
    const double height = ring == 1 || ring == 2 ? thickness : 0;
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double reach = ring < 2 ? 1 / std::max(std::abs(x), std::abs(y)) : radius;
      mesh.positions.emplace_back(reach * x, reach * y, height);
    }
  }
  for (std::uint32_t ring = 0; ring < 4; ++ring) {
    const VertexId here = ring * corners;
    const VertexId beyond = (ring + 1) % 4 * corners;
    for (std::uint32_t i = 0; i < corners; ++i) {
      const std::uint32_t next = (i + 1) % corners;
      mesh.triangles.push_back({here + i, here + next, beyond + next});
      mesh.triangles.push_back({here + i, beyond + next, beyond + i});
    }
  }
  return mesh;
}

/// A triangular prism of length 1 whose two long faces meet at so many degrees.
inline Mesh sharp_wedge(double degrees) {
  const double half = degrees * std::numbers::pi / 360;
  Mesh mesh;
  for (const double y : {0.0, 1.0}) {
    mesh.positions.emplace_back(0, y, 0);
    mesh.positions.emplace_back(std::cos(half), y, -std::sin(half));
    mesh.positions.emplace_back(std::cos(half), y, std::sin(half));
  }
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                    {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
  return mesh;
}

}  // namespace geolloyd

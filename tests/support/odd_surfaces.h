#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh.h"
#include "core/shapes/shapes.h"

// Surfaces that are hard to remesh: thin, in many parts, with many holes, or no manifolds.
namespace geolloyd {

inline void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<VertexId>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const Triangle& t : more.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

inline Mesh scaled(Mesh mesh, const Vec3& factors) {
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(factors);
  return mesh;
}

inline Mesh moved(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

/// Unit square with a thickness; 12 triangles.
inline Mesh flat_box(double thickness) {
  Mesh mesh;
  for (const double z : {0.0, thickness}) {
    for (const double y : {0.0, 1.0}) {
      for (const double x : {0.0, 1.0}) mesh.positions.emplace_back(x, y, z);
    }
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A grid of `rows` x `columns` cells, the last joined to the first where it is closed that way;
/// `turned`: the last row upside down. `place` gets shares of 1.
template <class Place>
Mesh grid_surface(std::uint32_t rows, std::uint32_t columns, bool rows_close, bool columns_close,
                  bool turned, Place&& place) {
  const std::uint32_t across = columns_close ? columns : columns + 1;
  const std::uint32_t along = rows_close ? rows : rows + 1;
  Mesh mesh;
  for (std::uint32_t r = 0; r < along; ++r) {
    for (std::uint32_t c = 0; c < across; ++c) {
      mesh.positions.push_back(
          place(static_cast<double>(r) / rows, static_cast<double>(c) / columns));
    }
  }
  const auto at = [&](std::uint32_t r, std::uint32_t c) {
    if (rows_close && r == rows) return turned ? columns - c : c % across;
    return r * across + c % across;
  };
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      mesh.triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      mesh.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  }
  return mesh;
}

inline Vec3 on_ring(double turn, double radius, double z) {
  const double angle = 2 * std::numbers::pi * turn;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// About a circle of radius 1.
inline Mesh thin_torus(double radius, std::uint32_t sides = 8) {
  return grid_surface(400, sides, true, true, false, [&](double along, double around) {
    const double angle = 2 * std::numbers::pi * around;
    return on_ring(along, 1 + radius * std::cos(angle), radius * std::sin(angle));
  });
}

inline Mesh annulus(double inner_radius) {
  return grid_surface(400, 2, true, false, false, [&](double along, double across) {
    return on_ring(along, inner_radius + (1 - inner_radius) * across, 0);
  });
}

inline Mesh small_moebius_strip() {
  return grid_surface(120, 12, true, false, true, [](double along, double across) {
    const double angle = std::numbers::pi * along;
    const double side = 0.6 * (across - 0.5);
    return on_ring(along, 1 + side * std::cos(angle), side * std::sin(angle));
  });
}

/// A sphere and `count` small ones around it.
inline Mesh sphere_with_satellites(std::uint64_t count) {
  Mesh mesh = icosphere(2'000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double z = 2 * random_unit(7, 2 * i) - 1;
    const Vec3 middle = on_ring(static_cast<double>(i) / static_cast<double>(count),
                                1.3 * std::sqrt(1 - z * z), 1.3 * z);
    append(mesh, moved(scaled(icosphere(80), Vec3::Constant(0.03)), middle));
  }
  return mesh;
}

inline Mesh two_sheets(double distance) {
  Mesh mesh = irregular_plane(2'000, 1);
  append(mesh, moved(irregular_plane(2'000, 2), {0, 0, distance}));
  return mesh;
}

/// Holes of a triangle each, apart from each other and from the boundary.
inline Mesh plane_with_subresolution_holes(std::uint32_t count) {
  constexpr std::uint32_t cells = 100;
  constexpr std::uint32_t step = 6;
  Mesh mesh = grid_surface(cells, cells, false, false, false,
                           [](double y, double x) { return Vec3(x, y, 0); });
  std::vector<Triangle> kept;
  std::uint32_t holes = 0;
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::uint32_t row = t / 2 / cells;
    const std::uint32_t column = t / 2 % cells;
    const bool is_hole = t % 2 == 0 && row % step == 2 && column % step == 2 && holes < count;
    if (is_hole) {
      ++holes;
    } else {
      kept.push_back(mesh.triangles[t]);
    }
  }
  mesh.triangles = kept;
  return mesh;
}

/// A plane of `cells` x `cells`, cut open along `length` edges in its middle. The two sides of the
/// cut are in one place.
inline Mesh plane_with_slit(std::uint32_t cells, std::uint32_t length) {
  Mesh mesh = grid_surface(cells, cells, false, false, false,
                           [&](double y, double x) { return Vec3(cells * x, cells * y, 0); });
  const std::uint32_t first = cells / 2 * (cells + 1) + cells / 2 - length / 2;
  const auto copies = static_cast<VertexId>(mesh.vertex_count());
  for (std::uint32_t i = 1; i < length; ++i) {
    const Vec3 position = mesh.positions[first + i];
    mesh.positions.push_back(position);
  }
  for (std::size_t t = 2UL * cells * (cells / 2); t < mesh.triangle_count(); ++t) {  // above
    for (VertexId& v : mesh.triangles[t]) {
      if (v > first && v < first + length) v = copies + v - first - 1;
    }
  }
  return mesh;
}

/// A plane with fins on edges, which are no manifold edges then, and holes of a triangle, anywhere.
inline Mesh plane_with_fins_and_holes(std::uint32_t cells, std::uint32_t fins, std::uint32_t holes,
                                      std::uint64_t random_seed) {
  const auto next = [](std::uint64_t& state) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return state >> 33;
  };
  Mesh mesh = grid_surface(cells, cells, false, false, false,
                           [&](double y, double x) { return Vec3(cells * x, cells * y, 0); });
  for (std::size_t t = 0; t < mesh.triangle_count(); t += 2) {
    const VertexId a = mesh.triangles[t][0];
    const VertexId up = a + cells + 1;
    mesh.triangles[t] = {a, a + 1, up + 1};
    mesh.triangles[t + 1] = {a, up + 1, up};
  }
  const std::uint64_t flat = mesh.triangle_count();
  for (std::uint64_t state = random_seed; fins > 0; --fins) {
    const Triangle t = mesh.triangles[next(state) % flat];
    const std::uint64_t k = next(state) % 3;
    const Vec3 middle = (mesh.positions[t[k]] + mesh.positions[t[(k + 1) % 3]]) / 2;
    mesh.positions.emplace_back(middle + Vec3(0, 0, 0.5));
    mesh.triangles.push_back(
        {t[k], t[(k + 1) % 3], static_cast<VertexId>(mesh.vertex_count() - 1)});
  }
  std::vector<std::uint8_t> is_hole(mesh.triangle_count(), 0);
  for (std::uint64_t state = random_seed + 999; holes > 0; --holes) is_hole[next(state) % flat] = 1;
  Mesh kept{mesh.positions, {}};
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (is_hole[t] == 0) kept.triangles.push_back(mesh.triangles[t]);
  }
  return kept;
}

/// Three triangles that share an edge.
inline Mesh book() {
  return {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
}

/// Two triangles that share a vertex.
inline Mesh bow_tie() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
}

inline Mesh one_triangle() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

inline Mesh square_of_two_triangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

inline Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

}  // namespace geolloyd

#include "core/shapes/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/random.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shape_tools.h"

namespace geolloyd {
namespace {

struct Point2 {
  double x;
  double y;
};

// Uniform in [-1, 1).
double random_offset(std::uint64_t random_seed, std::uint64_t n) {
  return 2 * random_unit(random_seed, n) - 1;
}

// How far grid point `n` strays, in cells. Within a disc of radius less than 1/sqrt(8) no half of a
// cell can turn over, whichever way the cell is cut: a corner is 1/sqrt(2) away from the diagonal
// that it may have to cross, and both move. The factors under the roots map a square to the disc.
Point2 jitter(std::uint64_t random_seed, std::uint64_t n) {
  const double radius = 0.35;
  const double x = random_offset(random_seed, 2 * n);
  const double y = random_offset(random_seed, 2 * n + 1);
  return {radius * x * std::sqrt(1 - y * y / 2), radius * y * std::sqrt(1 - x * x / 2)};
}

// Cosine and sine of an angle given in turns. The library's own differ in the last bit from machine
// to machine; these Taylor series, of an angle of at most an eighth of a turn, do not.
Point2 on_unit_circle(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  const double angle = (4 * turns - quarters) * 1.5707963267948966;
  const double square = angle * angle;
  double cosine = 1;
  double sine = 1;
  for (int n = 18; n >= 2; n -= 2) {
    cosine = 1 - cosine * square / (n * (n - 1));
    sine = 1 - sine * square / (n * (n + 1));
  }
  sine *= angle;
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

// Its corners are those of three golden rectangles, one in each coordinate plane.
Mesh icosahedron() {
  const double a = std::sqrt((5 - std::sqrt(5.0)) / 10);
  const double b = std::sqrt((5 + std::sqrt(5.0)) / 10);
  Mesh mesh;
  mesh.positions = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                    {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

// Where a point of a face of the icosahedron goes on the sphere. Plain projection would spread the
// points near the middle of a face by half as much again as those near its corners. Blending the
// corners by the sines of their shares of the edge's arc, as spherical interpolation does along an
// edge, evens that out. A corner's share is linear in its dot product with the point, and at most 0
// for the corners that the face has not.
Vec3 spread_on_sphere(const Mesh& icosahedron, const Vec3& p) {
  const double neighbour_cosine = 1 / std::sqrt(5.0);
  const double edge_turns = 0.17620819117478337;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : icosahedron.positions) {
    const double share = (dot(p, corner) - neighbour_cosine) / (1 - neighbour_cosine);
    if (share > 0) sum += on_unit_circle(share * edge_turns).y * corner;
  }
  return normalized(sum);
}

}  // namespace

Mesh irregular_plane(std::size_t triangles, std::uint64_t random_seed) {
  const std::uint32_t cells = smallest_frequency(triangles, 2);
  const std::size_t points = std::size_t{cells} + 1;
  Mesh mesh;
  mesh.positions.reserve(points * points);
  for (std::uint32_t row = 0; row <= cells; ++row) {
    for (std::uint32_t column = 0; column <= cells; ++column) {
      Point2 offset = jitter(random_seed, row * points + column);
      if (column == 0 || column == cells) offset.x = 0;
      if (row == 0 || row == cells) offset.y = 0;
      mesh.positions.push_back(
          rounded_to_float({(column + offset.x) / cells, (row + offset.y) / cells, 0}));
    }
  }
  mesh.triangles.reserve(std::size_t{2} * cells * cells);
  const auto width = static_cast<VertexId>(points);
  for (std::uint32_t row = 0; row < cells; ++row) {
    for (VertexId a = row * width; a < row * width + cells; ++a) {
      add_quad(mesh, a, a + 1, a + 1 + width, a + width);
    }
  }
  return mesh;
}

Mesh icosphere(std::size_t triangles) {
  const Mesh base = icosahedron();
  Mesh mesh = refine(base, smallest_frequency(triangles, 20));
  for (Vec3& p : mesh.positions) p = rounded_to_float(spread_on_sphere(base, p));
  return mesh;
}

Mesh cube(std::size_t triangles) {
  Mesh box;
  for (const int z : {0, 1}) {
    for (const int y : {0, 1}) {
      for (const int x : {0, 1}) box.positions.emplace_back(x, y, z);
    }
  }
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  Mesh mesh = refine(box, smallest_frequency(triangles, 12));
  for (Vec3& p : mesh.positions) p = rounded_to_float(p);
  return mesh;
}

Mesh torus(std::size_t triangles, std::uint64_t random_seed) {
  const double large_radius = 1.0;
  const double small_radius = 0.4;
  // 5 f by 2 f cells are square on average. Two across, with f = 1, would not make a tube.
  const std::uint32_t f = std::max(2U, smallest_frequency(triangles, 20));
  const std::uint32_t around = 5 * f;
  const std::uint32_t across = 2 * f;
  Mesh mesh;
  mesh.positions.reserve(std::size_t{around} * across);
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const Point2 offset = jitter(random_seed, mesh.positions.size());
      const Point2 ring = on_unit_circle((i + offset.x) / around);
      const Point2 tube = on_unit_circle((j + offset.y) / across);
      const double reach = large_radius + small_radius * tube.x;
      mesh.positions.push_back(
          rounded_to_float({reach * ring.x, reach * ring.y, small_radius * tube.y}));
    }
  }
  mesh.triangles.reserve(std::size_t{2} * around * across);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t here = i * across;
    const std::uint32_t next = (i + 1) % around * across;
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t up = (j + 1) % across;
      add_quad(mesh, here + j, next + j, next + up, here + up);
    }
  }
  return mesh;
}

Mesh cylinder(std::size_t triangles, std::uint64_t random_seed) {
  // 3 f by f cells are nearly square. Three around, with f = 1, would not make a tube.
  const std::uint32_t f = std::max(2U, smallest_frequency(triangles, 6));
  const std::uint32_t around = 3 * f;
  Mesh mesh;
  mesh.positions.reserve(std::size_t{around} * (f + 1));
  for (std::uint32_t row = 0; row <= f; ++row) {
    for (std::uint32_t i = 0; i < around; ++i) {
      Point2 offset = jitter(random_seed, mesh.positions.size());
      if (row == 0 || row == f) offset.y = 0;
      const Point2 ring = on_unit_circle((i + offset.x) / around);
      mesh.positions.push_back(rounded_to_float({ring.x, ring.y, 2 * (row + offset.y) / f - 1}));
    }
  }
  mesh.triangles.reserve(std::size_t{2} * around * f);
  for (std::uint32_t row = 0; row < f; ++row) {
    const std::uint32_t here = row * around;
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t next = (i + 1) % around;
      add_quad(mesh, here + i, here + next, here + around + next, here + around + i);
    }
  }
  return mesh;
}

}  // namespace geolloyd

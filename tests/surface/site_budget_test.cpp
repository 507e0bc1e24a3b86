#include "core/surface/sites/site_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/shapes/shapes.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

struct BudgetedSurface {
  explicit BudgetedSurface(const Mesh& mesh, double spacing = 0.1, double longest_edge = 0)
      : input(surface_input_of(mesh, longest_edge)),
        divided(input, spacing, true),
        budgeter(divided) {}

  SurfaceInput input;
  DividedSurface divided;
  SiteBudgeter budgeter;
};

Mesh many_spheres(std::size_t count, double ratio = 1) {
  Mesh mesh;
  double radius = 0.4;
  for (std::size_t i = 0; i < count; ++i, radius *= ratio) {
    add_mesh(mesh, icosphere(80), {static_cast<double>(i % 8), static_cast<double>(i / 8), 0},
             radius);
  }
  return mesh;
}

TEST(SurfaceParts, AreThoseOfTheMesh) {
  Mesh mesh = icosphere(500);
  add_mesh(mesh, torus(500, 1), {4, 0, 0});
  add_mesh(mesh, cylinder(500, 1), {0, 4, 0});
  add_mesh(mesh, irregular_plane(500, 1), {0, 0, 4});
  Mesh punctured = icosphere(500);
  punctured.triangles.pop_back();
  add_mesh(mesh, punctured, {0, 0, -4});
  const BudgetedSurface surface(mesh, 0.06);
  ASSERT_EQ(surface.divided.curves.subresolution_holes.size(), 1U);
  std::vector<std::int64_t> closed;
  std::vector<std::int64_t> open;
  double area = 0;
  for (const Patch& part : surface.divided.patches.patches) {
    (part.is_closed ? closed : open).push_back(part.euler_characteristic);
    area += part.area;
  }
  std::sort(closed.begin(), closed.end());
  std::sort(open.begin(), open.end());
  EXPECT_EQ(closed, (std::vector<std::int64_t>{0, 2, 2}));
  EXPECT_EQ(open, (std::vector<std::int64_t>{0, 1}));
  EXPECT_NEAR(area, surface.input.fine.whole_area, 1e-12);
}

// A triangle of edge s covers sqrt(3) s^2 / 4, and V - E + F = 2 with 3 F = 2 E.
TEST(SiteBudget, CountsTheVerticesOfRegularTriangles) {
  const BudgetedSurface surface(icosphere(2000));
  for (const double spacing : {0.5, 0.2, 0.05}) {
    const double triangles = surface.input.fine.whole_area * 4 / std::sqrt(3) / (spacing * spacing);
    const SiteBudget budget = surface.budgeter.at_spacing(spacing);
    EXPECT_EQ(budget.on_curves, 0U);
    ASSERT_EQ(budget.free.size(), 1U);
    EXPECT_NEAR(static_cast<double>(budget.free[0]), triangles / 2 + 2, 0.5 + 1e-9);
    EXPECT_EQ(budget.total(), budget.free[0]);
    EXPECT_EQ(budget.spacing, spacing);
  }
}

// V = 1 + F / 2 + B / 2 with B edges on the boundary: the corners, and what lies between them.
TEST(SiteBudget, CountsTheBoundary) {
  const BudgetedSurface surface(irregular_plane(5000, 1), 0.2);
  const double spacing = 0.1;
  const SiteBudget budget = surface.budgeter.at_spacing(spacing);
  EXPECT_EQ(budget.on_curves, 80U);  // edges of length 2
  const double triangles = 4 * 4 / std::sqrt(3) / (spacing * spacing);
  EXPECT_NEAR(static_cast<double>(budget.total()), 1 + triangles / 2 + 40, 0.5 + 1e-9);
}

TEST(SiteBudget, OfSizeIsExact) {
  Mesh several = icosphere(300);
  add_mesh(several, torus(300, 1), {4, 0, 0});
  add_mesh(several, irregular_plane(300, 1), {0, 0, 4}, 0.3);
  add_mesh(several, cylinder(300, 1), {0, 5, 0}, 0.2);
  for (const Mesh& mesh : {icosphere(300), torus(300, 1), irregular_plane(300, 1), cylinder(300, 1),
                           creature(2000, 1), several}) {
    for (const std::size_t count : {64U, 65U, 99U, 100U, 517U, 2048U, 30000U, 123457U}) {
      const double share = 0.6 / std::sqrt(static_cast<double>(count));
      const BudgetedSurface surface(mesh, share, 0.2);
      const SiteBudget budget = surface.budgeter.of_size(count);
      EXPECT_EQ(budget.total(), count);
      EXPECT_EQ(budget.free.size(), surface.input.parts);
      EXPECT_GT(budget.spacing, 0);
    }
  }
}

// Every part has its share of the area.
TEST(SiteBudget, SharesByArea) {
  const BudgetedSurface surface(many_spheres(6, 0.7));
  const std::vector<Patch>& parts = surface.divided.patches.patches;
  const SiteBudget budget = surface.budgeter.of_size(5000);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const double share = parts[p].area / surface.input.fine.whole_area;
    EXPECT_NEAR(static_cast<double>(budget.free[p]), share * 5000, 4) << p;
  }
}

TEST(SiteBudget, OfManySmallParts) {
  const BudgetedSurface surface(many_spheres(50, 0.9));
  for (const std::size_t count : {200U, 201U, 250U, 1000U, 1024U, 5000U}) {
    const SiteBudget budget = surface.budgeter.of_size(count);
    EXPECT_EQ(budget.total(), count);
    EXPECT_GE(std::ranges::min(budget.free), 4U);
  }
  // The least possible.
  for (const std::size_t count : {4U, 100U, 199U}) {
    const SiteBudget budget = surface.budgeter.of_size(count);
    EXPECT_EQ(budget.free, std::vector<std::size_t>(50, 4));
  }
}

// What rounding leaves is shared among parts of equal size.
TEST(SiteBudget, SharesTheRest) {
  const BudgetedSurface surface(many_spheres(50));
  for (const std::size_t count : {999U, 1000U, 1001U, 1020U, 1049U, 5049U}) {
    const SiteBudget budget = surface.budgeter.of_size(count);
    EXPECT_EQ(budget.total(), count);
    EXPECT_LE(std::ranges::max(budget.free) - std::ranges::min(budget.free), 1U) << count;
  }
}

TEST(SiteBudget, GivesABoundaryItsLeast) {
  const BudgetedSurface disc(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 3);
  const SiteBudget budget = disc.budgeter.of_size(3);
  EXPECT_EQ(budget.on_curves, 3U);
  EXPECT_EQ(budget.total(), 3U);
  const BudgetedSurface tube(cylinder(500, 1), 0.5);
  EXPECT_GE(tube.budgeter.of_size(4).on_curves, 6U);
}

}  // namespace
}  // namespace geolloyd

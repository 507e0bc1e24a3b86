#include "core/surface/substrate/split_needles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/mesh_measure.h"
#include "tests/support/needles.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/surface.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

constexpr std::size_t enough = 1'000'000;

double whole_area_of(const Mesh& mesh) {
  const auto areas = triangle_areas(mesh, {});
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

struct NeedlesSplit {
  Mesh mesh;
  std::vector<TriangleId> origin;
  std::vector<std::array<VertexId, 2>> features;
};

NeedlesSplit split_up(const Mesh& mesh, double longest, std::size_t vertex_limit = enough,
                      const std::vector<TrianglePair>& features = {}) {
  NeedlesSplit result{mesh, {}, {}};
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) result.origin.push_back(t);
  EdgeSizes sizes;
  result.features =
      split_needles(result.mesh, result.origin, sizes, longest, vertex_limit, features);
  return result;
}

double longest_of(const Mesh& mesh) {
  double longest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto& p = mesh.positions;
    longest = std::max({longest, norm(p[a] - p[b]), norm(p[b] - p[c]), norm(p[c] - p[a])});
  }
  return longest;
}

// As many vertices as the area and the border need: on the border there are those given, inside
// triangles of longest edges would need 1.2 for the square of such an edge, right-angled ones of
// half that length up to 8.
TEST(SplitNeedles, NeedVerticesForTheAreaOnly) {
  for (const std::uint32_t teeth : {100U, 1000U, 10'000U}) {
    for (const double longest : {0.1, 0.02, 0.01}) {
      const Mesh plate = needle_plate(teeth, 0.1);
      const NeedlesSplit result = split_up(plate, longest);
      const std::size_t added = result.mesh.vertex_count() - plate.vertex_count();
      EXPECT_LE(static_cast<double>(added),
                2.2 / longest * 2 + 8 * 0.1 / (longest * longest) + 0.05 * teeth)
          << teeth << " " << longest;
      EXPECT_LE(longest_of(result.mesh), longest);
      EXPECT_NEAR(whole_area_of(result.mesh), 0.1, 1e-9);
      EXPECT_EQ(topology_of(result.mesh).parts, topology_of(plate).parts);
      EXPECT_TRUE(topology_of(result.mesh).is_manifold());
    }
  }
}

TEST(SplitNeedles, StayNearABentSurface) {
  constexpr double radius = 0.1;
  const Mesh cylinder = needle_cylinder(2000, radius);
  constexpr double longest = 0.02;
  const NeedlesSplit result = split_up(cylinder, longest);
  EXPECT_LE(longest_of(result.mesh), longest);
  EXPECT_LE(result.mesh.vertex_count(), cylinder.vertex_count() + 20'000);
  EXPECT_NEAR(whole_area_of(result.mesh), whole_area_of(cylinder), 0.01 * whole_area_of(cylinder));
  EXPECT_EQ(topology_of(result.mesh).parts, topology_of(cylinder).parts);
  for (const Triangle& t : result.mesh.triangles) {
    const auto& p = result.mesh.positions;
    const Vec3 middle = (p[t[0]] + p[t[1]] + p[t[2]]) / 3;
    const double from_axis = std::hypot(middle.x(), middle.y());
    const double off =
        std::min({std::abs(from_axis - radius), std::abs(middle.z()), std::abs(1 - middle.z())});
    EXPECT_LE(off, longest / 16);
  }
}

TEST(SplitNeedles, LeaveFeaturesWhereTheyAre) {
  constexpr std::uint32_t sides = 400;
  const Mesh cylinder = needle_cylinder(sides, 0.1);
  std::vector<TrianglePair> rims;
  for (TriangleId i = 0; i < sides; ++i) {
    rims.push_back({4 * i, 4 * i + 2});      // at z = 0
    rims.push_back({4 * i + 1, 4 * i + 3});  // at z = 1
  }
  std::sort(rims.begin(), rims.end());
  const NeedlesSplit result = split_up(cylinder, 0.05, enough, rims);
  double length = 0;
  for (const auto& [a, b] : result.features) {
    const Vec3& p = result.mesh.positions[a];
    const Vec3& q = result.mesh.positions[b];
    EXPECT_TRUE(p.z() == q.z() && (p.z() == 0 || p.z() == 1));
    length += norm(p - q);
  }
  const double rim = norm(cylinder.positions[0] - cylinder.positions[1]) * sides;
  EXPECT_NEAR(length, 2 * rim, 1e-9);
  EXPECT_EQ(result.features.size(), 2 * sides);
}

TEST(SplitNeedles, ObeyTheLimit) {
  const NeedlesSplit result = split_up(needle_plate(1000, 0.1), 0.001, 5000);
  EXPECT_EQ(result.mesh.vertex_count(), 5000U);
  EXPECT_TRUE(topology_of(result.mesh).is_manifold());
}

TEST(PiecesOfLongEdges, AreThoseOfEachEdge) {
  const Mesh mesh = square_of_two_triangles();
  EXPECT_NEAR(pieces_of_long_edges(mesh, {}, 0.1), 4 * 10 / 2.0 + std::sqrt(2.0) * 10, 1e-9);
  EXPECT_EQ(pieces_of_long_edges(mesh, {}, 2), 0);
  EXPECT_EQ(pieces_of_long_edges(mesh, {}, 0), 0);
}

}  // namespace
}  // namespace geolloyd

// What the generators of the zoo say of their parts is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "bench/zoo/changes.h"
#include "bench/zoo/judge.h"
#include "bench/zoo/kept_edges.h"
#include "bench/zoo/polygon.h"
#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"
#include "core/mesh/mesh_measure.h"
#include "core/repair/crossings.h"
#include "core/shapes/shapes.h"
#include "tests/support/walked_topology.h"

namespace geolloyd::zoo {
namespace {

TEST(Zoo, HasManyPartsOfManyKinds) {
  std::set<std::string> names;
  std::set<std::string> kinds;
  for (const Cage& cage : zoo()) {
    const Part part = cage.make();
    EXPECT_EQ(part.name, cage.name);
    EXPECT_EQ(part.kind, cage.kind);
    names.insert(part.name);
    kinds.insert(part.kind);
  }
  EXPECT_EQ(names.size(), zoo().size());
  EXPECT_GE(names.size(), 60U);
  EXPECT_GE(kinds.size(), 10U);
}

TEST(Zoo, HasTheTopologyThatItSays) {
  for (const Cage& cage : zoo()) {
    SCOPED_TRACE(cage.name);
    const Part part = cage.make();
    const Mesh mesh = welded(part);
    EXPECT_EQ(mesh.positions, part.mesh.positions);
    EXPECT_EQ(part.is_split, mesh.triangles != part.mesh.triangles);
    std::vector<std::array<std::int64_t, 2>> expected;
    for (const PartTopology& one : part.truth.parts) {
      expected.push_back({one.euler_characteristic, static_cast<std::int64_t>(one.boundary_loops)});
    }
    const MeshTopology found = find_topology(mesh);
    EXPECT_TRUE(found.is_manifold());
    EXPECT_EQ(found.inconsistent_edges, 0U);
    EXPECT_EQ(found.parts, part.truth.parts);
    if (part.is_split) continue;  // which leaves vertices without a triangle
    const WalkedTopology walked = walk_topology(mesh);
    EXPECT_EQ(walked.flaw, "");
    EXPECT_EQ(walked.parts, expected);
  }
}

// Formulas against triangles, of which none is missing, folded or without area.
TEST(Zoo, HasTheVolumeThatItSays) {
  for (const Cage& cage : zoo()) {
    SCOPED_TRACE(cage.name);
    const Part part = cage.make();
    EXPECT_GT(part.truth.volume, 0);
    EXPECT_NEAR(enclosed_volume(part.mesh) / part.truth.volume, 1, 1e-5);
    for (const auto& [a, b, c] : part.mesh.triangles) {
      const auto& p = part.mesh.positions;
      EXPECT_GT(flatness(p[a], p[b], p[c]), 1e-6);
    }
  }
}

// Large ones are left out: it takes quadratic time, and they are small ones with more triangles.
TEST(Zoo, DoesNotGoThroughItself) {
  constexpr std::size_t most_triangles = 8'000;
  for (const Cage& cage : zoo()) {
    const Mesh mesh = cage.make().mesh;
    if (mesh.triangle_count() > most_triangles) continue;
    EXPECT_TRUE(find_crossings(mesh).empty()) << cage.name;
  }
}

// Where its own mesh is taken for the remesh, however it is triangulated.
TEST(Zoo, KeepsItsOwnEdges) {
  for (const Cage& cage : zoo()) {
    SCOPED_TRACE(cage.name);
    const Part part = cage.make();
    const Mesh mesh = welded(part);
    const KeptEdges kept(part.truth, mesh, diagonal_of(mesh));
    EXPECT_EQ(kept.share().value_or(1), 1);
    EXPECT_GE(kept.least_on_rim().value_or(6), 6U);
    EXPECT_EQ(part.is_soft, part.is_soft && part.truth.sharp.empty());
  }
}

double length_of(const std::vector<SharpEdge>& edges) {
  double length = 0;
  for (const SharpEdge& edge : edges) length += norm(edge.ends[1] - edge.ends[0]);
  return length;
}

TEST(Truth, OfABoxIsItsEdges) {
  const Part box = part_of("box", "box", terraces(wall(rectangle({0, 0}, {3, 2}), 0, 1)));
  EXPECT_EQ(box.truth.sharp.size(), 12U);
  EXPECT_EQ(length_of(box.truth.sharp), 24);
  EXPECT_EQ(box.truth.forced_angle, 60);
  EXPECT_EQ(box.truth.volume, 6);
  for (const SharpEdge& edge : box.truth.sharp) {
    for (const Vec3& into : edge.into) {  // toward the middle
      const Vec3 middle = (edge.ends[0] + edge.ends[1]) / 2;
      EXPECT_GT(dot(into, Vec3(1.5, 1, 0.5) - middle), 0);
    }
  }
}

TEST(Truth, KnowsWhatCornersForce) {
  const Polygon thin = {{0, 0}, {1, 0}, {1, 0.1}};
  const Part wedge = part_of("wedge", "wedge", terraces(wall(thin, 0, 1)));
  EXPECT_NEAR(wedge.truth.forced_angle, 5.7106, 1e-4);
  const Part spike = part_of("spike", "spike", turned({{{0, 0}, {0.1, 0}, {0, 3}}, 400}));
  EXPECT_NEAR(spike.truth.forced_angle, 120 * 0.1 / 3.00167, 0.01);
}

TEST(Truth, IsLostWithTheEdges) {
  const Part box = part_of("box", "box", terraces(wall(rectangle({0, 0}, {3, 2}), 0, 1)));
  const Mesh ball = icosphere(5'000);
  const std::optional<double> share = KeptEdges(box.truth, ball, 3.74).share();
  ASSERT_TRUE(share.has_value());
  EXPECT_LT(*share, 0.1);
}

TEST(Crossings, AreFound) {
  const Solid box = terraces(wall(rectangle({0, 0}, {1, 1}), 0, 1));
  EXPECT_TRUE(find_crossings(together({box, moved(box, {2, 0, 0})}).mesh).empty());
  EXPECT_FALSE(find_crossings(together({box, moved(box, {0.5, 0.4, 0.3})}).mesh).empty());
}

TEST(Polygons, AreCoveredByTheirTriangles) {
  const std::vector<Polygon> polygons = {rectangle({0, 0}, {4, 4}), circle({1, 1}, 0.5, 7),
                                         circle({3, 1}, 0.5, 8), circle({2, 3}, 0.9, 40)};
  double area = area_of(polygons[0]);
  std::vector<Point> points = polygons[0];
  for (std::size_t k = 1; k < polygons.size(); ++k) {
    area -= area_of(polygons[k]);
    points.insert(points.end(), polygons[k].begin(), polygons[k].end());
  }
  double sum = 0;
  for (const auto& [a, b, c] : triangulated(polygons)) {
    const double one = area_of({points[a], points[b], points[c]});
    EXPECT_GT(one, 0);
    sum += one;
  }
  EXPECT_NEAR(sum, area, 1e-12);
}

}  // namespace
}  // namespace geolloyd::zoo

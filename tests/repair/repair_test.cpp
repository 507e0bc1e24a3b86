// One mesh per flaw, with what the repair must make of it; then all flaws at once, and at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/repair/crossings.h"
#include "core/seams/cut_apart.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "geolloyd/repair.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/topology.h"
#include "tests/support/walked_topology.h"

namespace geolloyd {
namespace {

using Parts = std::vector<PartTopology>;

constexpr RepairOptions no_holes{0, 0};

RepairOptions holes_of(std::size_t edges) {
  return {edges, 0};
}

void expect_same(const Mesh& made, const Mesh& wanted) {
  EXPECT_EQ(made.triangles, wanted.triangles);
  ASSERT_EQ(made.vertex_count(), wanted.vertex_count());
  for (std::size_t v = 0; v < made.vertex_count(); ++v) {
    EXPECT_EQ(made.positions[v], wanted.positions[v]);
  }
}

// What holds of every result: a manifold without repeated triangles and unused vertices, each
// vertex where its origin was.
void expect_sound(const RepairedMesh& made, const Mesh& input) {
  EXPECT_EQ(walk_topology(made.mesh).flaw, "");
  EXPECT_TRUE(topology_of(made.mesh).is_manifold());
  ASSERT_EQ(made.vertex_origin.size(), made.mesh.vertex_count());
  for (std::size_t v = 0; v < made.vertex_origin.size(); ++v) {
    ASSERT_LT(made.vertex_origin[v], input.vertex_count());
    EXPECT_EQ(made.mesh.positions[v], input.positions[made.vertex_origin[v]]);
  }
  ASSERT_EQ(made.triangle_origin.size(), made.mesh.triangle_count());
  std::size_t added = 0;
  for (std::size_t t = 0; t < made.triangle_origin.size(); ++t) {
    const TriangleId origin = made.triangle_origin[t];
    added += origin == no_id ? 1 : 0;
    if (origin == no_id) continue;
    ASSERT_LT(origin, input.triangle_count());
    EXPECT_TRUE(t == 0 || made.triangle_origin[t - 1] < origin);
  }
  EXPECT_EQ(added, made.repairs.triangles_added);
  const std::vector<std::uint8_t> used = referenced_vertices(made.mesh);
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
}

RepairedMesh repaired(const Mesh& mesh, const RepairOptions& options = {}) {
  RepairedMesh made = repair(mesh, options, reference_runtime());
  expect_sound(made, mesh);
  return made;
}

// Each triangle with vertices of its own.
Mesh soup_of(const Mesh& mesh) {
  Mesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<VertexId>(soup.vertex_count());
    for (const VertexId v : t) soup.positions.push_back(mesh.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

Mesh without_triangles(Mesh mesh, const std::set<TriangleId>& gone) {
  std::vector<Triangle> kept;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (!gone.contains(t)) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = kept;
  return mesh;
}

void turn(Triangle& t) {
  std::swap(t[1], t[2]);
}

TEST(Repair, LeavesACleanMeshAsItIs) {
  for (const Mesh& mesh : {icosphere(1'000), creature(5'000, 1), torus(1'000, 1), cube(500),
                           irregular_plane(200, 1), cylinder(500, 1), one_triangle(), flat_box(1),
                           sphere_with_satellites(3), plane_with_subresolution_holes(0)}) {
    const RepairedMesh made = repaired(mesh);
    EXPECT_FALSE(made.repairs.any());
    expect_same(made.mesh, mesh);
  }
}

TEST(Repair, LeavesOutDuplicates) {
  Mesh mesh = tetrahedron();
  const Triangle t = mesh.triangles[1];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back({t[1], t[0], t[2]});
  mesh.triangles.push_back({t[1], t[1], t[2]});
  mesh.positions.emplace_back(5, 5, 5);
  const RepairedMesh made = repaired(mesh);
  EXPECT_EQ(made.repairs.duplicate_triangles, 2U);
  EXPECT_EQ(made.repairs.repeated_vertex_triangles, 1U);
  EXPECT_EQ(made.repairs.unused_vertices, 1U);
  expect_same(made.mesh, tetrahedron());
}

TEST(Repair, LeavesOutCopiesInTheSamePlaces) {
  for (const bool is_reversed : {false, true}) {
    Mesh mesh = icosphere(80);
    Mesh copy = mesh;
    if (is_reversed) {
      for (Triangle& t : copy.triangles) turn(t);
    }
    append(mesh, copy);
    const RepairedMesh made = repaired(mesh);
    EXPECT_EQ(made.repairs.duplicate_triangles, 80U);
    expect_same(made.mesh, icosphere(80));
  }
}

// A cover of both sides is a closed surface, thin as it is.
TEST(Repair, KeepsBothSidesOfAFlatSurface) {
  const Mesh mesh = flat_box(0);
  const RepairedMesh made = repaired(mesh, no_holes);
  EXPECT_EQ(topology_of(made.mesh).parts, (Parts{{2, 0}}));
  EXPECT_EQ(made.repairs.duplicate_triangles, 0U);
}

TEST(Repair, MergesASoup) {
  for (const Mesh& mesh : {icosphere(300), creature(2'000, 2), irregular_plane(200, 1),
                           small_moebius_strip(), torus(500, 3)}) {
    const RepairedMesh made = repaired(soup_of(mesh));
    EXPECT_EQ(topology_of(made.mesh).parts, topology_of(mesh).parts);
    EXPECT_EQ(made.mesh.vertex_count(), mesh.vertex_count());
    EXPECT_EQ(made.repairs.vertices_merged, 3 * mesh.triangle_count() - mesh.vertex_count());
    EXPECT_EQ(made.repairs.vertices_cut, 0U);
  }
}

// What touches but is closed stays apart.
TEST(Repair, DoesNotMergeClosedSurfaces) {
  Mesh mesh = cube(12);
  append(mesh, moved(cube(12), {1, 0, 0}));
  const RepairedMesh made = repaired(mesh);
  EXPECT_FALSE(made.repairs.any());
}

TEST(Repair, CutsABowTie) {
  const RepairedMesh made = repaired(bow_tie());
  EXPECT_EQ(made.repairs.vertices_cut, 1U);
  EXPECT_EQ(made.repairs.vertices_merged, 0U);
  EXPECT_EQ(made.mesh.vertex_count(), 6U);
  EXPECT_EQ(made.vertex_origin, (std::vector<VertexId>{0, 1, 2, 3, 4, 0}));
}

TEST(Repair, CutsABook) {
  const RepairedMesh made = repaired(book());
  EXPECT_EQ(made.repairs.vertices_cut, 2U);
  EXPECT_EQ(made.mesh.vertex_count(), 9U);
  EXPECT_EQ(topology_of(made.mesh).parts, (Parts{{1, 1}, {1, 1}, {1, 1}}));
}

// Two cubes that share a chain of two edges become two closed cubes.
TEST(Repair, PartsSolidsThatTouchAlongAChainOfEdges) {
  Mesh mesh = cube(48);
  append(mesh, moved(cube(48), {1, 1, 0}));
  std::vector<VertexId> name(mesh.vertex_count());
  for (VertexId v = 0; v < name.size(); ++v) {
    name[v] = v;
    for (VertexId u = 0; u < v; ++u) {
      if (mesh.positions[u] == mesh.positions[v]) name[v] = u;
    }
  }
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = name[v];
  }
  ASSERT_EQ(topology_of(mesh).non_manifold_edges, 2U);
  const RepairedMesh made = repaired(mesh);
  EXPECT_EQ(topology_of(made.mesh).parts, (Parts{{2, 0}, {2, 0}}));
  EXPECT_EQ(made.repairs.vertices_cut, 3U);
  EXPECT_EQ(made.repairs.unused_vertices, 3U);
}

TEST(Repair, TurnsClosedSurfacesOutward) {
  for (const bool most : {false, true}) {
    Mesh mesh = icosphere(320);
    for (TriangleId t = 0; t < 320; ++t) {
      if (most ? t % 4 != 0 : t % 4 == 0) turn(mesh.triangles[t]);
    }
    const RepairedMesh made = repaired(mesh);
    EXPECT_EQ(made.repairs.triangles_turned, most ? 240U : 80U);
    expect_same(made.mesh, icosphere(320));
  }
}

// The inside of a hollow body is oriented as it should be.
TEST(Repair, LeavesWholeSurfacesThatAreTurnedInward) {
  Mesh mesh = icosphere(80);
  for (Triangle& t : mesh.triangles) turn(t);
  EXPECT_FALSE(repaired(mesh).repairs.any());
}

TEST(Repair, TurnsOpenSurfacesAsMostOfTheirAreaIs) {
  Mesh mesh = irregular_plane(200, 1);
  for (TriangleId t = 0; t < 150; ++t) turn(mesh.triangles[t]);
  const RepairedMesh made = repaired(mesh, no_holes);
  EXPECT_EQ(made.repairs.triangles_turned, 50U);
  EXPECT_EQ(topology_of(made.mesh).inconsistent_edges, 0U);
}

TEST(Repair, LeavesAMoebiusStrip) {
  const Mesh mesh = small_moebius_strip();
  const RepairedMesh made = repaired(mesh);
  EXPECT_EQ(made.repairs.unorientable_components, 1U);
  EXPECT_FALSE(made.repairs.any());
  expect_same(made.mesh, mesh);
}

TEST(Repair, CollapsesEdgesWithoutLength) {
  Mesh mesh = icosphere(80);
  // Vertex 0 becomes two in the same place, with two triangles between them.
  std::vector<TriangleId> at;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const Triangle& c = mesh.triangles[t];
    if (c[0] == 0 || c[1] == 0 || c[2] == 0) at.push_back(t);
  }
  const auto twin = static_cast<VertexId>(mesh.vertex_count());
  const Vec3 place = mesh.positions[0];
  mesh.positions.push_back(place);
  const auto next = [&](TriangleId t) {
    const Triangle& c = mesh.triangles[t];
    return c[0] == 0 ? c[1] : c[1] == 0 ? c[2] : c[0];
  };
  const auto last = [&](TriangleId t) {
    const Triangle& c = mesh.triangles[t];
    return c[0] == 0 ? c[2] : c[1] == 0 ? c[0] : c[1];
  };
  const TriangleId first = at[0];
  const TriangleId second =
      *std::find_if(at.begin(), at.end(), [&](TriangleId t) { return next(t) == last(first); });
  const VertexId a = next(first);
  const VertexId b = last(second);
  for (const TriangleId t : {first, second}) {
    std::replace(mesh.triangles[t].begin(), mesh.triangles[t].end(), VertexId{0}, twin);
  }
  mesh.triangles.push_back({twin, 0, a});
  mesh.triangles.push_back({0, twin, b});
  ASSERT_EQ(topology_of(mesh).parts, (Parts{{2, 0}}));
  ASSERT_EQ(topology_of(mesh).inconsistent_edges, 0U);
  const RepairedMesh made = repaired(mesh);
  EXPECT_EQ(made.repairs.slivers_removed, 2U);
  EXPECT_EQ(made.repairs.slivers_left, 0U);
  EXPECT_EQ(topology_of(made.mesh), topology_of(icosphere(80)));
  EXPECT_EQ(made.mesh.vertex_count(), 42U);
  EXPECT_EQ(enclosed_volume(made.mesh), enclosed_volume(icosphere(80)));
}

// A cap: its third vertex is on its longest edge.
TEST(Repair, FlipsLongEdgesOfCaps) {
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}},
                     {{0, 1, 3}, {0, 2, 1}, {0, 4, 2}, {2, 4, 1}}};
  const RepairedMesh made = repaired(mesh);
  EXPECT_EQ(made.repairs.slivers_removed, 1U);
  EXPECT_EQ(made.mesh.triangle_count(), 4U);
  double area = 0;
  for (const Triangle& t : made.mesh.triangles) {
    EXPECT_GT(triangle_area(made.mesh, t), 0.2);
    area += triangle_area(made.mesh, t);
  }
  EXPECT_NEAR(area, 1, 1e-15);
  EXPECT_EQ(topology_of(made.mesh), topology_of(mesh));
}

TEST(Repair, LeavesOutSliversOfTheBoundary) {
  Mesh mesh = square_of_two_triangles();
  mesh.positions.emplace_back(2, 0, 0);
  mesh.triangles.push_back({0, 4, 1});
  const RepairedMesh made = repaired(mesh);
  EXPECT_EQ(made.repairs.slivers_removed, 1U);
  expect_same(made.mesh, square_of_two_triangles());
}

TEST(Repair, LeavesAMeshOfSliversAlone) {
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  const RepairedMesh made = repair(mesh, {}, reference_runtime());
  EXPECT_EQ(made.mesh.triangle_count(), 1U);
  EXPECT_EQ(made.repairs.slivers_left, 1U);
}

TEST(Repair, FillsHolesUpToASize) {
  // The triangles around a vertex: a hole of five or six edges.
  const Mesh whole = icosphere(1'280);
  std::set<TriangleId> gone;
  for (TriangleId t = 0; t < whole.triangle_count(); ++t) {
    for (const VertexId v : whole.triangles[t]) {
      if (v == 0 || v == 100) gone.insert(t);
    }
  }
  gone.insert(700);
  const Mesh mesh = without_triangles(whole, gone);
  ASSERT_EQ(topology_of(mesh).parts, (Parts{{-1, 3}}));
  EXPECT_EQ(topology_of(repaired(mesh, no_holes).mesh).parts, (Parts{{-1, 3}}));
  EXPECT_EQ(repaired(mesh, holes_of(3)).repairs.holes_filled, 1U);
  EXPECT_EQ(repaired(mesh, holes_of(5)).repairs.holes_filled, 2U);
  const RepairedMesh made = repaired(mesh, holes_of(6));
  EXPECT_EQ(made.repairs.holes_filled, 3U);
  EXPECT_EQ(made.repairs.triangles_added, 1U + 3 + 4);
  EXPECT_EQ(made.repairs.unused_vertices, 2U);
  const MeshTopology topology = topology_of(made.mesh);
  EXPECT_EQ(topology.parts, (Parts{{2, 0}}));
  EXPECT_EQ(topology.inconsistent_edges, 0U);
  EXPECT_NEAR(enclosed_volume(made.mesh), enclosed_volume(whole), 0.01);
}

TEST(Repair, FillsHolesByTheirLength) {
  const Mesh mesh = without_triangles(icosphere(1'280), {700});
  const double diagonal = std::sqrt(12.0);
  double length = 0;
  const Mesh whole = icosphere(1'280);
  for (std::size_t c = 0; c < 3; ++c) {
    const Triangle& t = whole.triangles[700];
    length += (whole.positions[t[c]] - whole.positions[t[(c + 1) % 3]]).norm();
  }
  EXPECT_EQ(repaired(mesh, {0, 0.99 * length / diagonal}).repairs.holes_filled, 0U);
  EXPECT_EQ(repaired(mesh, {0, 1.02 * length / diagonal}).repairs.holes_filled, 1U);
}

// No triangle of the filling faces against the sphere.
TEST(Repair, FillsALargeHoleWithoutAFold) {
  const Mesh whole = icosphere(20'000);
  Mesh mesh;
  mesh.positions = whole.positions;
  for (const Triangle& t : whole.triangles) {
    if (barycentre(whole, static_cast<TriangleId>(&t - whole.triangles.data())).z() < 0.6) {
      mesh.triangles.push_back(t);
    }
  }
  const RepairedMesh made = repaired(mesh, holes_of(100'000));
  EXPECT_EQ(made.repairs.holes_filled, 1U);
  EXPECT_EQ(topology_of(made.mesh).parts, (Parts{{2, 0}}));
  EXPECT_EQ(topology_of(made.mesh).inconsistent_edges, 0U);
  for (std::size_t t = mesh.triangle_count(); t < made.mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = made.mesh.triangles[t];
    const std::vector<Vec3>& p = made.mesh.positions;
    EXPECT_GT(cross(p[b] - p[a], p[c] - p[a]).z(), 0);
  }
}

// A sphere without its top, and what stands in the hole: `obstacle`.
Mesh open_sphere_and(const Mesh& obstacle) {
  const Mesh whole = icosphere(1'280);
  std::set<TriangleId> top;
  for (TriangleId t = 0; t < whole.triangle_count(); ++t) {
    if (barycentre(whole, t).z() > 0.8) top.insert(t);
  }
  Mesh mesh = without_triangles(whole, top);
  append(mesh, obstacle);
  return mesh;
}

TEST(Repair, FillsNoHoleThroughTheSurface) {
  const RepairedMesh alone = repaired(open_sphere_and({}), holes_of(100));
  EXPECT_EQ(alone.repairs.holes_filled, 1U);
  Mesh small = icosphere(80);
  for (Vec3& p : small.positions) p = 0.2 * p + Vec3(0, 0, 0.8);
  const RepairedMesh made = repaired(open_sphere_and(small), holes_of(100));
  EXPECT_EQ(made.repairs.holes_filled, 0U);
  EXPECT_EQ(made.repairs.holes_left, 1U);
  for (Vec3& p : small.positions) p.z() -= 0.8;
  EXPECT_EQ(repaired(open_sphere_and(small), holes_of(100)).repairs.holes_filled, 1U);
}

// Four walls of a box without a lid, whose diagonals are equally good: the first is taken.
Mesh box_without_lid() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},   {0, 1, 0},
                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1.2}, {0, 1, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                    {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return mesh;
}

// From inside that box up to a tip in the middle of it.
Mesh needle_up_to(double height) {
  Mesh needle;
  needle.positions = {{0.5, 0.5, height}, {0.49, 0.5, 0.5}, {0.51, 0.49, 0.5}, {0.51, 0.51, 0.5}};
  needle.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return needle;
}

// Both lids of four corners, at 1 and 1.1 in the middle.
TEST(Repair, LeavesAHoleThatEachFillingWouldPassThroughTheSurface) {
  const auto filled_with = [](double height) {
    Mesh mesh = box_without_lid();
    append(mesh, needle_up_to(height));
    const RepairedMesh made = repaired(mesh, holes_of(4));
    EXPECT_EQ(made.repairs.holes_filled + made.repairs.holes_left, 1U);
    EXPECT_TRUE(find_crossings(made.mesh).empty());
    return made.repairs.holes_filled;
  };
  EXPECT_EQ(filled_with(0.9), 1U);
  EXPECT_EQ(filled_with(1), 1U);  // at the lower lid
  EXPECT_EQ(filled_with(1.05), 1U);
  EXPECT_EQ(filled_with(1.2), 0U);
  EXPECT_EQ(filled_with(2), 0U);
}

// A thin spike through the flattest filling: there is room for another one beside it.
TEST(Repair, FillsAHoleAroundWhatIsInTheWay) {
  Mesh mesh = box_without_lid();
  const RepairedMesh alone = repaired(mesh, holes_of(4));
  ASSERT_EQ(alone.repairs.holes_filled, 1U);
  const auto lid = [](const RepairedMesh& made) {
    const auto& all = made.mesh.triangles;
    std::set<std::set<VertexId>> found;
    for (std::size_t t = 0; t < all.size(); ++t) {
      if (made.triangle_origin[t] == no_id) found.insert({all[t].begin(), all[t].end()});
    }
    return found;
  };
  // A needle that ends between the two possible diagonals, in the middle of the lid.
  Mesh needle = tetrahedron();
  const bool is_high = lid(alone).contains(std::set<VertexId>{4, 5, 6}) ||
                       lid(alone).contains(std::set<VertexId>{4, 6, 7});
  for (Vec3& p : needle.positions) p = 0.01 * p + Vec3(0.5, 0.5, is_high ? 1.1 : 1.0);
  append(mesh, needle);
  const RepairedMesh made = repaired(mesh, holes_of(4));
  EXPECT_EQ(made.repairs.holes_filled, 1U);
  EXPECT_NE(lid(made), lid(alone));
}

TEST(Repair, FillsHolesThatShareAVertex) {
  const Mesh whole = icosphere(320);
  const VertexId shared = whole.triangles[5][0];
  std::set<TriangleId> gone = {5};
  for (TriangleId t = 0; t < whole.triangle_count(); ++t) {
    const Triangle& c = whole.triangles[t];
    const bool touches = std::find(c.begin(), c.end(), shared) != c.end();
    const auto common = std::count_if(c.begin(), c.end(), [&](VertexId v) {
      const Triangle& first = whole.triangles[5];
      return std::find(first.begin(), first.end(), v) != first.end();
    });
    if (touches && common == 1 && gone.size() < 2) gone.insert(t);
  }
  ASSERT_EQ(gone.size(), 2U);
  const Mesh mesh = without_triangles(whole, gone);
  ASSERT_EQ(topology_of(mesh).non_manifold_vertices, 1U);
  const RepairedMesh made = repaired(mesh, holes_of(3));
  EXPECT_EQ(made.repairs.holes_filled, 2U);
  EXPECT_EQ(made.repairs.triangles_added, 2U);
  EXPECT_EQ(made.repairs.vertices_cut, 0U);
  EXPECT_EQ(made.mesh.vertex_count(), whole.vertex_count());
  EXPECT_EQ(topology_of(made.mesh), topology_of(whole));
}

// A filling would lie on the surface itself.
TEST(Repair, DoesNotCloseFlatSheets) {
  const RepairedMesh made = repaired(irregular_plane(200, 1), holes_of(1'000));
  EXPECT_EQ(made.repairs.holes_filled, 0U);
  EXPECT_EQ(made.repairs.holes_left, 1U);
  const RepairedMesh single = repaired(one_triangle(), holes_of(3));
  EXPECT_EQ(single.repairs.holes_left, 1U);
}

TEST(Repair, RefusesWhatMakesNoSense) {
  Mesh broken = one_triangle();
  broken.triangles[0][2] = 7;
  EXPECT_THROW(repair(broken, {}, reference_runtime()), InvalidInput);
  broken = one_triangle();
  broken.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(repair(broken, {}, reference_runtime()), InvalidInput);
  EXPECT_THROW(repair(Mesh{}, {}, reference_runtime()), InvalidInput);
  EXPECT_THROW(repair(one_triangle(), {0, -1}, reference_runtime()), InvalidInput);
  EXPECT_THROW(
      repair(one_triangle(), {0, std::numeric_limits<double>::infinity()}, reference_runtime()),
      InvalidInput);
}

TEST(Repair, GivesACreatureBackThatHasAllFlaws) {
  const Mesh whole = creature(4'000, 3);
  Mesh mesh = without_triangles(whole, {1'000, 2'000});
  for (TriangleId t = 0; t < 300; ++t) turn(mesh.triangles[7 * t]);  // orientations
  for (TriangleId t = 0; t < 50; ++t) {                              // duplicates
    const Triangle& c = mesh.triangles[11 * t];
    const Triangle copy = {c[1], c[0], c[2]};
    mesh.triangles.push_back(copy);
  }
  for (TriangleId t = 500; t < 900; ++t) {  // cracks
    for (VertexId& v : mesh.triangles[t]) {
      const Vec3 place = mesh.positions[v];
      v = static_cast<VertexId>(mesh.vertex_count());
      mesh.positions.push_back(place);
    }
  }
  mesh.triangles.push_back({3, 3, 4});
  mesh.positions.emplace_back(9, 9, 9);
  const RepairedMesh made = repaired(mesh, holes_of(3));
  EXPECT_EQ(topology_of(made.mesh), topology_of(whole));
  EXPECT_EQ(made.mesh.vertex_count(), whole.vertex_count());
  EXPECT_EQ(made.mesh.triangle_count(), whole.triangle_count());
  EXPECT_EQ(made.repairs.holes_filled, 2U);
  EXPECT_EQ(made.repairs.slivers_left, 0U);
  EXPECT_NEAR(enclosed_volume(made.mesh) / enclosed_volume(whole), 1, 1e-12);
}

// Soups on few places have every flaw there is. What comes out is a manifold with no more loops
// than the input cut apart has.
TEST(Repair, MakesManifoldsOfRandomSoups) {
  for (std::uint64_t trial = 0; trial < 2'000; ++trial) {
    std::uint64_t n = 0;
    const auto draw = [&](std::uint64_t below) {
      return static_cast<std::uint32_t>(random_unit(trial, n++) * static_cast<double>(below));
    };
    Mesh mesh;
    const std::uint32_t vertices = 4 + draw(12);
    const std::uint32_t side = 2 + draw(2);
    for (std::uint32_t v = 0; v < vertices; ++v) {
      const auto x = draw(side);
      const auto y = draw(side);
      mesh.positions.emplace_back(x, y, draw(side));
    }
    const std::uint32_t triangles = 1 + draw(24);
    for (std::uint32_t t = 0; t < triangles; ++t) {
      const VertexId a = draw(vertices);
      const VertexId b = draw(vertices);
      mesh.triangles.push_back({a, b, draw(vertices)});
    }
    const MeshEdges edges = find_edges(mesh);
    Mesh cut = mesh;
    cut.triangles.clear();
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      const bool is_copy = std::binary_search(edges.duplicates.begin(), edges.duplicates.end(), t);
      if (!is_copy && has_three_vertices(mesh.triangles[t]))
        cut.triangles.push_back(mesh.triangles[t]);
    }
    cut_apart(cut);
    const std::size_t loops = topology_of(cut).total().boundary_loops;
    const RepairedMesh made = repaired(mesh, holes_of(trial % 8));
    EXPECT_LE(topology_of(made.mesh).total().boundary_loops, loops) << trial;
    if (made.repairs.unorientable_components == 0) {
      EXPECT_EQ(topology_of(made.mesh).inconsistent_edges, 0U) << trial;
    }
    if (HasFailure()) FAIL() << trial;
  }
}

// None of these is quadratic.
TEST(Repair, WorksNearLinearly) {
  constexpr VertexId many = 30'000;
  Mesh hub;
  hub.positions.emplace_back(0, 0, 1);
  for (VertexId i = 0; i < many; ++i) hub.positions.push_back(on_ring(double(i) / many, 1, 0));
  for (VertexId i = 0; i < many; ++i) hub.triangles.push_back({0, i + 1, (i + 1) % many + 1});
  EXPECT_EQ(repair(hub, {}, reference_runtime()).repairs.holes_filled, 0U);  // too long
  EXPECT_EQ(topology_of(repair(soup_of(hub), {}, reference_runtime()).mesh), topology_of(hub));

  Mesh copies;
  copies.positions = one_triangle().positions;
  copies.triangles.assign(many, {0, 1, 2});
  EXPECT_EQ(repair(copies, {}, reference_runtime()).repairs.duplicate_triangles, many - 1U);
  EXPECT_EQ(repair(soup_of(copies), {}, reference_runtime()).repairs.duplicate_triangles,
            many - 1U);

  Mesh slivers = hub;
  for (VertexId i = 1; i <= many; ++i) slivers.positions[i] = Vec3(1, 0, 0);
  slivers.positions[1] = Vec3(0, 1, 0);
  EXPECT_EQ(walk_topology(repair(slivers, {}, reference_runtime()).mesh).flaw, "");
}

}  // namespace
}  // namespace geolloyd

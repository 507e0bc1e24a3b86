#include "core/surface/substrate/surface_input.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "core/mesh/mesh_measure.h"
#include "core/mesh/spatial_order.h"
#include "core/shapes/shapes.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

using Edge = std::array<VertexId, 2>;

std::map<Edge, int> triangles_of_edges(const FineMesh& fine) {
  std::map<Edge, int> count;
  for (const Triangle& t : fine.triangles) {
    for (std::size_t c = 0; c < 3; ++c) ++count[ascending(t[c], t[(c + 1) % 3])];
  }
  return count;
}

// Every triangle of the mesh that counts is there, where it was and as it was.
void expect_same_triangles(const Mesh& mesh, const SurfaceInput& input) {
  const std::vector<TriangleId> duplicates = find_edges(mesh).duplicates;
  std::vector<TriangleId> expected;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (has_three_vertices(mesh.triangles[t]) && std::ranges::count(duplicates, t) == 0) {
      expected.push_back(t);
    }
  }
  std::vector<TriangleId> origin = input.origin;
  std::sort(origin.begin(), origin.end());
  EXPECT_EQ(origin, expected);
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const VertexId original = mesh.triangles[input.origin[t]][c];
      EXPECT_EQ(input.fine.positions[input.fine.triangles[t][c]],
                input.frame.to_unit(mesh.positions[original]));
    }
  }
}

// What holds whatever the mesh.
void expect_surface(const SurfaceInput& input) {
  const FineMesh& fine = input.fine;
  ASSERT_EQ(input.origin.size(), fine.triangle_count());
  ASSERT_EQ(input.part.size(), fine.vertex_count());
  const MeshTopology topology = topology_of(mesh_of(fine));
  EXPECT_TRUE(topology.is_manifold());
  EXPECT_EQ(topology.parts.size(), input.parts);
  std::vector<Edge> outer;
  for (const auto& [ends, count] : triangles_of_edges(fine)) {
    EXPECT_LE(count, 2);
    if (count == 1) outer.push_back(ends);
  }
  EXPECT_EQ(input.boundary_edges, outer);

  std::uint32_t parts = 0;
  for (VertexId v = 0; v < fine.vertex_count(); ++v) {
    EXPECT_FALSE(fine.triangles_at(v).empty()) << "a vertex of no triangle";
    EXPECT_LE(fine.positions[v].cwiseAbs().maxCoeff(), 1);
    for (const VertexId u : fine.neighbours(v)) EXPECT_EQ(input.part[u], input.part[v]);
    ASSERT_LE(input.part[v], parts) << "parts are numbered by their first vertices";
    parts = std::max(parts, input.part[v] + 1);
  }
  EXPECT_EQ(parts, input.parts);

  const MortonGrid grid(unit_box());
  EXPECT_TRUE(
      std::ranges::is_sorted(fine.positions, {}, [&](const Vec3& p) { return grid.code(p); }));
  EXPECT_TRUE(std::ranges::is_sorted(
      fine.triangles, {}, [](const Triangle& t) { return *std::ranges::min_element(t); }));
  double area = 0;
  for (TriangleId t = 0; t < fine.triangle_count(); ++t) {
    EXPECT_EQ(fine.area(t), triangle_area(mesh_of(fine), fine.triangles[t]));
    area += fine.area(t);
  }
  EXPECT_EQ(fine.whole_area, area);
}

struct AwkwardSurface {
  const char* name;
  std::vector<Triangle> triangles;
  std::size_t vertices;  ///< after cutting
  std::size_t parts;
  std::size_t boundary_edges;
};

// Twelve vertices in any position.
const AwkwardSurface awkward_surfaces[] = {
    {"Triangle", {{0, 1, 2}}, 3, 1, 3},
    {"TwoTriangles", {{0, 1, 2}, {1, 0, 3}}, 4, 1, 4},
    {"TurnedTriangles", {{0, 1, 2}, {0, 1, 3}}, 4, 1, 4},
    {"BowTie", {{0, 1, 2}, {0, 3, 4}}, 6, 2, 6},
    {"BowTieOfThree", {{0, 1, 2}, {0, 3, 4}, {5, 6, 0}}, 9, 3, 9},
    {"ThreeSheets", {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}, 9, 3, 9},
    {"FourSheets", {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}}, 12, 4, 12},
    // Two tetrahedra that share an edge, or a vertex.
    {"TetrahedraAtAnEdge",
     {{0, 1, 2}, {1, 0, 3}, {2, 3, 0}, {3, 2, 1}, {1, 0, 4}, {0, 1, 5}, {4, 5, 1}, {5, 4, 0}},
     8,
     2,
     0},
    {"TetrahedronWithAFin", {{0, 1, 2}, {1, 0, 3}, {2, 3, 0}, {3, 2, 1}, {0, 1, 4}}, 7, 2, 3},
    {"TetrahedraAtAVertex",
     {{0, 1, 2}, {1, 0, 3}, {2, 3, 0}, {3, 2, 1}, {0, 4, 5}, {4, 0, 6}, {5, 6, 0}, {6, 5, 4}},
     8,
     2,
     0},
    // Five triangles in a ring with a twist.
    {"Moebius", {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}, 5, 1, 5},
    {"Duplicates", {{0, 1, 2}, {2, 1, 3}, {1, 2, 0}, {0, 2, 1}, {1, 2, 3}}, 4, 1, 4},
    {"RepeatedVertices", {{0, 1, 2}, {3, 3, 4}, {5, 5, 5}, {0, 1, 0}}, 3, 1, 3},
};

std::string name_of(const testing::TestParamInfo<AwkwardSurface>& info) {
  return info.param.name;
}

class SurfaceInputOf : public testing::TestWithParam<AwkwardSurface> {};

TEST_P(SurfaceInputOf, IsAManifold) {
  Mesh mesh;
  for (std::uint64_t v = 0; v < 12; ++v) mesh.positions.push_back(random_point(1, v, 40));
  mesh.triangles = GetParam().triangles;
  const SurfaceInput input = surface_input_of(mesh);
  expect_surface(input);
  expect_same_triangles(mesh, input);
  EXPECT_EQ(input.fine.vertex_count(), GetParam().vertices);
  EXPECT_EQ(input.parts, GetParam().parts);
  EXPECT_EQ(input.boundary_edges.size(), GetParam().boundary_edges);
}

INSTANTIATE_TEST_SUITE_P(Awkward, SurfaceInputOf, testing::ValuesIn(awkward_surfaces), name_of);

TEST(SurfaceInput, OfAManifoldIsThatManifold) {
  Mesh several = icosphere(300);
  add_mesh(several, torus(300, 1), {4, 0, 0});
  add_mesh(several, irregular_plane(100, 1), {0, 4, 0});
  several.positions.emplace_back(0, 0, 3);  // of no triangle
  for (const Mesh& mesh : {several, cylinder(200, 1), creature(1500, 1)}) {
    const SurfaceInput input = surface_input_of(mesh);
    expect_surface(input);
    expect_same_triangles(mesh, input);
    EXPECT_EQ(topology_of(mesh_of(input.fine)), topology_of(mesh));
  }
}

TEST(SurfaceInput, SplitsLongEdges) {
  const Mesh mesh = cylinder(100, 1);
  const double longest = 0.11;
  const SurfaceInput input = surface_input_of(mesh, longest);
  expect_surface(input);
  EXPECT_EQ(topology_of(mesh_of(input.fine)).parts, topology_of(mesh).parts);
  for (const auto& [ends, count] : triangles_of_edges(input.fine)) {
    const auto& p = input.fine.positions;
    EXPECT_LE(norm(p[ends[0]] - p[ends[1]]), longest * input.frame.scale * (1 + 1e-12));
  }
  std::vector<double> area(mesh.triangle_count(), 0);
  const double scale = input.frame.scale;
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    area[input.origin[t]] += input.fine.area(t) / (scale * scale);
  }
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    EXPECT_NEAR(area[t], triangle_area(mesh, mesh.triangles[t]), 1e-14);
  }
}

// By the definition: triangles at a vertex are in one fan if they are the two at an edge of it.
std::size_t fans_at(const Mesh& mesh, VertexId v) {
  const std::vector<TriangleId> duplicates = find_edges(mesh).duplicates;
  std::vector<Triangle> around;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const bool counts =
        has_three_vertices(mesh.triangles[t]) && std::ranges::count(duplicates, t) == 0;
    if (counts && std::ranges::count(mesh.triangles[t], v) > 0) around.push_back(mesh.triangles[t]);
  }
  std::vector<std::size_t> fan(around.size());
  for (std::size_t i = 0; i < fan.size(); ++i) fan[i] = i;
  for (VertexId u = 0; u < mesh.vertex_count(); ++u) {
    std::vector<std::size_t> at_edge;
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (u != v && std::ranges::count(around[i], u) > 0) at_edge.push_back(i);
    }
    if (at_edge.size() != 2) continue;
    std::ranges::replace(fan, std::size_t{fan[at_edge[0]]}, std::size_t{fan[at_edge[1]]});
  }
  std::sort(fan.begin(), fan.end());
  return static_cast<std::size_t>(std::unique(fan.begin(), fan.end()) - fan.begin());
}

// A vertex comes once for each of its fans: no cut is in vain.
TEST(SurfaceInput, OfRandomSoups) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Mesh mesh;
    const std::uint32_t vertices = 4 + random_number(seed, 0, 6);
    for (std::uint64_t v = 0; v < vertices; ++v) mesh.positions.push_back(random_point(seed, v, 9));
    const std::uint32_t count = 1 + random_number(seed, 1, 16);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto draw = [&](std::uint64_t n) { return random_number(seed, 3 * i + n, vertices); };
      mesh.triangles.push_back({draw(100), draw(101), draw(102)});
    }
    if (std::ranges::none_of(mesh.triangles, has_three_vertices)) continue;
    const SurfaceInput input = surface_input_of(mesh);
    expect_surface(input);
    expect_same_triangles(mesh, input);
    std::size_t fans = 0;
    for (VertexId v = 0; v < vertices; ++v) fans += fans_at(mesh, v);
    EXPECT_EQ(input.fine.vertex_count(), fans);
  }
}

VertexId neighbour_of(const Mesh& mesh, VertexId v) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (t[c] == v) return t[(c + 1) % 3];
    }
  }
  return no_id;
}

// Wherever a triangle is stuck on a surface, by two vertices or by an edge, it comes off and leaves
// the surface whole.
TEST(SurfaceInput, CutsNothingElse) {
  const Mesh whole = torus(100, 1);
  const auto tip = static_cast<VertexId>(whole.vertex_count());
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Mesh mesh = whole;
    const VertexId a = random_number(seed, 0, tip);
    const VertexId b = seed % 2 == 0 ? random_number(seed, 1, tip) : neighbour_of(whole, a);
    if (a == b) continue;
    mesh.positions.push_back(random_point(seed, 2));
    mesh.triangles.push_back({a, b, tip});
    const SurfaceInput input = surface_input_of(mesh);
    expect_surface(input);
    EXPECT_EQ(input.fine.vertex_count(), whole.vertex_count() + 3);
    EXPECT_EQ(input.parts, 2U);
    EXPECT_EQ(input.boundary_edges.size(), 3U);
  }
}

TEST(SurfaceInput, HasAFrameThatCanBeInverted) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const double size = std::pow(10.0, static_cast<double>(seed % 60) - 30);
    const Vec3 shift = random_point(seed, 0, seed % 3 == 0 ? 1e6 * size : size);
    Mesh mesh;
    for (std::uint64_t v = 1; v <= 6; ++v) {
      mesh.positions.emplace_back(shift + random_point(seed, v, size));
    }
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const SurfaceInput input = surface_input_of(mesh);
    expect_surface(input);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(input.frame.scale) << 12, 0U) << "no power of two";
    double largest = 0;
    for (const Vec3& p : input.fine.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    EXPECT_GT(largest, 0.5 - 1e-9);
    for (const Vec3& p : mesh.positions) {
      const Vec3 back = input.frame.to_mesh(input.frame.to_unit(p));
      EXPECT_LE((back - p).cwiseAbs().maxCoeff(), 0x1p-52 * (norm(p) + norm(input.frame.middle)));
    }
  }
}

TEST(SurfaceInput, OfTheSmallestAndTheLargestMeshes) {
  for (const double size : {1e-300, 1e-160, 1e-9, 1e9, 1e75}) {
    const Mesh mesh = {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}};
    const SurfaceInput input = surface_input_of(mesh);
    expect_surface(input);
    EXPECT_GT(input.fine.whole_area, 0.1) << size;
  }
  const Mesh point = {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}};
  const SurfaceInput input = surface_input_of(point);
  expect_surface(input);
  EXPECT_EQ(input.fine.whole_area, 0);
}

}  // namespace
}  // namespace geolloyd

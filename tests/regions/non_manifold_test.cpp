// Seeds added for the remesh of inputs that are no manifolds, or of very many parts.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "core/shapes/shapes.h"
#include "tests/regions/ground.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

class NonManifold : public testing::TestWithParam<GraphKind> {};

// The surface of the cubes of a grid that `is_solid` names, faces halved, vertices shared: where
// cubes touch in an edge only, the edge has four triangles.
template <class IsSolid>
Mesh cubes(int side, IsSolid&& is_solid) {
  Mesh mesh;
  std::map<std::array<int, 3>, VertexId> vertex_at;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] =
        vertex_at.emplace(at, static_cast<VertexId>(mesh.positions.size()));
    if (is_new) mesh.positions.emplace_back(at[0], at[1], at[2]);
    return found->second;
  };
  const auto is_in = [&](const std::array<int, 3>& at) {
    for (const int x : at) {
      if (x < 0 || x >= side) return false;
    }
    return is_solid(at);
  };
  const auto add_face = [&](const std::array<int, 3>& cube, std::size_t axis, int step) {
    std::array<VertexId, 4> face{};
    constexpr std::array<std::array<int, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<int, 3> at = cube;
      at[axis] += step > 0 ? 1 : 0;
      at[(axis + 1) % 3] += corners[step > 0 ? i : 3 - i][0];
      at[(axis + 2) % 3] += corners[step > 0 ? i : 3 - i][1];
      face[i] = vertex(at);
    }
    mesh.triangles.push_back({face[0], face[1], face[2]});
    mesh.triangles.push_back({face[0], face[2], face[3]});
  };
  for (int i = 0; i < side * side * side; ++i) {
    const std::array<int, 3> cube = {i % side, i / side % side, i / side / side};
    if (!is_in(cube)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        std::array<int, 3> beside = cube;
        beside[axis] += step;
        if (!is_in(beside)) add_face(cube, axis, step);
      }
    }
  }
  return mesh;
}

// Three half planes that meet in a line.
Mesh three_sheets(VertexId width, VertexId length) {
  Mesh mesh;
  for (VertexId i = 0; i <= length; ++i) mesh.positions.emplace_back(i, 0, 0);
  const std::array<Vec3, 3> away = {Vec3(0, 1, 0), Vec3(0, -0.5, 0.9), Vec3(0, -0.5, -0.9)};
  for (const Vec3& step : away) {
    const auto first = static_cast<VertexId>(mesh.positions.size());
    for (VertexId j = 1; j <= width; ++j) {
      for (VertexId i = 0; i <= length; ++i) mesh.positions.emplace_back(Vec3(i, 0, 0) + j * step);
    }
    const auto vertex = [&](VertexId i, VertexId j) {
      return j == 0 ? i : first + (j - 1) * (length + 1) + i;
    };
    for (VertexId j = 0; j < width; ++j) {
      for (VertexId i = 0; i < length; ++i) {
        mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
    }
  }
  return mesh;
}

TEST_P(NonManifold, CubesThatTouchInEdgesGetFewSeeds) {
  Ground checkers(cubes(8, [](const auto& c) { return (c[0] + c[1] + c[2]) % 2 == 0; }),
                  GetParam());
  const auto is_random = [](const auto& c) {
    return random_number(7, 0, static_cast<std::uint64_t>(c[0] + 10 * c[1] + 100 * c[2]) + 50) %
               3 ==
           0;
  };
  Ground random(cubes(10, is_random), GetParam());
  for (Ground* ground : {&checkers, &random}) {
    ASSERT_GT(topology_of(ground->mesh).non_manifold_edges, 150U);
    const std::vector<NodeId> seeds = ground->choose(20);
    const DualisedSeeds repaired = ground->repair(seeds);
    EXPECT_LE(repaired.seeds.size(), seeds.size() + most_seeds_added(seeds.size()));
    EXPECT_EQ(most_seeds_added(20), 104U);
  }
}

// Far from the line in which they meet all is as it should be.
TEST_P(NonManifold, OfSheetsIsMendedWhereverTheyAreManifolds) {
  Ground ground(three_sheets(12, 20), GetParam());
  for (const std::size_t count : {3U, 10U, 40U}) {
    const std::vector<NodeId> seeds = ground.choose(count, count);
    const DualisedSeeds repaired = ground.repair(seeds);
    EXPECT_LE(repaired.seeds.size(), seeds.size() + most_seeds_added(seeds.size()));
    for (const ClosedBallViolation& violation : repaired.dual.violations) {
      EXPECT_TRUE(violation.is_of_input);
    }
  }
}

TEST_P(NonManifold, SurfacesThatTouchInAVertexAreLikeTheInput) {
  Mesh touching = side_by_side(icosphere(320), icosphere(320));
  const auto half = static_cast<VertexId>(touching.vertex_count() / 2);
  for (Triangle& t : touching.triangles) {
    for (VertexId& v : t) v = v == half ? 0 : v;
  }
  Ground ground(std::move(touching), GetParam());
  for (const std::size_t count : {2U, 9U, 40U}) {
    const DualisedSeeds repaired = ground.repair(ground.choose(count, count));
    EXPECT_TRUE(repaired.dual.violations.empty()) << count;
  }
}

// Quadratic in the number of parts this would take minutes.
TEST_P(NonManifold, ManyLooseTrianglesStayTriangles) {
  constexpr VertexId count = 30000;
  Mesh mesh;
  for (VertexId t = 0; t < count; ++t) {
    const Vec3 at(2 * (t % 200), 2 * (t / 200), 0);
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
      mesh.positions.push_back(at + corner);
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  Ground ground(std::move(mesh), GetParam());
  const DualisedSeeds repaired = ground.repair(ground.choose(count));
  if (!has_vertices(GetParam())) return;  // one node each: there is no room for more
  EXPECT_TRUE(repaired.dual.violations.empty());
  EXPECT_EQ(repaired.seeds.size(), 3 * count);
  EXPECT_EQ(repaired.dual.triangles.size(), count);
}

INSTANTIATE_TEST_SUITE_P(AllGraphs, NonManifold, testing::ValuesIn(all_kinds));

}  // namespace
}  // namespace geolloyd

#include "core/surface/flips/edge_flips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "core/base/types.h"
#include "core/base/vec3.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

double angle_at(const Mesh& mesh, VertexId v, VertexId a, VertexId b) {
  const Vec3 u = mesh.positions[a] - mesh.positions[v];
  const Vec3 w = mesh.positions[b] - mesh.positions[v];
  return std::atan2(norm(cross(u, w)), dot(u, w));
}

double smallest_angle_of(const Mesh& mesh) {
  double smallest = 4;
  for (const auto& [a, b, c] : mesh.triangles) {
    smallest = std::min(
        {smallest, angle_at(mesh, a, b, c), angle_at(mesh, b, c, a), angle_at(mesh, c, a, b)});
  }
  return smallest;
}

// Points of a grid, shaken, in their plane; each cell has a diagonal at random.
Mesh shaken_grid(std::uint64_t random_seed) {
  constexpr VertexId side = 12;
  Mesh mesh;
  for (VertexId v = 0; v < side * side; ++v) {
    const Vec3 shake = random_point(random_seed, v, 0.3);
    mesh.positions.emplace_back(v % side + shake.x(), v / side + shake.y(), 0);
  }
  for (VertexId row = 0; row + 1 < side; ++row) {
    for (VertexId v = row * side; v + 1 < (row + 1) * side; ++v) {
      const std::array<VertexId, 4> c = {v, v + 1, v + side + 1, v + side};
      const std::size_t turn = random_number(random_seed, 1000 + v, 2);
      mesh.triangles.push_back({c[turn], c[turn + 1], c[turn + 2]});
      mesh.triangles.push_back({c[turn], c[turn + 2], c[(turn + 3) % 4]});
    }
  }
  return mesh;
}

std::map<std::array<VertexId, 2>, std::vector<VertexId>> apexes(const Mesh& mesh) {
  std::map<std::array<VertexId, 2>, std::vector<VertexId>> found;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      found[ascending(t[(k + 1) % 3], t[(k + 2) % 3])].push_back(t[k]);
    }
  }
  return found;
}

double signed_area(const Mesh& mesh, VertexId a, VertexId b, VertexId c) {
  return cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z();
}

// Two triangles see no edge under more than half a turn.
bool is_delaunay(const Mesh& mesh) {
  for (const auto& [edge, apex] : apexes(mesh)) {
    if (apex.size() != 2) continue;
    const double sum =
        angle_at(mesh, apex[0], edge[0], edge[1]) + angle_at(mesh, apex[1], edge[0], edge[1]);
    if (sum > std::numbers::pi + 1e-9) return false;
  }
  return true;
}

TEST(EdgeFlips, MakeAPlaneDelaunay) {
  for (std::uint64_t n = 0; n < 20; ++n) {
    Mesh mesh = shaken_grid(n);
    const double before = smallest_angle_of(mesh);
    const MeshTopology topology = find_topology(mesh, find_edges(mesh));
    EXPECT_FALSE(is_delaunay(mesh));
    EXPECT_GT(flip_edges(mesh), 0U);
    EXPECT_TRUE(is_delaunay(mesh)) << n;
    EXPECT_GE(smallest_angle_of(mesh), before);
    EXPECT_EQ(find_topology(mesh, find_edges(mesh)).parts, topology.parts);
    EXPECT_TRUE(find_topology(mesh, find_edges(mesh)).is_manifold());
    for (const auto& [a, b, c] : mesh.triangles) EXPECT_GT(signed_area(mesh, a, b, c), 0);
    EXPECT_EQ(flip_edges(mesh), 0U);
  }
}

// Two triangles at a ridge, which a flip would cut off.
TEST(EdgeFlips, LeaveCreases) {
  const auto roof = [](double height) {
    return Mesh{{{-2, 0, 0}, {2, 0, 0}, {0, -0.5, -height}, {0, 0.5, -height}},
                {{0, 2, 1}, {0, 1, 3}}};
  };
  Mesh steep = roof(0.5);
  EXPECT_EQ(flip_edges(steep), 0U);
  EXPECT_EQ(steep.triangles, roof(0.5).triangles);
  Mesh flat = roof(0.05);
  EXPECT_EQ(flip_edges(flat), 1U);
  EXPECT_EQ(apexes(flat).count({2, 3}), 1U);
}

// A flat pyramid: each edge of its base would become a second one between two of its vertices.
TEST(EdgeFlips, NeverMakeAnEdgeTwice) {
  Mesh mesh{{{0, 0, 0.01}, {3, 0, 0}, {-1, 0.4, 0}, {-1, -0.4, 0}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  const auto before = mesh.triangles;
  EXPECT_EQ(flip_edges(mesh), 0U);
  EXPECT_EQ(mesh.triangles, before);
}

// Triangles of a Moebius strip cannot all have one orientation.
TEST(EdgeFlips, KeepAMoebiusStrip) {
  constexpr VertexId steps = 40;
  Mesh mesh;
  for (VertexId i = 0; i < steps; ++i) {
    const double turn = 2 * std::numbers::pi * i / steps;
    for (const double side : {-0.3, 0.3}) {
      const double along = side * std::cos(turn / 2) + 1;
      mesh.positions.emplace_back(along * std::cos(turn), along * std::sin(turn),
                                  side * std::sin(turn / 2));
    }
  }
  for (VertexId i = 0; i < steps; ++i) {
    const bool is_last = i + 1 == steps;
    const VertexId next = is_last ? 1 : 2 * i + 2;
    const VertexId beside = is_last ? 0 : 2 * i + 3;
    mesh.triangles.push_back({2 * i, 2 * i + 1, next});
    mesh.triangles.push_back({2 * i + 1, beside, next});
  }
  const auto parts = find_topology(mesh, find_edges(mesh)).parts;
  flip_edges(mesh);
  const MeshTopology after = find_topology(mesh, find_edges(mesh));
  EXPECT_EQ(after.parts, parts);
  EXPECT_EQ(after.non_manifold_edges, 0U);
  EXPECT_EQ(after.non_manifold_vertices, 0U);
}

TEST(EdgeFlips, OfNothing) {
  Mesh none;
  EXPECT_EQ(flip_edges(none), 0U);
  Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(flip_edges(one), 0U);
}

}  // namespace
}  // namespace geolloyd

#include "core/graph/mesh_graph.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "core/mesh/mesh_measure.h"
#include "core/shapes/shapes.h"
#include "core/voronoi/check_partition.h"
#include "core/voronoi/dijkstra.h"
#include "core/voronoi/forest.h"
#include "geolloyd/errors.h"
#include "tests/support/graph_kinds.h"

namespace geolloyd {
namespace {

MeshGraph make(const Mesh& mesh, GraphKind kind, Norm norm_kind = Norm::geodesic,
               std::vector<TangentSpace> field = {}) {
  return make_mesh_graph(mesh, find_edges(mesh), {kind, norm_kind, std::move(field)});
}

// Length of the arc between two input ids, mesh units; negative where there is none.
double arc_between(const MeshGraph& made, std::uint32_t a, std::uint32_t b) {
  const NodeId from = made.node_of[a];
  for (ArcId i = made.graph.first_arc[from]; i < made.graph.first_arc[from + 1]; ++i) {
    if (made.graph.target[i] == made.node_of[b])
      return made.graph.length[i] * made.graph.tick_length;
  }
  return -1;
}

constexpr double tick_error = 1e-7;

//  3---2      two right triangles, the second turned up by a quarter about their diagonal 0-2
//  | / |
//  0---1
Mesh folded_square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.5, std::sqrt(0.5)}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(MeshGraph, VertexHasTheEdges) {
  const MeshGraph made = make(folded_square(), GraphKind::vertex);
  EXPECT_EQ(made.graph.node_count(), 4U);
  EXPECT_EQ(made.graph.arc_count(), 10U);
  EXPECT_NEAR(arc_between(made, 0, 1), 1, tick_error);
  EXPECT_NEAR(arc_between(made, 0, 2), std::sqrt(2), tick_error);
  EXPECT_EQ(arc_between(made, 1, 3), -1);
}

// Across the fold it is as far as across the flat square, not the chord of length 1.
TEST(MeshGraph, VertexDenseAddsTheWayAcrossEachEdge) {
  const MeshGraph made = make(folded_square(), GraphKind::vertex_dense);
  EXPECT_EQ(made.graph.arc_count(), 12U);
  EXPECT_NEAR(arc_between(made, 1, 3), std::sqrt(2), tick_error);
}

TEST(MeshGraph, TriangleJoinsBarycentresAcrossEdges) {
  const MeshGraph made = make(folded_square(), GraphKind::triangle);
  EXPECT_EQ(made.graph.node_count(), 2U);
  EXPECT_NEAR(arc_between(made, 0, 1), std::sqrt(2) / 3, tick_error);
}

TEST(MeshGraph, TriangleDenseGoesByWayOfASharedVertex) {
  //  two triangles that share vertex 0 only: a bow-tie
  const Mesh bow{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {0, -3, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  const MeshGraph made = make(bow, GraphKind::triangle_dense);
  EXPECT_NEAR(arc_between(made, 0, 1), 2 * std::sqrt(2), tick_error);
  EXPECT_EQ(make(bow, GraphKind::triangle).graph.arc_count(), 0U);
}

TEST(MeshGraph, TriangleDenseKeepsTheShorterWayAcrossASharedEdge) {
  EXPECT_NEAR(arc_between(make(folded_square(), GraphKind::triangle_dense), 0, 1), std::sqrt(2) / 3,
              tick_error);
}

TEST(MeshGraph, MixedJoinsVerticesTrianglesAndCorners) {
  const MeshGraph made = make(folded_square(), GraphKind::mixed);
  EXPECT_EQ(made.graph.node_count(), 6U);
  EXPECT_EQ(made.graph.arc_count(), 2U * (5 + 1 + 6));
  EXPECT_NEAR(arc_between(made, 4, 1), norm(Vec3(1, 0, 0) - Vec3(2.0 / 3, 1.0 / 3, 0)), tick_error);
  EXPECT_NEAR(arc_between(made, 4, 5), std::sqrt(2) / 3, tick_error);
  EXPECT_EQ(arc_between(made, 4, 3), -1);
  EXPECT_TRUE(made.is_triangle(4));
  EXPECT_FALSE(made.is_triangle(3));
}

TEST(MeshGraph, IsSymmetricSortedAndFreeOfLoopsInEveryKindAndNorm) {
  const Mesh mesh = torus(600, 1);
  for (const GraphKind kind : all_kinds) {
    for (const Norm norm_kind : {Norm::geodesic, Norm::manhattan, Norm::linf}) {
      const Graph graph = make(mesh, kind, norm_kind).graph;
      std::set<std::array<std::uint32_t, 3>> arcs;
      for (NodeId v = 0; v < graph.node_count(); ++v) {
        for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
          EXPECT_NE(graph.target[a], v);
          EXPECT_GE(graph.length[a], 1U);
          if (a > graph.first_arc[v]) {
            EXPECT_LT(graph.target[a - 1], graph.target[a]);
          }
          arcs.insert({v, graph.target[a], graph.length[a]});
        }
      }
      EXPECT_EQ(arcs.size(), graph.arc_count());
      for (const auto& [a, b, length] : arcs) EXPECT_TRUE(arcs.contains({b, a, length}));
    }
  }
}

TEST(MeshGraph, HasTheSurfaceAsItsMass) {
  const Mesh mesh = torus(600, 1);
  const Buffer<double> areas = triangle_areas(mesh, {});
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (const GraphKind kind : all_kinds) {
    const Graph graph = make(mesh, kind).graph;
    double mass = 0;
    for (const std::uint32_t m : graph.mass) mass += m * graph.tick_mass;
    EXPECT_NEAR(mass, kind == GraphKind::mixed ? 2 * area : area, 1e-6);
  }
}

TEST(MeshGraph, SpeaksInputIdsOutside) {
  const Mesh mesh = torus(600, 1);
  for (const GraphKind kind : all_kinds) {
    const MeshGraph made = make(mesh, kind);
    for (NodeId v = 0; v < made.graph.node_count(); ++v) {
      const std::uint32_t id = made.input_id[v];
      EXPECT_EQ(made.node_of[id], v);
      const Vec3 expected =
          made.is_triangle(id)
              ? barycentre(mesh, static_cast<TriangleId>(id - made.first_triangle_id))
              : mesh.positions[id];
      EXPECT_EQ(made.position[v], expected);
    }
  }
}

TEST(MeshGraph, LeavesOutWhatIsNoPartOfTheSurface) {
  Mesh mesh = folded_square();
  mesh.positions.emplace_back(7, 7, 7);
  mesh.triangles.push_back({1, 2, 1});
  const MeshGraph vertices = make(mesh, GraphKind::vertex);
  EXPECT_EQ(vertices.graph.node_count(), 4U);
  EXPECT_EQ(vertices.node_of[4], no_id);
  const MeshGraph triangles = make(mesh, GraphKind::triangle);
  EXPECT_EQ(triangles.graph.node_count(), 2U);
  EXPECT_EQ(triangles.node_of[2], no_id);
  EXPECT_THROW(make(Mesh{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}, GraphKind::vertex), InvalidInput);
}

TEST(MeshGraph, ConnectsAllTrianglesOfANonManifoldEdgeWhateverTheirOrientation) {
  const Mesh book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                  {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}};
  const MeshGraph made = make(book, GraphKind::triangle);
  for (const auto& [a, b] : {std::pair{0U, 1U}, {0U, 2U}, {1U, 2U}}) {
    EXPECT_GT(arc_between(made, a, b), 0);
  }
}

TEST(MeshGraph, RefusesASquareOfTooManyTrianglesAtOneVertexBeforeTakingMemory) {
  Mesh fan;
  fan.positions.assign(200002, Vec3(0, 0, 0));
  for (VertexId v = 1; v + 1 < fan.vertex_count(); ++v) {
    fan.positions[v] = {std::cos(v), std::sin(v), 0};
    fan.triangles.push_back({0, v, v + 1});
  }
  EXPECT_THROW(make(fan, GraphKind::triangle_dense), InvalidInput);
  EXPECT_EQ(make(fan, GraphKind::vertex).graph.node_count(), fan.vertex_count());
}

// Distances from one node, mesh units, checked.
std::vector<double> distances_from(const MeshGraph& made, NodeId source) {
  IndexedHeap heap(made.graph.node_count());
  Partition partition;
  std::vector<NodeId> settled;
  const std::vector<NodeId> seeds = {source};
  search_free(made.graph, seeds, heap, partition.key, settled);
  partition.parent.assign(made.graph.node_count(), no_id);
  derive_parents(made.graph, partition.key, settled, partition.parent);
  EXPECT_FALSE(check_partition(made.graph, seeds, partition, Regions::free).has_value());
  std::vector<double> distances;
  for (const Key key : partition.key)
    distances.push_back(distance_of(key) * made.graph.tick_length);
  return distances;
}

struct Error {
  double least = 1e300;  // graph distance / true distance
  double mean = 0;
};

template <class TrueDistance>
Error error_against(const MeshGraph& made, double nearest, TrueDistance&& true_distance) {
  const std::vector<double> distances = distances_from(made, 0);
  Error error;
  double count = 0;
  for (NodeId v = 1; v < distances.size(); ++v) {
    const double truth = true_distance(made.position[0], made.position[v]);
    if (truth < nearest) continue;
    error.least = std::min(error.least, distances[v] / truth);
    error.mean += distances[v] / truth;
    ++count;
  }
  error.mean /= count;
  return error;
}

TEST(MeshGraph, DistancesOnThePlaneAreNeverTooShortAndDenserGraphsAreBetter) {
  const Mesh mesh = irregular_plane(5000, 1);
  std::array<Error, all_kinds.size()> error;
  for (std::size_t k = 0; k < all_kinds.size(); ++k) {
    error[k] = error_against(make(mesh, all_kinds[k]), 0.1,
                             [](const Vec3& a, const Vec3& b) { return norm(b - a); });
    EXPECT_GE(error[k].least, 1 - 1e-6);
    EXPECT_LT(error[k].mean, 1.25);
  }
  EXPECT_LT(error[1].mean, error[0].mean);  // dense vertices against vertices
  EXPECT_LT(error[3].mean, error[2].mean);  // dense triangles against triangles
  EXPECT_LT(error[4].mean, error[0].mean);  // mixed against vertices
  EXPECT_LT(error[1].mean, 1.04);
}

TEST(MeshGraph, DistancesOnTheSphereAreGreatCirclesButForTheZigzag) {
  const Mesh mesh = icosphere(20000);
  for (const GraphKind kind : all_kinds) {
    const Error error = error_against(make(mesh, kind), 0.2, [](const Vec3& a, const Vec3& b) {
      return std::acos(std::clamp(dot(normalized(a), normalized(b)), -1.0, 1.0));
    });
    EXPECT_GT(error.least, 0.998);
    EXPECT_LT(error.mean, 1.25);
  }
}

std::vector<TangentSpace> field_along_x(std::size_t vertices, double magnitude) {
  return std::vector<TangentSpace>(vertices, {{1, 0, 0}, {0, 1, 0}, magnitude, 1});
}

// Three times as far along x is the same as a plane three times as wide.
TEST(MeshGraph, AFieldStretchesThePlaneAlongItsAxis) {
  const Mesh mesh = irregular_plane(800, 1);
  Mesh wide = mesh;
  for (Vec3& p : wide.positions) p.x() *= 3;
  for (const GraphKind kind : {GraphKind::vertex, GraphKind::mixed}) {
    const MeshGraph stretched =
        make(mesh, kind, Norm::geodesic, field_along_x(mesh.vertex_count(), 3));
    const MeshGraph expected = make(wide, kind);
    for (std::uint32_t a = 0; a < mesh.vertex_count(); ++a) {
      for (const NodeId n : stretched.graph.neighbours(stretched.node_of[a])) {
        const std::uint32_t b = stretched.input_id[n];
        if (stretched.is_triangle(b)) continue;
        ASSERT_NEAR(arc_between(stretched, a, b), arc_between(expected, a, b), 1e-6);
      }
    }
  }
}

// On the plane an arc whose isotropic length is that of the straight line is stretched as that line
// is, across edges too.
TEST(MeshGraph, AFieldStretchesStraightWaysAcrossEdges) {
  const Mesh mesh = irregular_plane(800, 1);
  const auto field = field_along_x(mesh.vertex_count(), 3);
  for (const GraphKind kind : all_kinds) {
    const MeshGraph plain = make(mesh, kind);
    const MeshGraph stretched = make(mesh, kind, Norm::geodesic, field);
    std::size_t straight = 0;
    for (NodeId v = 0; v < plain.graph.node_count(); ++v) {
      for (const NodeId u : plain.graph.neighbours(v)) {
        const Vec3 way = plain.position[u] - plain.position[v];
        const std::uint32_t a = plain.input_id[v];
        const std::uint32_t b = plain.input_id[u];
        if (std::abs(arc_between(plain, a, b) - norm(way)) > 1e-7) continue;
        ++straight;
        ASSERT_NEAR(arc_between(stretched, a, b), std::hypot(3 * way.x(), way.y()), 1e-6);
      }
    }
    EXPECT_GT(straight, 0.15 * static_cast<double>(plain.graph.arc_count()));
  }
}

// Coordinates and magnitudes may each be as large as files may hold them, but not both.
TEST(MeshGraph, RefusesLengthsWhoseEnergiesWouldBeInfinite) {
  const Mesh small = folded_square();
  Mesh large = small;
  for (Vec3& p : large.positions) p *= largest_coordinate;
  const std::vector<TangentSpace> field(
      4, {Vec3::UnitX(), Vec3::UnitY(), largest_coordinate, largest_coordinate});
  for (const GraphKind kind : all_kinds) {
    EXPECT_NO_THROW(make(large, kind));
    EXPECT_NO_THROW(make(small, kind, Norm::geodesic, field));
    EXPECT_THROW(make(large, kind, Norm::geodesic, field), InvalidInput);
  }
}

TEST(MeshGraph, AUnitFieldOnThePlaneChangesNothing) {
  const Mesh mesh = irregular_plane(800, 1);
  for (const GraphKind kind : all_kinds) {
    const MeshGraph with = make(mesh, kind, Norm::geodesic, field_along_x(mesh.vertex_count(), 1));
    const MeshGraph without = make(mesh, kind);
    ASSERT_EQ(with.graph.target, without.graph.target);
    for (std::size_t a = 0; a < with.graph.arc_count(); ++a) {
      ASSERT_NEAR(with.graph.length[a] * with.graph.tick_length,
                  without.graph.length[a] * without.graph.tick_length, 1e-6);
    }
  }
}

TEST(MeshGraph, NormsFollowTheAxesOrTheField) {
  //  vertices at (0,0), (3,4), (3,0)
  const Mesh mesh{{{0, 0, 0}, {3, 4, 0}, {3, 0, 0}}, {{0, 2, 1}}};
  EXPECT_NEAR(arc_between(make(mesh, GraphKind::vertex), 0, 1), 5, 1e-6);
  EXPECT_NEAR(arc_between(make(mesh, GraphKind::vertex, Norm::manhattan), 0, 1), 7, 1e-6);
  EXPECT_NEAR(arc_between(make(mesh, GraphKind::vertex, Norm::linf), 0, 1), 4, 1e-6);
  const TangentSpace along{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, 2, 1};
  const std::vector<TangentSpace> field(3, along);
  EXPECT_NEAR(arc_between(make(mesh, GraphKind::vertex, Norm::manhattan, field), 0, 1), 10, 1e-6);
  EXPECT_NEAR(arc_between(make(mesh, GraphKind::vertex, Norm::linf, field), 0, 1), 10, 1e-6);
  EXPECT_NEAR(arc_between(make(mesh, GraphKind::vertex, Norm::manhattan, field), 0, 2),
              2 * 1.8 + 2.4, 1e-6);
}

// What no arc is made from goes before, the rest meanwhile.
TEST(MeshGraph, IsTheSameFromEdgesThatGiveTheirMemoryBack) {
  Mesh mesh = irregular_plane(2000, 1);
  mesh.triangles.push_back(mesh.triangles[5]);
  mesh.triangles.push_back({7, 7, 9});
  for (const GraphKind kind : all_kinds) {
    MeshEdges edges = find_edges(mesh);
    const MeshGraph expected = make_mesh_graph(mesh, edges, {kind, Norm::geodesic, {}});
    EXPECT_EQ(count_nodes(mesh, kind), expected.graph.node_count());
    keep_for_arcs(edges, kind);
    EXPECT_EQ(edges.corner.capacity() == 0, kind == GraphKind::vertex);
    const MeshGraph made = make_mesh_graph(mesh, std::move(edges), {kind, Norm::geodesic, {}});
    EXPECT_EQ(edges.ends.capacity(), 0U);
    EXPECT_EQ(edges.duplicates.size(), 1U);
    EXPECT_EQ(made.input_id, expected.input_id);
    EXPECT_EQ(made.graph.first_arc, expected.graph.first_arc);
    EXPECT_EQ(made.graph.target, expected.graph.target);
    EXPECT_EQ(made.graph.length, expected.graph.length);
    EXPECT_EQ(made.graph.mass, expected.graph.mass);
  }
}

}  // namespace
}  // namespace geolloyd

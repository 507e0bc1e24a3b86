#include "bench/support/graph_error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/graph/arc_length.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "tests/support/graph_kinds.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t source_count = 8;

struct Surface {
  const char* name;
  Mesh mesh;
  ExactDistance exact;
  double edge;  // a little more than the mean edge's length
};

double on_plane(const Vec3& a, const Vec3& b) {
  return norm(a - b);
}

Surface plane(std::size_t triangles) {
  return {"plane", irregular_plane(triangles, 1), on_plane,
          1.2 / std::sqrt(static_cast<double>(triangles) / 2)};
}

// Every cell cut along the same diagonal.
Surface grid(std::uint32_t cells) {
  const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  return {"grid", refine(square, cells), on_plane, 1.2 / cells};
}

// The unit square folded at each column of its vertices, by a right angle there and back, so that
// distances on it are those of the square.
Surface accordion(std::uint32_t cells) {
  const double slope = std::sqrt(0.5);
  Mesh mesh = irregular_plane(std::size_t{2} * cells * cells, 1);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto column = static_cast<double>(v % (cells + 1));
    mesh.positions[v].x() = column / cells * slope;
    mesh.positions[v].z() = std::fmod(column, 2) / cells * slope;
  }
  return {"accordion", mesh,
          [slope](const Vec3& a, const Vec3& b) {
            return std::hypot((a.x() - b.x()) / slope, a.y() - b.y());
          },
          1.2 / cells};
}

Surface sphere(std::size_t triangles) {
  return {"sphere", icosphere(triangles),
          [](const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); },
          6 / std::sqrt(static_cast<double>(triangles))};
}

Surface tube_surface(std::size_t triangles) {
  return {"cylinder", cylinder(triangles, 1),
          [](const Vec3& a, const Vec3& b) {
            const double turn =
                std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
            return std::hypot(turn, a.z() - b.z());
          },
          6 / std::sqrt(static_cast<double>(triangles))};
}

MeshGraph graph_of(const Surface& surface, GraphKind kind) {
  return make_mesh_graph(surface.mesh, find_edges(surface.mesh), {kind, Norm::geodesic, {}});
}

GraphError error_of(const Surface& surface, GraphKind kind) {
  return measure_graph_error(graph_of(surface, kind), source_count, 1, 8 * surface.edge,
                             surface.exact);
}

// A way on a graph is a way on the surface. A graph that measured chords through space where it
// crosses edges would jump from fold to fold.
TEST(GraphError, NoGraphHasAShorterWayThanTheSurface) {
  for (const Surface& surface : {accordion(30), plane(2'000), grid(30)}) {
    for (const GraphKind kind : all_kinds) {
      const GraphError error = error_of(surface, kind);
      EXPECT_GT(error.pairs, 1'000U);
      EXPECT_GT(error.smallest, -1e-6) << surface.name << ' ' << static_cast<int>(kind);
    }
  }
}

// Facets cut corners: on them distances are shorter than on what they stand for, by some
// (edge / radius)^2 / 24.
TEST(GraphError, OnACurvedSurfaceOnlyFacetsMakeWaysShorter) {
  for (const Surface& surface : {sphere(8'000), tube_surface(8'000)}) {
    for (const GraphKind kind : all_kinds) {
      EXPECT_GT(error_of(surface, kind).smallest, -surface.edge * surface.edge / 12)
          << surface.name << ' ' << static_cast<int>(kind);
    }
  }
}

// Straight across the diagonals the vertex graph goes along two sides of each cell. With arcs
// across the edges, or to the triangles, it can go along eight directions at least, and the worst
// lies in the middle between two.
TEST(GraphError, IsKnownInTheWorstDirectionsOfAGrid) {
  const Surface surface = grid(40);
  const double octagon = 1 / std::cos(3.141592653589793 / 8) - 1;
  EXPECT_NEAR(error_of(surface, GraphKind::vertex).largest, std::sqrt(2.0) - 1, 1e-6);
  EXPECT_NEAR(error_of(surface, GraphKind::vertex_dense).largest, octagon, 1e-3);
  EXPECT_NEAR(error_of(surface, GraphKind::mixed).largest, octagon, 1e-3);
}

struct Expected {
  GraphKind kind;
  double least_mean;
  double most_mean;
  double most;  // of all pairs
};

void expect_errors(const Surface& surface, const std::vector<Expected>& expected) {
  for (const auto& [kind, least_mean, most_mean, most] : expected) {
    const GraphError error = error_of(surface, kind);
    const auto where = testing::Message() << surface.name << ' ' << static_cast<int>(kind);
    EXPECT_GT(error.mean, least_mean) << where;
    EXPECT_LT(error.mean, most_mean) << where;
    EXPECT_LT(error.largest, most) << where;
    EXPECT_GE(error.rms, std::abs(error.mean)) << where;
  }
}

// It depends on the kind of graph and hardly on the surface. Smaller triangles do not lessen it:
// ways have the same few directions to choose from.
TEST(GraphError, StaysWhenMeshesAreRefined) {
  const std::vector<Expected> irregular = {
      {GraphKind::vertex, 0.04, 0.06, 0.17},  {GraphKind::vertex_dense, 0.012, 0.02, 0.07},
      {GraphKind::triangle, 0.18, 0.22, 0.4}, {GraphKind::triangle_dense, 0.04, 0.06, 0.16},
      {GraphKind::mixed, 0.018, 0.027, 0.09}, {GraphKind::vertex_far, 0.001, 0.003, 0.02}};
  const std::vector<Expected> regular = {
      {GraphKind::vertex, 0.055, 0.08, 0.25}, {GraphKind::vertex_dense, 0.012, 0.02, 0.07},
      {GraphKind::triangle, 0.21, 0.26, 0.5}, {GraphKind::triangle_dense, 0.055, 0.08, 0.22},
      {GraphKind::mixed, 0.012, 0.02, 0.07},  {GraphKind::vertex_far, 0.001, 0.003, 0.02}};
  for (const std::size_t triangles : {5'000U, 20'000U}) {
    expect_errors(plane(triangles), irregular);
    expect_errors(tube_surface(triangles), irregular);
    expect_errors(sphere(triangles), regular);
  }
}

// Distances from one input id to all, per input id.
std::vector<double> distances_from(const MeshGraph& made, std::uint32_t input_id) {
  const std::vector<double> of_node = graph_distances(made.graph, made.node_of[input_id]);
  std::vector<double> distances;
  for (const NodeId v : made.node_of) distances.push_back(of_node[v]);
  return distances;
}

// From some nodes to all. Ids of the sparse graph are larger by `offset` in the dense one.
void expect_no_longer(const MeshGraph& dense, const MeshGraph& sparse, std::size_t offset) {
  const auto count = static_cast<std::uint32_t>(sparse.node_of.size());
  for (std::uint32_t source = 0; source < count; source += count / 4) {
    const auto in_sparse = distances_from(sparse, source);
    const auto in_dense = distances_from(dense, source + static_cast<std::uint32_t>(offset));
    for (std::size_t id = 0; id < count; ++id) {
      ASSERT_LE(in_dense[id + offset], in_sparse[id] + 1e-6);
    }
  }
}

TEST(GraphError, MoreArcsNeverMakeAWayLonger) {
  for (const Surface& surface : {plane(2'000), grid(30), accordion(30), sphere(2'000)}) {
    const MeshGraph vertex = graph_of(surface, GraphKind::vertex);
    const MeshGraph triangle = graph_of(surface, GraphKind::triangle);
    const MeshGraph mixed = graph_of(surface, GraphKind::mixed);
    expect_no_longer(graph_of(surface, GraphKind::vertex_dense), vertex, 0);
    expect_no_longer(graph_of(surface, GraphKind::vertex_far), vertex, 0);
    expect_no_longer(graph_of(surface, GraphKind::triangle_dense), triangle, 0);
    expect_no_longer(mixed, vertex, 0);
    expect_no_longer(mixed, triangle, mixed.first_triangle_id);
  }
}

// Axes along no edges of the mesh.
TEST(GraphError, IsSmallInEachNormOnTheFarGraph) {
  const Surface surface = plane(5'000);
  const TangentSpace oblique{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, 1, 1};
  const std::vector<TangentSpace> field(surface.mesh.vertex_count(), oblique);
  for (const Norm norm_kind : {Norm::manhattan, Norm::linf}) {
    const auto error_on = [&](GraphKind kind) {
      const MeshGraph made =
          make_mesh_graph(surface.mesh, find_edges(surface.mesh), {kind, norm_kind, field});
      return measure_graph_error(
          made, source_count, 1, 8 * surface.edge,
          [&](const Vec3& a, const Vec3& b) { return measure(Vec3(b - a), oblique, norm_kind); });
    };
    const GraphError far = error_on(GraphKind::vertex_far);
    EXPECT_GT(far.smallest, -1e-6) << static_cast<int>(norm_kind);
    EXPECT_LT(far.mean, 0.005) << static_cast<int>(norm_kind);
    EXPECT_GT(error_on(GraphKind::vertex).mean, 0.03) << static_cast<int>(norm_kind);
  }
}

TEST(GraphError, LeavesOutWhatCannotBeReachedOrIsTooNear) {
  // Two triangles apart from each other, with edges of length 1 and sqrt 2.
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}, {10, 0, 0}, {9, 1, 0}},
                  {{0, 1, 2}, {3, 4, 5}}};
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  EXPECT_EQ(measure_graph_error(made, 5, 1, 0.5, on_plane).pairs, 10U);
  EXPECT_EQ(measure_graph_error(made, 5, 1, 2, on_plane).pairs, 0U);
  EXPECT_EQ(measure_graph_error(made, 5, 1, 2, on_plane).largest, 0);
  const auto doubled = [](const Vec3& a, const Vec3& b) { return 2 * norm(a - b); };
  EXPECT_NEAR(measure_graph_error(made, 5, 1, 0.5, doubled).mean, -0.5, 1e-6);
  EXPECT_NEAR(measure_graph_error(made, 5, 1, 0.5, doubled).rms, 0.5, 1e-6);
}

}  // namespace
}  // namespace geolloyd

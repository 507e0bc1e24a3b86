// From a mesh to its graph: the threads of a scheduler make the same bytes as the calling thread.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/support/same_bytes.h"
#include "core/fields/cross_field.h"
#include "core/fields/curvature_field.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

void expect_same(const MeshEdges& a, const MeshEdges& b) {
  EXPECT_TRUE(same_bytes(a.ends, b.ends));
  EXPECT_TRUE(same_bytes(a.first_corner, b.first_corner));
  EXPECT_TRUE(same_bytes(a.corner, b.corner));
  EXPECT_TRUE(same_bytes(a.duplicates, b.duplicates));
}

void expect_same(const MeshFacts& a, const MeshFacts& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.unreferenced_vertices, b.unreferenced_vertices);
  EXPECT_EQ(a.repeated_vertex_triangles, b.repeated_vertex_triangles);
  EXPECT_EQ(a.zero_area_triangles, b.zero_area_triangles);
  EXPECT_EQ(a.duplicate_triangles, b.duplicate_triangles);
  EXPECT_EQ(a.boundary_edges, b.boundary_edges);
  EXPECT_EQ(a.non_manifold_edges, b.non_manifold_edges);
  EXPECT_EQ(a.inconsistent_edges, b.inconsistent_edges);
  EXPECT_EQ(a.zero_length_edges, b.zero_length_edges);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.euler_characteristic, b.euler_characteristic);
  EXPECT_TRUE(same_bytes(a.area, b.area));
  EXPECT_TRUE(same_bytes(a.bounding_diagonal, b.bounding_diagonal));
}

void expect_same(const MeshGraph& a, const MeshGraph& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.first_triangle_id, b.first_triangle_id);
  EXPECT_TRUE(same_bytes(a.input_id, b.input_id));
  EXPECT_TRUE(same_bytes(a.node_of, b.node_of));
  EXPECT_TRUE(same_bytes(a.position, b.position));
  EXPECT_TRUE(same_bytes(a.graph.first_arc, b.graph.first_arc));
  EXPECT_TRUE(same_bytes(a.graph.target, b.graph.target));
  EXPECT_TRUE(same_bytes(a.graph.length, b.graph.length));
  EXPECT_TRUE(same_bytes(a.graph.mass, b.graph.mass));
  EXPECT_TRUE(same_bytes(a.graph.tick_length, b.graph.tick_length));
  EXPECT_TRUE(same_bytes(a.graph.tick_mass, b.graph.tick_mass));
}

// Directions that turn from place to place, of unlike magnitudes, at right angles nowhere.
std::vector<TangentSpace> swirl(const Mesh& mesh) {
  std::vector<TangentSpace> field;
  for (const Vec3& p : mesh.positions) {
    field.push_back({normalized({p.y() + 0.1, -p.x(), 0.3 * p.z()}),
                     normalized({0.2, p.z(), 1 + p.x()}), 1 + p.x() * p.x(), 2 + std::abs(p.z())});
  }
  return field;
}

template <class Body>
void for_teams(Body&& body) {
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    for (const Backend backend : {Backend::tbb, Backend::openmp}) {
      SCOPED_TRACE(testing::Message() << threads << " threads of backend " << int(backend));
      Scheduler scheduler(threads, backend);
      body(scheduler);
    }
  }
}

std::vector<MeshGraphOptions> all_options(const Mesh& mesh) {
  std::vector<MeshGraphOptions> all;
  for (const GraphKind kind : all_kinds) {
    for (const Norm norm_kind : {Norm::geodesic, Norm::manhattan, Norm::linf}) {
      all.push_back({kind, norm_kind, {}});
      all.push_back({kind, norm_kind, swirl(mesh)});
    }
    all.push_back({kind, Norm::geodesic, swirl(mesh), Averaging::pairwise});
  }
  return all;
}

bool same_spaces(const std::vector<TangentSpace>& a, const std::vector<TangentSpace>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const TangentSpace& s, const TangentSpace& t) {
                      return s.tangent == t.tangent && s.bitangent == t.bitangent &&
                             s.tangent_magnitude == t.tangent_magnitude &&
                             s.bitangent_magnitude == t.bitangent_magnitude;
                    });
}

void expect_executors_agree(const Mesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  const MeshFacts facts = check_mesh(mesh, edges);
  const std::vector<TangentSpace> field = curvature_field(mesh, edges);
  const std::vector<TangentSpace> crosses = cross_field(mesh, edges);
  const std::vector<MeshGraphOptions> options = all_options(mesh);
  std::vector<MeshGraph> expected;
  expected.reserve(options.size());
  for (const MeshGraphOptions& o : options) expected.push_back(make_mesh_graph(mesh, edges, o));
  for_teams([&](Scheduler& scheduler) {
    expect_same(find_edges(mesh, scheduler), edges);
    expect_same(check_mesh(mesh, edges, scheduler), facts);
    EXPECT_TRUE(same_spaces(curvature_field(mesh, edges, scheduler), field));
    EXPECT_TRUE(same_spaces(cross_field(mesh, edges, scheduler), crosses));
    for (std::size_t i = 0; i < options.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "options " << i);
      expect_same(make_mesh_graph(mesh, edges, options[i], scheduler), expected[i]);
    }
  });
}

TEST(ParallelGraph, OfRegularShapes) {
  expect_executors_agree(creature(1500, 1));
  expect_executors_agree(icosphere(700));
  expect_executors_agree(torus(600, 1));
  expect_executors_agree(irregular_plane(600, 1));
  expect_executors_agree(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
}

//  A book of four pages, one of them three times, one of them twice; a triangle of its own, also
//  named the other way round; triangles naming a vertex twice or without area; an edge without
//  length; vertices of no triangle.
Mesh untidy() {
  return {{{0, 0, 0},
           {0, 0, 1},
           {1, 0, 0},
           {0, 1, 0},
           {-1, 0, 0},
           {0, -1, 1},
           {5, 5, 5},
           {6, 5, 5},
           {5, 6, 5},
           {7, 7, 7},
           {0, 0, 0},
           {0, 0, 2}},
          {{0, 1, 2},
           {0, 1, 3},
           {1, 0, 4},
           {0, 1, 5},
           {2, 1, 0},
           {1, 2, 0},
           {3, 0, 1},
           {6, 7, 8},
           {8, 7, 6},
           {6, 7, 7},
           {0, 10, 2},
           {0, 1, 11},
           {9, 9, 9}}};
}

TEST(ParallelGraph, OfUntidyMeshes) {
  expect_executors_agree(untidy());
  Mesh point = creature(600, 2);
  for (Vec3& p : point.positions) p = Vec3(1, 2, 3);
  expect_executors_agree(point);
  Mesh worn = torus(900, 3);
  for (std::size_t t = 0; t < 300; t += 7) worn.triangles.push_back(worn.triangles[2 * t]);
  for (std::size_t t = 0; t < 600; t += 5) {
    std::swap(worn.triangles[t][0], worn.triangles[t][1]);
    worn.triangles[t + 1][0] = worn.triangles[t + 1][1];
  }
  worn.positions.resize(worn.positions.size() + 5, Vec3(-9, 0, 0));
  expect_executors_agree(worn);
}

// Large enough for the ranges of all stages to be shared among the threads; in several components,
// and in an order in which neighbours are far apart.
TEST(ParallelGraph, OfALargeScatteredMesh) {
  Mesh mesh = creature(30'000, 1);
  for (const Mesh& more : {torus(12'000, 2), untidy(), irregular_plane(10'000, 4)}) {
    const auto offset = static_cast<VertexId>(mesh.vertex_count());
    for (const Vec3& p : more.positions) mesh.positions.emplace_back(p + Vec3(3, 0, 0));
    for (const Triangle& t : more.triangles) {
      mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    std::swap(mesh.triangles[t], mesh.triangles[t * 7919 % mesh.triangle_count()]);
  }
  Scheduler scheduler(3);
  const MeshEdges edges = find_edges(mesh);
  expect_same(find_edges(mesh, scheduler), edges);
  EXPECT_EQ(edges.duplicates.size(), 4U);
  expect_same(check_mesh(mesh, edges, scheduler), check_mesh(mesh, edges));
  for (const GraphKind kind : all_kinds) {
    const MeshGraphOptions options{kind, Norm::geodesic, {}};
    expect_same(make_mesh_graph(mesh, edges, options, scheduler),
                make_mesh_graph(mesh, edges, options));
  }
  const MeshGraphOptions options{GraphKind::mixed, Norm::manhattan, swirl(mesh)};
  expect_same(make_mesh_graph(mesh, edges, options, scheduler),
              make_mesh_graph(mesh, edges, options));
}

template <class Work>
std::string refusal(Work&& work) {
  try {
    work();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(ParallelGraph, IsRefusedInTheSameWords) {
  Mesh fan;
  fan.positions.assign(100'002, Vec3(0, 0, 0));
  for (VertexId v = 1; v + 1 < fan.vertex_count(); ++v) fan.triangles.push_back({0, v, v + 1});
  const MeshGraphOptions options{GraphKind::triangle_dense, Norm::geodesic, {}};
  for (const Mesh& mesh : {Mesh{}, Mesh{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}, fan}) {
    const MeshEdges edges = find_edges(mesh);
    const std::string expected = refusal([&] { make_mesh_graph(mesh, edges, options); });
    EXPECT_NE(expected, "");
    for_teams([&](Scheduler& scheduler) {
      expect_same(find_edges(mesh, scheduler), edges);
      expect_same(check_mesh(mesh, edges, scheduler), check_mesh(mesh, edges));
      EXPECT_EQ(refusal([&] { make_mesh_graph(mesh, edges, options, scheduler); }), expected);
    });
  }
}

// Parts that share vertices and edges, and have holes, are joined by several threads at once.
TEST(ParallelTopology, IsTheSameWithAnyNumberOfThreads) {
  Mesh mesh = irregular_plane(20000, 1);
  for (std::uint32_t i = 0; i < 3000; ++i) {
    Triangle& t = mesh.triangles[random_number(1, i, mesh.triangle_count())];
    t[random_number(2, i, 3)] = random_number(3, i, mesh.vertex_count());
  }
  const MeshEdges edges = find_edges(mesh);
  const MeshTopology expected = find_topology(mesh, edges);
  EXPECT_GT(expected.non_manifold_vertices, 0U);
  EXPECT_GT(expected.non_manifold_edges, 0U);
  for (const std::size_t threads : {2U, 5U}) {
    Scheduler scheduler(threads);
    EXPECT_EQ(find_topology(mesh, edges, scheduler), expected) << threads;
  }
}

}  // namespace
}  // namespace geolloyd

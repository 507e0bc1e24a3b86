#include "core/seeds/seed_places.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/mesh/mesh_measure.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "tests/support/graph_kinds.h"

namespace geolloyd {
namespace {

MeshGraph graph_of(const Mesh& mesh, GraphKind kind) {
  MeshGraphOptions options;
  options.kind = kind;
  return make_mesh_graph(mesh, find_edges(mesh), options);
}

TEST(SeedPlaces, AreTheTrianglesThemselvesOrOneOfTheirCorners) {
  const Mesh mesh = icosphere(320);
  const std::vector<std::uint32_t> triangles = {7, 100, 319};
  for (const GraphKind kind : all_kinds) {
    const MeshGraph made = graph_of(mesh, kind);
    const std::vector<NodeId> seeds = seeds_at_triangles(mesh, made, triangles);
    ASSERT_EQ(seeds.size(), triangles.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const std::uint32_t id = made.input_id[seeds[i]];
      if (has_triangles(kind)) {
        EXPECT_EQ(id, made.first_triangle_id + triangles[i]);
      } else {
        const Triangle& t = mesh.triangles[triangles[i]];
        EXPECT_NE(std::find(t.begin(), t.end(), id), t.end());
      }
    }
  }
}

TEST(SeedPlaces, NearestCornerFirst) {
  // The barycentre of a flat obtuse triangle is nearest to the middle corner.
  const Mesh mesh{{{0, 0, 0}, {10, 0, 0}, {4, 1, 0}}, {{0, 1, 2}}};
  const MeshGraph made = graph_of(mesh, GraphKind::vertex);
  const std::vector<std::uint32_t> triangles = {0};
  EXPECT_EQ(made.input_id[seeds_at_triangles(mesh, made, triangles).front()], 2U);
}

TEST(SeedPlaces, AreDifferentNodesHoweverMany) {
  const Mesh mesh = icosphere(320);
  std::vector<std::uint32_t> triangles(mesh.vertex_count());
  std::iota(triangles.begin(), triangles.end(), 0U);
  const MeshGraph made = graph_of(mesh, GraphKind::vertex);
  const std::vector<NodeId> seeds = seeds_at_triangles(mesh, made, triangles);
  EXPECT_EQ(std::set<NodeId>(seeds.begin(), seeds.end()).size(), mesh.vertex_count());
  triangles.push_back(static_cast<std::uint32_t>(triangles.size()));
  EXPECT_THROW(seeds_at_triangles(mesh, made, triangles), InvalidInput);
}

TEST(SeedPlaces, StayInTheirComponent) {
  Mesh mesh = icosphere(80);
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const auto triangles = static_cast<std::uint32_t>(mesh.triangle_count());
  for (std::uint32_t v = 0; v < vertices; ++v) {  // a twin at the same place
    const Vec3 p = mesh.positions[v];
    mesh.positions.push_back(p);
  }
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const Triangle copy = mesh.triangles[t];
    mesh.triangles.push_back({copy[0] + vertices, copy[1] + vertices, copy[2] + vertices});
  }
  std::vector<std::uint32_t> of_second(vertices);
  std::iota(of_second.begin(), of_second.end(), triangles);
  const MeshGraph made = graph_of(mesh, GraphKind::vertex);
  for (const NodeId s : seeds_at_triangles(mesh, made, of_second)) {
    EXPECT_GE(made.input_id[s], vertices);
  }
}

}  // namespace
}  // namespace geolloyd

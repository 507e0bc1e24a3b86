#include "core/surface/substrate/coarse_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/disjoint_sets.h"
#include "core/mesh/spatial_order.h"
#include "core/shapes/shapes.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

struct Merging {
  std::vector<std::uint32_t> group;
  std::vector<std::uint8_t> grid_level;

  [[nodiscard]] CoarseMesh of(const FineMesh& finer) const {
    return coarsen(finer, {group, grid_level});
  }
};

Merging one_group(const FineMesh& mesh, int level) {
  return {std::vector<std::uint32_t>(mesh.vertex_count(), 0),
          std::vector<std::uint8_t>(mesh.vertex_count(), static_cast<std::uint8_t>(level))};
}

std::uint64_t cell_of(const FineMesh& mesh, const Merging& merging, VertexId v) {
  return MortonGrid(unit_box()).code(mesh.positions[v]) >> (3 * (21 - merging.grid_level[v]));
}

// Vertices of the finer mesh, by the one that stands for them.
std::vector<std::vector<VertexId>> clusters_of(const CoarseMesh& coarse) {
  std::vector<std::vector<VertexId>> clusters(coarse.mesh.vertex_count());
  for (VertexId v = 0; v < coarse.vertex_of.size(); ++v) clusters[coarse.vertex_of[v]].push_back(v);
  return clusters;
}

void expect_merged_right(const FineMesh& finer, const Merging& merging, const CoarseMesh& coarse) {
  ASSERT_EQ(coarse.vertex_of.size(), finer.vertex_count());
  DisjointSets merged(finer.vertex_count());
  for (VertexId v = 0; v < finer.vertex_count(); ++v) {
    ASSERT_LT(coarse.vertex_of[v], coarse.mesh.vertex_count());
    for (const VertexId u : finer.neighbours(v)) {
      if (coarse.vertex_of[u] == coarse.vertex_of[v]) merged.unite(u, v);
    }
  }
  for (const std::vector<VertexId>& cluster : clusters_of(coarse)) {
    ASSERT_FALSE(cluster.empty());
    for (const VertexId v : cluster) {
      EXPECT_EQ(merged.find(v), merged.find(cluster[0])) << "not connected";
      EXPECT_EQ(merging.group[v], merging.group[cluster[0]]);
      EXPECT_EQ(cell_of(finer, merging, v), cell_of(finer, merging, cluster[0]));
    }
  }
}

void expect_placed_at_means(const FineMesh& finer, const CoarseMesh& coarse) {
  const auto clusters = clusters_of(coarse);
  for (VertexId c = 0; c < clusters.size(); ++c) {
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for (const VertexId v : clusters[c]) {
      for (const TriangleId t : finer.triangles_at(v)) {
        sum += finer.area(t) * finer.positions[v];
        weight += finer.area(t);
      }
    }
    EXPECT_LE(norm(coarse.mesh.positions[c] - sum / weight), 1e-13) << c;
  }
}

// Those of three different vertices, each once, whichever way it faces.
void expect_same_triangles_merged(const FineMesh& finer, const CoarseMesh& coarse) {
  std::set<std::set<VertexId>> expected;
  for (const Triangle& t : finer.triangles) {
    const std::set<VertexId> m = {coarse.vertex_of[t[0]], coarse.vertex_of[t[1]],
                                  coarse.vertex_of[t[2]]};
    if (m.size() == 3) expected.insert(m);
  }
  std::set<std::set<VertexId>> found;
  VertexId last = 0;
  for (TriangleId t = 0; t < coarse.mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = coarse.mesh.triangles[t];
    EXPECT_TRUE(found.insert({a, b, c}).second) << "twice";
    EXPECT_LE(last, std::min({a, b, c})) << "not in order of the smallest vertices";
    last = std::min({a, b, c});
  }
  EXPECT_EQ(found, expected);
}

// A triangle that stays faces as one did that it stands for.
void expect_orientation_kept(const FineMesh& finer, const CoarseMesh& coarse) {
  std::map<std::set<VertexId>, std::set<Triangle>> turned;
  for (const Triangle& t : finer.triangles) {
    Triangle m = {coarse.vertex_of[t[0]], coarse.vertex_of[t[1]], coarse.vertex_of[t[2]]};
    std::rotate(m.begin(), std::min_element(m.begin(), m.end()), m.end());
    turned[{m[0], m[1], m[2]}].insert(m);
  }
  for (Triangle m : coarse.mesh.triangles) {
    std::rotate(m.begin(), std::min_element(m.begin(), m.end()), m.end());
    EXPECT_EQ((turned[{m[0], m[1], m[2]}].count(m)), 1U);
  }
}

std::size_t count_parts(const FineMesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  std::size_t parts = mesh.vertex_count();
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    for (const VertexId u : mesh.neighbours(v)) parts -= sets.unite(u, v) ? 1 : 0;
  }
  return parts;
}

void expect_coarse(const FineMesh& finer, const Merging& merging) {
  const CoarseMesh coarse = merging.of(finer);
  expect_merged_right(finer, merging, coarse);
  expect_placed_at_means(finer, coarse);
  expect_same_triangles_merged(finer, coarse);
  expect_orientation_kept(finer, coarse);
  EXPECT_EQ(count_parts(coarse.mesh), count_parts(finer));
}

TEST(CoarseMesh, OfShapes) {
  for (const Mesh& mesh : {icosphere(5000), torus(5000, 1), irregular_plane(5000, 1)}) {
    const FineMesh finer = surface_input_of(mesh).fine;
    std::size_t last = 0;
    for (const int level : {2, 3, 4}) {
      SCOPED_TRACE(level);
      expect_coarse(finer, one_group(finer, level));
      const std::size_t count = one_group(finer, level).of(finer).mesh.vertex_count();
      EXPECT_GT(count, last);
      last = count;
    }
    EXPECT_LT(last, finer.vertex_count() / 2);
  }
}

// As levels of sites have it: a coarse mesh is made coarser. Cells stay together in its order, or
// else too little would be merged.
TEST(CoarseMesh, OfACoarseMesh) {
  const FineMesh finest = surface_input_of(torus(20000, 1)).fine;
  FineMesh mesh = finest;
  for (const int level : {5, 4, 3}) {
    SCOPED_TRACE(level);
    const Merging merging = one_group(mesh, level);
    expect_coarse(mesh, merging);
    mesh = merging.of(mesh).mesh;
    const std::size_t at_once = one_group(finest, level).of(finest).mesh.vertex_count();
    EXPECT_LE(mesh.vertex_count(), at_once + at_once / 10);
  }
}

TEST(CoarseMesh, MergesNoGroups) {
  const FineMesh finer = surface_input_of(icosphere(3000)).fine;
  for (std::uint32_t groups = 2; groups < 6; ++groups) {
    Merging merging = one_group(finer, 4);
    for (VertexId v = 0; v < finer.vertex_count(); ++v) {
      merging.group[v] = random_number(groups, v, 10) == 0 ? random_number(1, v, groups) : 0;
    }
    const CoarseMesh coarse = merging.of(finer);
    expect_merged_right(finer, merging, coarse);
    expect_same_triangles_merged(finer, coarse);
  }
}

// Each part has its own level.
TEST(CoarseMesh, HasLevelsByVertex) {
  Mesh several = icosphere(2000);
  add_mesh(several, icosphere(2000), {1.2, 0, 0}, 0.1);
  const SurfaceInput input = surface_input_of(several);
  Merging merging = one_group(input.fine, 0);
  for (VertexId v = 0; v < input.fine.vertex_count(); ++v) {
    merging.grid_level[v] = norm(input.frame.to_mesh(input.fine.positions[v])) > 1.05 ? 6 : 3;
  }
  expect_coarse(input.fine, merging);
  const CoarseMesh coarse = merging.of(input.fine);
  std::size_t small = 0;
  for (const Vec3& p : coarse.mesh.positions) small += norm(input.frame.to_mesh(p)) > 1.05 ? 1 : 0;
  EXPECT_GT(small, 30U);
  EXPECT_GT(coarse.mesh.vertex_count() - small, 30U);
}

TEST(CoarseMesh, KeepsSheetsApart) {
  for (const double gap : {1e-2, 1e-5, 0.0}) {
    Mesh sheets = irregular_plane(3000, 1);
    add_mesh(sheets, irregular_plane(3000, 1), {0, 0, gap});
    add_mesh(sheets, irregular_plane(2000, 2), {0, 0, 2 * gap});
    const SurfaceInput input = surface_input_of(sheets);
    ASSERT_EQ(input.parts, 3U);
    expect_coarse(input.fine, one_group(input.fine, 4));
    const CoarseMesh coarse = one_group(input.fine, 4).of(input.fine);
    EXPECT_LT(coarse.mesh.vertex_count(), input.fine.vertex_count() / 4);
    std::vector<std::uint32_t> part(coarse.mesh.vertex_count(), no_id);
    for (VertexId v = 0; v < input.fine.vertex_count(); ++v) {
      std::uint32_t& of_coarse = part[coarse.vertex_of[v]];
      if (of_coarse == no_id) of_coarse = input.part[v];
      EXPECT_EQ(of_coarse, input.part[v]);
    }
  }
}

TEST(CoarseMesh, OfTheFinestGridIsTheSame) {
  const FineMesh finer = surface_input_of(creature(1000, 1)).fine;
  const CoarseMesh coarse = one_group(finer, 21).of(finer);
  EXPECT_EQ(coarse.mesh.vertex_count(), finer.vertex_count());
  EXPECT_EQ(coarse.mesh.triangle_count(), finer.triangle_count());
  for (VertexId v = 0; v < finer.vertex_count(); ++v) EXPECT_EQ(coarse.vertex_of[v], v);
}

TEST(CoarseMesh, OfOneCellIsAPoint) {
  const FineMesh finer = surface_input_of(icosphere(300)).fine;
  const CoarseMesh coarse = one_group(finer, 0).of(finer);
  EXPECT_EQ(coarse.mesh.vertex_count(), 1U);
  EXPECT_EQ(coarse.mesh.triangle_count(), 0U);
  EXPECT_LE(norm(coarse.mesh.positions[0]), 1e-2);
}

// Cells wider than legs and tail.
TEST(CoarseMesh, OfThinLimbsStaysConnected) {
  const FineMesh finer = surface_input_of(creature(8000, 1)).fine;
  for (const int level : {1, 2, 3, 4, 5}) {
    SCOPED_TRACE(level);
    expect_coarse(finer, one_group(finer, level));
  }
}

TEST(CoarseMesh, OfAWireStaysConnected) {
  Mesh wire = cylinder(3000, 1);
  for (Vec3& p : wire.positions)
    p = {0.01 * p.x() + 0.7 * p.z(), 0.01 * p.y() - 0.4 * p.z(), p.z()};
  const FineMesh finer = surface_input_of(wire).fine;
  for (const int level : {2, 3, 4, 5}) expect_coarse(finer, one_group(finer, level));
}

}  // namespace
}  // namespace geolloyd

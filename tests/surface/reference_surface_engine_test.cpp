#include "core/surface/cells/reference_surface_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/shapes/shapes.h"
#include "core/surface/cells/cell_pieces.h"
#include "tests/support/brute_cells.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

// The rule of surface_engine.h.
RegionId label_by_the_rule(const FineMesh& mesh, const std::vector<RegionId>& labels,
                           const std::vector<Vec3>& sites, VertexId v) {
  std::vector<RegionId> offered = {labels[v]};
  for (const VertexId u : mesh.neighbours(v)) offered.push_back(labels[u]);
  std::erase(offered, no_id);
  if (offered.empty()) return no_id;
  const auto rank = [&](RegionId r) {
    const Vec3 away = mesh.positions[v] - sites[r];
    return std::pair(dot(away, away), r);
  };
  return std::ranges::min(offered, {}, rank);
}

// That of equal distances as of others.
std::vector<RegionId> sweep_by_the_rule(const FineMesh& mesh, const SitedMesh& sited) {
  std::vector<RegionId> labels = sited.labels;
  while (true) {
    std::vector<RegionId> next = labels;
    for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
      if (sited.is_fixed[v] == 0) next[v] = label_by_the_rule(mesh, labels, sited.sites, v);
    }
    if (next == labels) return labels;
    labels = next;
  }
}

RegionId nearest_site(const std::vector<Vec3>& sites, const Vec3& p) {
  const auto nearest = std::ranges::min_element(
      sites, {}, [&](const Vec3& site) { return dot(site - p, site - p); });
  return static_cast<RegionId>(nearest - sites.begin());
}

Moments sum_of_triangles(const FineMesh& mesh) {
  const MomentUnit unit(mesh.whole_area);
  Moments sum;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) sum += moments_of(mesh, unit, t);
  return sum;
}

Moments sum_of(std::span<const Moments> cells) {
  Moments sum;
  for (const Moments& cell : cells) sum += cell;
  return sum;
}

void expect_by_the_rule(const FineMesh& mesh, const SitedMesh& sited) {
  const auto engine = make_reference_surface_engine(mesh);
  engine->assign(sited.labels, sited.is_fixed);
  const std::span<const Moments> cells = engine->evaluate(sited.sites).moments;
  EXPECT_EQ(engine->labels(), sweep_by_the_rule(mesh, sited));
  const std::vector<Moments> first(cells.begin(), cells.end());
  ASSERT_EQ(first.size(), sited.sites.size());
  EXPECT_EQ(sum_of(first), sum_of_triangles(mesh));
  // A fixed point.
  const std::vector<RegionId> labels = engine->labels();
  EXPECT_TRUE(std::ranges::equal(engine->evaluate(sited.sites).moments, first));
  EXPECT_EQ(engine->labels(), labels);
}

std::vector<FineMesh> small_surfaces() {
  Mesh several = icosphere(180);
  add_mesh(several, irregular_plane(100, 1), {3, 0, 0});
  std::vector<FineMesh> surfaces;
  for (const Mesh& mesh : {irregular_plane(300, 1), icosphere(320), torus(400, 1), several}) {
    surfaces.push_back(surface_input_of(mesh).fine);
  }
  return surfaces;
}

TEST(ReferenceSurfaceEngine, SweepsByTheRule) {
  for (const FineMesh& mesh : small_surfaces()) {
    for (const std::size_t count : {2U, 7U, 30U, 120U}) {
      expect_by_the_rule(mesh, spread_sites(mesh, count));
    }
  }
}

// Sites anywhere, labels in no order, vertices that keep theirs.
TEST(ReferenceSurfaceEngine, SweepsAnyLabelsByTheRule) {
  for (const FineMesh& mesh : small_surfaces()) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const RegionId count = 2 + random_number(seed, 0, 40);
      SitedMesh sited = spread_sites(mesh, count);
      for (RegionId r = 0; r < count; ++r) sited.sites[r] = random_point(seed, r + 1);
      for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
        sited.labels[v] = random_number(seed, 1000 + v, count);
        sited.is_fixed[v] = random_number(seed, 5000 + v, 5) == 0 ? 1 : 0;
      }
      expect_by_the_rule(mesh, sited);
    }
  }
}

// On a grid most vertices are as far from one site as from another.
TEST(ReferenceSurfaceEngine, PrefersTheSmallestOfEquals) {
  Mesh grid;
  for (VertexId row = 0; row <= 16; ++row) {
    for (VertexId column = 0; column <= 16; ++column) {
      grid.positions.emplace_back(column / 16.0, row / 16.0, 0);
      if (row == 16 || column == 16) continue;
      const VertexId a = row * 17 + column;
      grid.triangles.push_back({a, a + 1, a + 18});
      grid.triangles.push_back({a, a + 18, a + 17});
    }
  }
  const FineMesh mesh = surface_input_of(grid).fine;
  for (const std::size_t count : {2U, 5U, 16U}) {
    SitedMesh sited = spread_sites(mesh, count);
    expect_by_the_rule(mesh, sited);
    for (Vec3& site : sited.sites) site = Vec3::Zero();
    expect_by_the_rule(mesh, sited);
  }
  // Two sites at one place, the larger at every vertex but one.
  SitedMesh twice{{Vec3::Zero(), Vec3::Zero()},
                  std::vector<RegionId>(mesh.vertex_count(), 1),
                  std::vector<std::uint8_t>(mesh.vertex_count(), 0)};
  twice.labels[100] = 0;
  const auto engine = make_reference_surface_engine(mesh);
  engine->assign(twice.labels, twice.is_fixed);
  EXPECT_EQ(engine->evaluate(twice.sites).moments[0], sum_of_triangles(mesh));
}

TEST(ReferenceSurfaceEngine, LeavesAPartWithoutASiteAlone) {
  const FineMesh mesh = surface_input_of([] {
                          Mesh sheets = irregular_plane(200, 1);
                          add_mesh(sheets, irregular_plane(200, 2), {0, 0, 1e-4});
                          return sheets;
                        }())
                            .fine;
  std::vector<VertexId> lower;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.positions[v].z() < 0) lower.push_back(v);
  }
  const SitedMesh sited = put_sites(mesh, {lower[3], lower[70]});
  const auto engine = make_reference_surface_engine(mesh);
  engine->assign(sited.labels, sited.is_fixed);
  const Moments sum = sum_of(engine->evaluate(sited.sites).moments);
  EXPECT_NEAR(MomentUnit(mesh.whole_area).area(sum), mesh.whole_area / 2, 1e-12);
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(engine->labels()[v] == no_id, mesh.positions[v].z() > 0) << v;
  }
}

// The cells are those of the Voronoi diagram of all sites, but for the tips of cells: a vertex
// whose neighbours all have other sites, a triangle into which a cell pokes that has none of the
// vertices about it. What is not the nearest site's only adds energy.
void expect_voronoi_cells(const FineMesh& mesh, const SitedMesh& sited) {
  const auto engine = make_reference_surface_engine(mesh);
  engine->assign(sited.labels, sited.is_fixed);
  const std::span<const Moments> cells = engine->evaluate(sited.sites).moments;
  std::size_t vertices_amiss = 0;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const RegionId nearest = nearest_site(sited.sites, mesh.positions[v]);
    vertices_amiss += engine->labels()[v] != nearest ? 1 : 0;
  }
  EXPECT_LE(vertices_amiss, mesh.vertex_count() / 300);
  const std::vector<PieceMoments> expected = brute::cells_of(mesh, sited.sites);
  const MomentUnit unit(mesh.whole_area);
  double amiss = 0;
  double energy = 0;
  double least_energy = 0;
  for (std::size_t r = 0; r < cells.size(); ++r) {
    EXPECT_NEAR(unit.area(cells[r]), expected[r].area, 0.03 * expected[r].area) << r;
    amiss += std::abs(unit.area(cells[r]) - expected[r].area);
    energy += unit.energy(cells[r], sited.sites[r]);
    least_energy += brute::energy(expected[r], sited.sites[r]);
  }
  EXPECT_LE(amiss, 1e-3 * mesh.whole_area);
  EXPECT_GE(energy, least_energy * (1 - 1e-12));
  EXPECT_LE(energy, least_energy * (1 + 1e-4));
}

TEST(ReferenceSurfaceEngine, HasTheVoronoiCellsOfAPlane) {
  const FineMesh mesh = surface_input_of(irregular_plane(2000, 1)).fine;
  for (const std::size_t count : {5U, 20U, 40U}) {
    expect_voronoi_cells(mesh, spread_sites(mesh, count));
  }
}

// Cells far smaller than the radii, from where no other sheet is nearer.
TEST(ReferenceSurfaceEngine, HasTheVoronoiCellsOfCurvedSurfaces) {
  const FineMesh sphere = surface_input_of(icosphere(2000)).fine;
  expect_voronoi_cells(sphere, spread_sites(sphere, 40));
  const FineMesh ring = surface_input_of(torus(2500, 1)).fine;
  expect_voronoi_cells(ring, spread_sites(ring, 60));
}

// Fejes Toth: no cell of its area has less energy than a regular hexagon about its site.
TEST(ReferenceSurfaceEngine, MeasuresHexagons) {
  const FineMesh mesh = surface_input_of(irregular_plane(20000, 1)).fine;
  const double spacing = 0.14;
  SitedMesh sited = spread_sites(mesh, 1);
  sited.sites.clear();
  std::vector<RegionId> inner;
  for (int row = -8; row <= 8; ++row) {
    for (int column = -8; column <= 8; ++column) {
      const Vec3 site((column + 0.5 * (row & 1)) * spacing, row * std::sqrt(0.75) * spacing, 0);
      if (site.cwiseAbs().maxCoeff() > 0.5) continue;
      if (site.cwiseAbs().maxCoeff() < 0.5 - spacing) {
        inner.push_back(static_cast<RegionId>(sited.sites.size()));
      }
      sited.sites.push_back(site);
    }
  }
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    sited.labels[v] = nearest_site(sited.sites, mesh.positions[v]);
  }
  const auto engine = make_reference_surface_engine(mesh);
  engine->assign(sited.labels, sited.is_fixed);
  const std::span<const Moments> cells = engine->evaluate(sited.sites).moments;
  const MomentUnit unit(mesh.whole_area);
  const double area = std::sqrt(0.75) * spacing * spacing;
  const double energy = 5 / (18 * std::sqrt(3)) * area * area;
  ASSERT_GT(inner.size(), 15U);
  for (const RegionId r : inner) {
    EXPECT_NEAR(unit.area(cells[r]), area, 1e-10 * area);
    EXPECT_NEAR(unit.energy(cells[r], sited.sites[r]), energy, 1e-9 * energy);
    EXPECT_LE(norm(unit.centroid(cells[r]) - sited.sites[r]), 1e-10 * spacing);
  }
}

}  // namespace
}  // namespace geolloyd

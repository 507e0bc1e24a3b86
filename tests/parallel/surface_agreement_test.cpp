// The incremental surface engine against the reference: after each evaluation the same labels and
// moments to the bit, on any number of threads, by both backends. And the stages about it: the same
// bits by the threads of a scheduler as by the calling thread.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/support/same_bytes.h"
#include "core/fields/curvature_field.h"
#include "core/shapes/shapes.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/surface/result/remesh.h"
#include "core/surface/result/site_places.h"
#include "core/surface/sites/site_descent.h"
#include "core/surface/substrate/coarse_mesh.h"
#include "geolloyd/threads.h"
#include "parallel/surface/parallel_surface_engine.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/agreement.h"
#include "tests/support/random_graph.h"
#include "tests/support/sanitizers.h"
#include "tests/support/sharp_solids.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

// Under a sanitizer, the odd ones.
template <class Body>
void for_schedulers(Body&& body) {
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    if (under_sanitizer && threads % 2 == 0) continue;
    for (const Backend backend : all_backends) {
      SCOPED_TRACE(testing::Message()
                   << threads << " threads of backend " << static_cast<int>(backend));
      Scheduler scheduler(threads, backend);
      body(scheduler);
    }
  }
}

// What an engine is told: new labels now and then, and sites.
struct Turn {
  bool is_new = false;
  SitedMesh sited;  ///< labels where they are new
};

double spacing_of(const FineMesh& mesh, std::size_t sites) {
  return std::sqrt(mesh.whole_area / static_cast<double>(sites));
}

// Other labels while the same vertices keep theirs: a few of them, all of them with sites that
// changed places, of more sites and of fewer. Some come right after others.
void add_turns_of_labels(const FineMesh& mesh, SitedMesh sited, std::uint64_t random_seed,
                         std::vector<Turn>& turns) {
  const auto add_site = [&](std::uint64_t n) {
    sited.sites.push_back(mesh.positions[random_number(random_seed, n, mesh.vertex_count())]);
  };
  for (std::uint64_t round = 0; round < 12; ++round) {
    const std::uint64_t n = 10'000 * (round + 1);
    if (round % 4 == 1) std::swap(sited.sites.front(), sited.sites.back());
    if (round % 4 == 2) add_site(n);
    if (round % 4 == 3 && sited.sites.size() > 2) sited.sites.resize(sited.sites.size() - 2);
    const auto count = static_cast<RegionId>(sited.sites.size());
    for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
      const bool changes = random_number(random_seed, n + 2 * v, 20) == 0;
      const bool is_gone = sited.labels[v] != no_id && sited.labels[v] >= count;
      if (changes || is_gone) sited.labels[v] = random_number(random_seed, n + 2 * v + 1, count);
    }
    turns.push_back({true, sited});
    for (RegionId r = 0; r < count; ++r) sited.sites[r] += random_point(random_seed + n, r, 0.01);
    turns.push_back({round % 3 == 0, sited});
  }
}

// Sites that barely move, that move by some spacings, that stay, that jump anywhere and back;
// labels from a vertex for each site, of no order, with vertices that keep theirs.
std::vector<Turn> turns_on(const FineMesh& mesh, RegionId count, std::uint64_t random_seed) {
  std::vector<Turn> turns;
  const auto draw = [&](std::uint64_t n, std::uint64_t bound) {
    return random_number(random_seed, n, bound);
  };
  SitedMesh sited = spread_sites(mesh, count);
  const double spacing = spacing_of(mesh, count);
  for (std::uint64_t assignment = 0; assignment < 3; ++assignment) {
    if (assignment > 0) {
      for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
        const std::uint64_t n = 100 * (v + 1) + 10 * assignment;
        sited.labels[v] = assignment == 1   ? draw(n, count)
                          : draw(n, 9) == 0 ? draw(n + 1, count)
                                            : no_id;
        sited.is_fixed[v] = sited.labels[v] != no_id && draw(n + 2, 8) == 0 ? 1 : 0;
      }
    }
    turns.push_back({true, sited});
    std::uint64_t n = 1000 * assignment;
    for (const double move : {0.0, 1e-6, 0.01, 0.3, 0.1, 0.0, 2.0, 0.02, 100.0, 0.3}) {
      const SitedMesh before = sited;
      for (RegionId r = 0; r < count; ++r) {
        const bool moves = move > 0.2 || draw(n + r, 2) == 0;
        if (moves) sited.sites[r] += random_point(random_seed + n, r, move * spacing);
      }
      turns.push_back({false, sited});
      if (move > 1) sited = before;
      ++n;
    }
  }
  add_turns_of_labels(mesh, sited, random_seed, turns);
  return turns;
}

struct Evaluated {
  Cells cells;
  std::vector<RegionId> labels;
};

void run_turns(SurfaceEngine& engine, const std::vector<Turn>& turns,
               const std::function<void(std::size_t, const Evaluated&)>& visit) {
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (turns[i].is_new) {
      const std::vector<RegionId> none(turns[i].sited.labels.size(), no_id);
      if (i % 5 == 0) engine.assign(none, turns[i].sited.is_fixed);
      if (i % 3 == 0) engine.assign(none, std::vector<std::uint8_t>(none.size(), 1));
      engine.assign(turns[i].sited.labels, turns[i].sited.is_fixed);
    }
    const Cells cells = engine.evaluate(turns[i].sited.sites);
    ASSERT_EQ(engine.cells(), cells) << "turn " << i;
    visit(i, {cells, engine.labels()});
  }
}

void expect_turns_agree(const FineMesh& mesh, const std::vector<Turn>& turns) {
  std::vector<Evaluated> expected;
  run_turns(*make_reference_surface_engine(mesh), turns,
            [&](std::size_t, const Evaluated& evaluated) { expected.push_back(evaluated); });
  for_schedulers([&](Scheduler& scheduler) {
    run_turns(*make_parallel_surface_engine(mesh, scheduler), turns,
              [&](std::size_t i, const Evaluated& evaluated) {
                ASSERT_EQ(evaluated.labels, expected[i].labels) << "turn " << i;
                ASSERT_EQ(evaluated.cells, expected[i].cells) << "turn " << i;
              });
  });
}

void expect_engines_agree(const FineMesh& mesh, RegionId count, std::uint64_t random_seed) {
  expect_turns_agree(mesh, turns_on(mesh, count, random_seed));
}

FineMesh coarse_creature() {
  const FineMesh fine = surface_input_of(creature(6000, 1)).fine;
  const std::vector<std::uint32_t> group(fine.vertex_count(), 0);
  const std::vector<std::uint8_t> level(fine.vertex_count(), 4);
  return coarsen(fine, {group, level}).mesh;
}

TEST(SurfaceEngines, AgreeOnClosedMeshes) {
  expect_engines_agree(surface_input_of(icosphere(1500)).fine, 25, 1);
  expect_engines_agree(surface_input_of(torus(2000, 1)).fine, 60, 2);
}

TEST(SurfaceEngines, AgreeOnOpenMeshes) {
  expect_engines_agree(surface_input_of(irregular_plane(1500, 1)).fine, 40, 3);
  expect_engines_agree(surface_input_of(cylinder(1500, 1)).fine, 10, 4);
}

// A part that never has a site, parts that have one, and some of one triangle.
TEST(SurfaceEngines, AgreeOnSeveralParts) {
  Mesh mesh = icosphere(500);
  add_mesh(mesh, irregular_plane(500, 1), {3, 0, 0});
  add_mesh(mesh, torus(500, 1), {0, 3, 0});
  for (std::uint64_t i = 0; i < 20; ++i) {
    add_mesh(mesh, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, random_point(1, i, 3), 0.05);
  }
  expect_engines_agree(surface_input_of(mesh).fine, 12, 5);
}

// No manifold: edges of three triangles, and edges of none.
TEST(SurfaceEngines, AgreeOnACoarseMesh) {
  expect_engines_agree(coarse_creature(), 30, 6);
  FineMesh coarser = coarse_creature();
  const std::vector<std::uint32_t> group(coarser.vertex_count(), 0);
  const std::vector<std::uint8_t> level(coarser.vertex_count(), 2);
  expect_engines_agree(coarsen(coarser, {group, level}).mesh, 8, 7);
}

// Large enough that the threads share all loops.
TEST(SurfaceEngines, AgreeOnALargeMesh) {
  expect_engines_agree(surface_input_of(torus(20'000, 1)).fine, 300, 8);
}

// A metric that varies wildly from vertex to vertex.
TEST(SurfaceEngines, AgreeInAMetric) {
  FineMesh mesh = surface_input_of(torus(3000, 1)).fine;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    mesh.metric.push_back(0.1 * Metric{} + Metric::square_of(random_point(1, v, 2)));
  }
  connect(mesh);
  expect_engines_agree(mesh, 60, 11);
}

TEST(SurfaceEngines, AgreeWithOneSiteAndWithOneAtEachVertex) {
  const FineMesh mesh = surface_input_of(icosphere(180)).fine;
  expect_engines_agree(mesh, 1, 9);
  expect_engines_agree(mesh, static_cast<RegionId>(mesh.vertex_count()), 10);
}

// More sites than one range of a loop.
// Sites that no vertex is labelled with may be left out without new labels.
TEST(SurfaceEngines, AgreeOnFewerSites) {
  const FineMesh mesh = surface_input_of(icosphere(300)).fine;
  SitedMesh sited = spread_sites(mesh, 9);
  for (RegionId& label : sited.labels) {
    if (label != no_id && label >= 5) label = no_id;
  }
  std::vector<Turn> turns = {{true, sited}};
  sited.sites.resize(5);
  turns.push_back({false, sited});
  expect_turns_agree(mesh, turns);
}

TEST(SurfaceEngines, LetSitesDescendAlike) {
  const FineMesh mesh = surface_input_of(torus(36'000, 1)).fine;
  const SitedMesh sited = spread_sites(mesh, 4500);
  std::vector<std::uint8_t> is_fixed(sited.sites.size(), 0);
  for (std::size_t r = 0; r < is_fixed.size(); r += 7) is_fixed[r] = 1;
  const auto descend_by = [&](SurfaceEngine& engine, Executor& executor) {
    engine.assign(sited.labels, sited.is_fixed);
    std::vector<Vec3> sites = sited.sites;
    std::vector<double> numbers;
    DescentOptions options{is_fixed,
                           5,
                           0.5 * spacing_of(mesh, sites.size()),
                           {},
                           0,
                           [&](double energy, std::span<const Vec3>) {
                             numbers.push_back(energy);
                             return true;
                           }};
    numbers.push_back(descend(mesh, engine, sites, options, executor));
    for (const Vec3& p : sites) numbers.insert(numbers.end(), p.begin(), p.end());
    for (const RegionId r : engine.labels()) numbers.push_back(r);
    return numbers;
  };
  const auto expected = descend_by(*make_reference_surface_engine(mesh), sequential());
  for_schedulers([&](Scheduler& scheduler) {
    const auto engine = make_parallel_surface_engine(mesh, scheduler);
    EXPECT_TRUE(same_bytes(descend_by(*engine, scheduler), expected));
  });
}

void expect_same(const FineMesh& a, const FineMesh& b) {
  EXPECT_TRUE(same_bytes(a.positions, b.positions));
  EXPECT_TRUE(same_bytes(a.triangles, b.triangles));
  EXPECT_TRUE(same_bytes(a.across_open, b.across_open));
  EXPECT_TRUE(same_bytes(a.first_neighbour, b.first_neighbour));
  EXPECT_TRUE(same_bytes(a.neighbour, b.neighbour));
  EXPECT_TRUE(same_bytes(a.first_triangle, b.first_triangle));
  EXPECT_TRUE(same_bytes(a.triangle_at, b.triangle_at));
  EXPECT_TRUE(same_bytes(a.whole_area, b.whole_area));
}

// In several parts, with triangles stuck on, some of them at one vertex, and some edges to split.
Mesh untidy_mesh() {
  Mesh mesh = creature(12'000, 1);
  add_mesh(mesh, icosphere(20), {2, 0, 0});
  add_mesh(mesh, irregular_plane(4000, 1), {0, 3, 0});
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto count = mesh.vertex_count();
    mesh.triangles.push_back({random_number(1, 3 * i, count), random_number(1, 3 * i + 1, 500),
                              random_number(1, 3 * i + 2, 9)});
  }
  return mesh;
}

TEST(SurfaceStages, MakeTheSameInput) {
  const Mesh mesh = untidy_mesh();
  const SurfaceInput expected = surface_input_of(mesh, 0.1);
  EXPECT_GT(expected.fine.vertex_count(), 3 * small_items);
  for_schedulers([&](Scheduler& scheduler) {
    const SurfaceInput input = surface_input_of(mesh, 0.1, scheduler);
    expect_same(input.fine, expected.fine);
    EXPECT_TRUE(same_bytes(input.origin, expected.origin));
    EXPECT_TRUE(same_bytes(input.boundary_edges, expected.boundary_edges));
    EXPECT_TRUE(same_bytes(input.part, expected.part));
    EXPECT_EQ(input.parts, expected.parts);
    EXPECT_EQ(input.frame.middle, expected.frame.middle);
    EXPECT_EQ(input.frame.scale, expected.frame.scale);
  });
}

TEST(SurfaceStages, MakeTheSameCoarseMeshes) {
  const FineMesh fine = surface_input_of(untidy_mesh(), 0.1).fine;
  std::vector<std::uint32_t> group(fine.vertex_count());
  for (VertexId v = 0; v < group.size(); ++v) group[v] = random_number(1, v, 20) == 0 ? 1 : 0;
  for (const std::uint8_t level : std::initializer_list<std::uint8_t>{4, 7}) {
    const std::vector<std::uint8_t> levels(fine.vertex_count(), level);
    const CoarseMesh expected = coarsen(fine, {group, levels});
    for_schedulers([&](Scheduler& scheduler) {
      const CoarseMesh coarse = coarsen(fine, {group, levels}, scheduler);
      expect_same(coarse.mesh, expected.mesh);
      EXPECT_TRUE(same_bytes(coarse.vertex_of, expected.vertex_of));
    });
  }
}

TEST(SurfaceStages, PlaceSitesAlike) {
  const Mesh mesh = torus(8000, 1);
  const SurfaceInput input = surface_input_of(mesh);
  const SitedMesh sited = spread_sites(input.fine, 700);
  const auto engine = make_reference_surface_engine(input.fine);
  engine->assign(sited.labels, sited.is_fixed);
  engine->evaluate(sited.sites);
  std::vector<Vec3> sites = sited.sites;
  for (std::size_t r = 0; r < sites.size(); ++r) sites[r] += random_point(1, r, 0.02);
  const auto expected = place_sites(mesh, input, sites, engine->labels());
  for_schedulers([&](Scheduler& scheduler) {
    const auto places = place_sites(mesh, input, sites, engine->labels(), scheduler);
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t r = 0; r < places.size(); ++r) {
      EXPECT_EQ(places[r].triangle, expected[r].triangle);
      EXPECT_EQ(places[r].barycentric, expected[r].barycentric);
    }
  });
}

// By the reference alone, and by the incremental engine on all threads.
void expect_same_remesh(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options) {
  const Remesh expected = make_remesh(mesh, edges, options, reference_runtime());
  EXPECT_TRUE(expected.has_input_topology());
  for_schedulers([&](Scheduler& scheduler) {
    Threads runtime(scheduler);
    const Remesh remesh = make_remesh(mesh, edges, options, runtime);
    EXPECT_EQ(remesh.fingerprint, expected.fingerprint);
    EXPECT_TRUE(same_bytes(remesh.mesh.positions, expected.mesh.positions));
    EXPECT_TRUE(same_bytes(remesh.edge_lengths, expected.edge_lengths));
  });
}

TEST(SurfaceStages, MakeTheSameRemeshInAMetric) {
  const Mesh mesh = torus(1000, 1);
  const MeshEdges edges = find_edges(mesh);
  RemeshOptions options;
  options.vertex_count = 60;
  options.field = curvature_field(mesh, edges);
  expect_same_remesh(mesh, edges, options);
}

TEST(SurfaceStages, MakeTheSameAdaptedRemesh) {
  const Mesh mesh = creature(under_sanitizer ? 2000 : 6000, 1);
  RemeshOptions options;
  options.vertex_count = under_sanitizer ? 100 : 300;
  options.sizing.adapt = 1;
  expect_same_remesh(mesh, find_edges(mesh), options);
}

TEST(SurfaceStages, FitTheSameCurves) {
  const Mesh plate = pierced_plate(0.4, 0.3, 64);
  RemeshOptions options;
  options.vertex_count = 150;
  expect_same_remesh(plate, find_edges(plate), options);
}

TEST(SurfaceStages, MakeTheSameRemeshOfEqualError) {
  const Mesh mesh = creature(under_sanitizer ? 2000 : 6000, 1);
  RemeshOptions options;
  options.vertex_count = under_sanitizer ? 100 : 300;
  options.sizing.equal_error = true;
  expect_same_remesh(mesh, find_edges(mesh), options);
}

}  // namespace
}  // namespace geolloyd

#include "tools/evaluation/ground_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "parallel/engine/parallel_engine.h"
#include "tests/support/graph_kinds.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

using nlohmann::json;

/// A mesh, its graph, some seeds and their partition.
struct Case {
  Mesh mesh;
  MeshGraph mesh_graph;
  std::vector<NodeId> seeds;
  Partition partition;

  Case(Mesh whole, GraphKind kind, std::vector<NodeId> chosen)
      : mesh(std::move(whole)),
        mesh_graph(make_mesh_graph(mesh, find_edges(mesh), {kind, Norm::geodesic, {}})),
        seeds(std::move(chosen)) {
    Scheduler scheduler(1);
    const auto engine = make_parallel_engine(scheduler, mesh_graph.graph);
    engine->partition(seeds);
    partition = engine->current();
  }

  [[nodiscard]] GroundTruth truth(std::size_t threads = 2) const {
    Scheduler scheduler(threads);
    return make_ground_truth(scheduler, mesh, mesh_graph, partition, seeds);
  }
  [[nodiscard]] const Vec3& seed(std::size_t region) const {
    return mesh_graph.position[seeds[region]];
  }
};

std::vector<NodeId> every(NodeId step, std::size_t count) {
  std::vector<NodeId> nodes;
  for (NodeId v = 0; nodes.size() < count; v += step) nodes.push_back(v);
  return nodes;
}

// All that is told, by the plainest means.
void expect_equal_to_brute_force(const Case& c) {
  const GroundTruth truth = c.truth();
  const Graph& graph = c.mesh_graph.graph;
  std::size_t equal = 0;
  double energy = 0;
  double graph_energy = 0;
  std::vector<double> mass(c.seeds.size(), 0);
  std::vector<Vec3> moment(c.seeds.size(), Vec3::Zero());
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    const Vec3& p = c.mesh_graph.position[v];
    RegionId nearest = 0;
    for (RegionId r = 1; r < c.seeds.size(); ++r) {
      if ((p - c.seed(r)).squaredNorm() < (p - c.seed(nearest)).squaredNorm()) nearest = r;
    }
    ASSERT_EQ(truth.region[v], nearest);
    const RegionId other = region_of(c.partition.key[v]);
    const double m = graph.mass[v] * graph.tick_mass;
    equal += other == nearest ? 1 : 0;
    energy += m * (p - c.seed(nearest)).squaredNorm();
    graph_energy += m * (p - c.seed(other)).squaredNorm();
    mass[nearest] += m;
    moment[nearest] += m * p;
  }
  EXPECT_DOUBLE_EQ(truth.node_agreement,
                   static_cast<double>(equal) / static_cast<double>(graph.node_count()));
  EXPECT_NEAR(truth.energy / energy, 1, 1e-12);
  EXPECT_NEAR(truth.graph_energy / graph_energy, 1, 1e-12);
  EXPECT_LE(truth.energy, truth.graph_energy);
  EXPECT_EQ(truth.unreached_nodes, 0U);
  for (std::size_t r = 0; r < c.seeds.size(); ++r) {
    EXPECT_LT(norm(truth.centroid[r] - moment[r] / mass[r]), 1e-12);
    EXPECT_DOUBLE_EQ(truth.seed_distance[r], norm(truth.surface_centroid[r] - c.seed(r)));
  }
}

TEST(GroundTruth, IsThatOfBruteForceForAllGraphs) {
  for (const GraphKind kind : all_kinds) {
    expect_equal_to_brute_force({creature(4000, 1), kind, every(60, 30)});
    expect_equal_to_brute_force({torus(4000, 2), kind, every(37, 50)});
  }
}

TEST(GroundTruth, AreasAreThoseOfTheSurfaceWhateverTheNodes) {
  for (const GraphKind kind : all_kinds) {
    const GroundTruth truth = Case(irregular_plane(2000, 3), kind, every(50, 20)).truth();
    double area = 0;
    for (const double a : truth.area) area += a;
    EXPECT_NEAR(area, 1, 1e-6);
  }
}

// A square of `side` cells of width 1, each cut along both diagonals.
Mesh cross_grid(std::uint32_t side) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= side; ++y) {
    for (std::uint32_t x = 0; x <= side; ++x) mesh.positions.emplace_back(x, y, 0);
  }
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto middle = static_cast<VertexId>(mesh.positions.size());
      mesh.positions.emplace_back(x + 0.5, y + 0.5, 0);
      const VertexId a = y * (side + 1) + x;
      const VertexId b = a + side + 1;
      for (const auto& [i, j] : {std::pair{a, a + 1}, {a + 1, b + 1}, {b + 1, b}, {b, a}}) {
        mesh.triangles.push_back({i, j, middle});
      }
    }
  }
  return mesh;
}

NodeId node_at(const MeshGraph& mesh_graph, const Vec3& p) {
  const auto found = std::find(mesh_graph.position.begin(), mesh_graph.position.end(), p);
  return static_cast<NodeId>(found - mesh_graph.position.begin());
}

Case on_cross_grid(std::uint32_t side, const std::vector<Vec3>& places) {
  Case c(cross_grid(side), GraphKind::vertex, {0});
  std::vector<NodeId> seeds;
  seeds.reserve(places.size());
  for (const Vec3& p : places) seeds.push_back(node_at(c.mesh_graph, p));
  return {std::move(c.mesh), GraphKind::vertex, std::move(seeds)};
}

// Two seeds that mirror each other: halves. The vertices on the mirror, a third of whose mass per
// unit of length comes from beyond it, are as far from both and go to the first.
TEST(GroundTruth, OfTwoSeedsOnASquareIsItsHalves) {
  constexpr std::uint32_t side = 20;
  constexpr double n = side;
  const GroundTruth truth = on_cross_grid(side, {Vec3(4, 10, 0), Vec3(16, 10, 0)}).truth();
  EXPECT_EQ(truth.node_agreement, 1);
  EXPECT_EQ(truth.area_agreement, 1);
  EXPECT_EQ(truth.energy, truth.graph_energy);
  const std::array area = {n * n / 2 + n / 3, n * n / 2 - n / 3};
  const std::array x = {(n * n * n / 8 + n * n / 6) / area[0],
                        (3 * n * n * n / 8 - n * n / 6) / area[1]};
  const std::array seed_x = {4.0, 16.0};
  const double edge = (1 + 2 * std::sqrt(0.5)) / 3;
  double in_edges = 0;
  double in_radii = 0;
  for (std::size_t r = 0; r < 2; ++r) {
    const double distance = std::abs(x[r] - seed_x[r]);
    EXPECT_NEAR(truth.area[r], area[r], 1e-6);
    EXPECT_LT(norm(truth.centroid[r] - Vec3(x[r], n / 2, 0)), 1e-7);
    EXPECT_LT(norm(truth.surface_centroid[r] - truth.centroid[r]), 1e-12);
    EXPECT_NEAR(truth.seed_distance[r], distance, 1e-7);
    in_edges = std::max(in_edges, distance / edge);
    in_radii = std::max(in_radii, distance / std::sqrt(area[r] / std::numbers::pi));
  }
  EXPECT_NEAR(truth.distance_in_edges.max(), in_edges, 1e-7);
  EXPECT_NEAR(truth.distance_in_radii.max(), in_radii, 1e-7);
}

// Squares: 1 / 6 against a hexagon's 5 / (18 sqrt 3).
TEST(GroundTruth, OfALatticeOfSquaresHasTheirEnergy) {
  std::vector<Vec3> places;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) places.emplace_back(10 + 20 * x, 10 + 20 * y, 0);
  }
  const GroundTruth truth = on_cross_grid(60, places).truth();
  EXPECT_EQ(truth.node_agreement, 1);
  EXPECT_EQ(truth.energy, truth.graph_energy);
  EXPECT_NEAR(truth.energy / truth.hexagonal, (1.0 / 6) * (18 * std::sqrt(3) / 5), 0.005);
}

TEST(GroundTruth, CentroidsComeBackToTheSurface) {
  const GroundTruth truth = Case(icosphere(5000), GraphKind::vertex, every(200, 12)).truth();
  for (std::size_t r = 0; r < truth.centroid.size(); ++r) {
    EXPECT_LT(norm(truth.centroid[r]), 0.98);
    EXPECT_NEAR(norm(truth.surface_centroid[r]), 1, 0.01);
    EXPECT_LT(norm(normalized(truth.centroid[r]) - truth.surface_centroid[r]), 0.02);
  }
}

// The same mesh twice in the same place, not connected.
Mesh twice(const Mesh& mesh) {
  Mesh both = mesh;
  const auto count = static_cast<VertexId>(mesh.vertex_count());
  both.positions.insert(both.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const auto& [a, b, c] : mesh.triangles) {
    both.triangles.push_back({a + count, b + count, c + count});
  }
  return both;
}

TEST(GroundTruth, OfTwoSeedsInOnePlaceIsTheFirsts) {
  const Mesh mesh = twice(icosphere(500));
  const auto count = static_cast<VertexId>(mesh.vertex_count() / 2);
  Case c(mesh, GraphKind::vertex, {0});
  c = Case(mesh, GraphKind::vertex, {c.mesh_graph.node_of[7], c.mesh_graph.node_of[7 + count]});
  const GroundTruth truth = c.truth();
  EXPECT_EQ(truth.region, std::vector<RegionId>(mesh.vertex_count(), 0));
  EXPECT_EQ(truth.area[1], 0);
  EXPECT_EQ(truth.centroid[1], c.seed(1));
  EXPECT_LT(truth.seed_distance[1], 1e-15);
  EXPECT_EQ(truth.node_agreement, 0.5);
  EXPECT_LT(truth.distance_in_radii.min(), 1e-15);
  EXPECT_LT(truth.distance_in_radii.max(), 1);
}

TEST(GroundTruth, LeavesOutWhatNoSeedReaches) {
  const Mesh mesh = twice(icosphere(500));
  const auto count = static_cast<VertexId>(mesh.vertex_count() / 2);
  Case c(mesh, GraphKind::vertex, {0});
  c = Case(mesh, GraphKind::vertex, {c.mesh_graph.node_of[7], c.mesh_graph.node_of[70]});
  const GroundTruth truth = c.truth();
  EXPECT_EQ(truth.unreached_nodes, count);
  for (VertexId v = 0; v < count; ++v) {
    EXPECT_NE(truth.region[c.mesh_graph.node_of[v]], no_id);
    EXPECT_EQ(truth.region[c.mesh_graph.node_of[v + count]], no_id);
  }
  EXPECT_NEAR(truth.area[0] + truth.area[1], 4 * std::numbers::pi, 0.2);
}

TEST(GroundTruth, IsTheSameForAnyNumberOfThreads) {
  const Case c(creature(30000, 5), GraphKind::mixed, every(100, 100));
  const GroundTruth one = c.truth(1);
  for (const std::size_t threads : {2U, 3U, 8U}) {
    const GroundTruth many = c.truth(threads);
    EXPECT_EQ(many.region, one.region);
    EXPECT_EQ(many.area, one.area);
    EXPECT_EQ(many.centroid, one.centroid);
    EXPECT_EQ(many.surface_centroid, one.surface_centroid);
    EXPECT_EQ(many.seed_distance, one.seed_distance);
    EXPECT_EQ(many.energy, one.energy);
    EXPECT_EQ(many.graph_energy, one.graph_energy);
  }
}

class GroundTruthProgram : public Program {
 protected:
  [[nodiscard]] Outcome ground_truth(const std::string& options, const std::string& name) const {
    return geolloyd_with("ground-truth " + mesh_.string() + " -o " + out(name).string() + " " +
                         options);
  }
  [[nodiscard]] json part_in(const std::string& name, const char* file) const {
    return json::parse(read_file(out(name) / file))["ground_truth"];
  }
};

TEST_F(GroundTruthProgram, RelaxAndTheCommandTellTheSameWithAnyThreads) {
  for (const std::string graph : {"vertex", "mixed"}) {
    const Outcome relaxed = relax("-k 20 --ground-truth --graph " + graph);
    ASSERT_EQ(relaxed.status, 0) << relaxed.text;
    EXPECT_NE(relaxed.text.find(", ground truth "), std::string::npos) << relaxed.text;
    const json expected = part_in("out", "report.json");
    EXPECT_GT(expected["node_agreement"], 0.5);
    EXPECT_GT(expected["energy_ratio_hexagonal"], 0.9);
    EXPECT_LE(expected["energy"], expected["graph_energy"]);
    EXPECT_LE(expected["distance_in_edges"]["mean"], expected["distance_in_edges"]["max"]);
    for (const std::string threads : {"1", "3"}) {
      std::string options = "--seeds-file " + (out() / "seeds.csv").string();
      options.append(" --threads ").append(threads).append(" --graph ").append(graph);
      const Outcome outcome = ground_truth(options, "truth");
      ASSERT_EQ(outcome.status, 0) << outcome.text;
      EXPECT_EQ(part_in("truth", "ground-truth.json"), expected);
    }
  }
}

TEST_F(GroundTruthProgram, TablesHoldARowPerIdAndPerRegion) {
  ASSERT_EQ(ground_truth("-k 20", "truth").status, 0);
  EXPECT_EQ(lines_of(out("truth") / "ground-truth-seeds.csv").size(), 21U);
  std::size_t equal = 0;
  const std::vector<std::string> lines = lines_of(out("truth") / "ground-truth-regions.csv");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t last = lines[i].rfind(',');
    const std::size_t before = lines[i].rfind(',', last - 1);
    equal += lines[i].substr(last + 1) == lines[i].substr(before + 1, last - before - 1) ? 1 : 0;
  }
  EXPECT_DOUBLE_EQ(static_cast<double>(equal) / static_cast<double>(lines.size() - 1),
                   part_in("truth", "ground-truth.json")["node_agreement"].get<double>());
}

TEST_F(GroundTruthProgram, NeedsNoFolderAndReplacesNoInput) {
  const Outcome outcome = geolloyd_with("ground-truth " + mesh_.string() + " -k 20");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("% of area"), std::string::npos) << outcome.text;
  ASSERT_EQ(relax("-k 20").status, 0);
  EXPECT_FALSE(json::parse(read_file(out() / "report.json")).contains("ground_truth"));
  fs::rename(out() / "seeds.csv", out() / "ground-truth-seeds.csv");
  expect_complaint(
      ground_truth("--seeds-file " + (out() / "ground-truth-seeds.csv").string(), "out"),
      "would be overwritten");
  expect_complaint(ground_truth("", "truth"), "how many regions?");
}

}  // namespace
}  // namespace geolloyd

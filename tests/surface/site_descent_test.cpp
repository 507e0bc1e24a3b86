#include "core/surface/sites/site_descent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/shapes/shapes.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "tests/support/random_graph.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

// Sites on a mesh, with the reference engine.
class RelaxedGround {
 public:
  RelaxedGround(FineMesh a_mesh, std::size_t count)
      : mesh(std::move(a_mesh)),
        unit_(mesh.whole_area),
        engine(make_reference_surface_engine(mesh)) {
    assign(spread_sites(mesh, count));
  }

  void assign(const SitedMesh& sited) {
    sites = sited.sites;
    is_fixed.assign(sites.size(), 0);
    engine->assign(sited.labels, sited.is_fixed);
    engine->evaluate(sites);
  }
  double energy_of(const std::vector<Vec3>& some_sites) {
    const auto& cells = engine->evaluate(some_sites).moments;
    double sum = 0;
    for (std::size_t r = 0; r < cells.size(); ++r) sum += unit_.energy(cells[r], some_sites[r]);
    return sum;
  }
  std::vector<Vec3> centroids() {
    std::vector<Vec3> found = sites;
    const auto& cells = engine->evaluate(sites).moments;
    for (std::size_t r = 0; r < found.size(); ++r) {
      if (cells[r].area > 0) found[r] = unit_.centroid(cells[r]);
    }
    return found;
  }
  std::vector<Vec3> gradient() {
    const std::vector<Vec3> centroid = centroids();
    const auto& cells = engine->evaluate(sites).moments;
    std::vector<Vec3> found;
    for (std::size_t r = 0; r < centroid.size(); ++r) {
      found.emplace_back((sites[r] - centroid[r]) * (2 * unit_.area(cells[r])));
    }
    return found;
  }
  /// Energies after each iteration.
  std::vector<double> descend(std::size_t iterations, double longest_move) {
    std::vector<double> energies;
    DescentOptions options;
    options.is_fixed = is_fixed;
    options.most_iterations = iterations;
    options.longest_move = longest_move;
    options.keep_going = [&](double energy, std::span<const Vec3>) {
      energies.push_back(energy);
      return true;
    };
    last_ = geolloyd::descend(mesh, *engine, sites, options);
    return energies;
  }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] double mean_spacing() const {
    return std::sqrt(mesh.whole_area / static_cast<double>(sites.size()));
  }

  const FineMesh mesh;

 private:
  MomentUnit unit_;
  double last_ = 0;

 public:
  std::unique_ptr<SurfaceEngine> engine;
  std::vector<Vec3> sites;
  std::vector<std::uint8_t> is_fixed;
};

std::vector<FineMesh> open_and_closed() {
  std::vector<FineMesh> meshes;
  for (const Mesh& mesh : {irregular_plane(2000, 1), icosphere(2000), torus(2000, 1)}) {
    meshes.push_back(surface_input_of(mesh).fine);
  }
  return meshes;
}

TEST(SurfaceEnergy, HasTheGradientThatIsUsed) {
  for (const FineMesh& mesh : open_and_closed()) {
    RelaxedGround ground(mesh, 25);
    ground.descend(3, ground.mean_spacing());
    const std::vector<Vec3> gradient = ground.gradient();
    const double size = 2 * mesh.whole_area / 25 * ground.mean_spacing();
    double worst = 0;
    for (std::size_t r = 0; r < ground.sites.size(); ++r) {
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double step = 1e-5;
        std::vector<Vec3> beside = ground.sites;
        beside[r][axis] += step;
        const double above = ground.energy_of(beside);
        beside[r][axis] -= 2 * step;
        const double below = ground.energy_of(beside);
        worst = std::max(worst, std::abs((above - below) / (2 * step) - gradient[r][axis]));
      }
    }
    EXPECT_LE(worst, 1e-8 * size);
  }
}

// Without pairs, the preconditioner makes it Lloyd's step.
TEST(SiteDescent, BeginsWithALloydStep) {
  for (const FineMesh& mesh : open_and_closed()) {
    RelaxedGround ground(mesh, 40);
    const std::vector<Vec3> centroids = ground.centroids();
    ground.descend(1, 10);
    for (std::size_t r = 0; r < centroids.size(); ++r) {
      EXPECT_LE(norm(ground.sites[r] - centroids[r]), 1e-14);
    }
  }
}

TEST(SiteDescent, NeverRises) {
  for (const FineMesh& mesh : open_and_closed()) {
    for (const std::size_t count : {2U, 10U, 60U, 300U}) {
      RelaxedGround ground(mesh, count);
      const double start = ground.energy_of(ground.sites);
      std::vector<double> energies = ground.descend(40, 0.5 * ground.mean_spacing());
      ASSERT_FALSE(energies.empty());
      EXPECT_EQ(energies.back(), ground.last());
      energies.insert(energies.begin(), start);
      for (std::size_t i = 1; i < energies.size(); ++i) EXPECT_LE(energies[i], energies[i - 1]);
      EXPECT_LT(energies.back(), 0.95 * start);
    }
  }
}

// So good that nothing is gained by going on: no better than hexagons, and not much worse.
TEST(SiteDescent, ComesNearHexagons) {
  RelaxedGround ground(surface_input_of(icosphere(8000)).fine, 100);
  const double area = ground.mesh.whole_area;
  const double hexagons = 5 / (18 * std::sqrt(3)) * area * area / 100;
  const double found = ground.descend(80, 0.5 * ground.mean_spacing()).back() / hexagons;
  EXPECT_LT(found, 1.06);
  EXPECT_GT(found, 0.99);
}

// From anywhere, also where a line search fails.
TEST(SiteDescent, LeavesTheEngineWithItsResult) {
  for (const FineMesh& mesh : open_and_closed()) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      RelaxedGround ground(mesh, 5 + 20 * seed);
      for (std::size_t r = 0; r < ground.sites.size(); ++r) {
        ground.sites[r] += random_point(seed, r, 0.3);
      }
      ground.engine->evaluate(ground.sites);
      ground.descend(30 + 20 * (seed % 3), ground.mean_spacing());
      const std::vector<RegionId> labels = ground.engine->labels();
      EXPECT_NEAR(ground.energy_of(ground.sites), ground.last(), 1e-12 * ground.last());
      EXPECT_EQ(ground.engine->labels(), labels);
    }
  }
}

// An engine for which every change is for the worse.
class RisingEngine final : public SurfaceEngine {
 public:
  explicit RisingEngine(const FineMesh& mesh) : engine_(make_reference_surface_engine(mesh)) {}

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    engine_->assign(std::move(labels), is_fixed);
  }
  const Cells& evaluate(std::span<const Vec3> sites) override {
    if (first.empty()) first.assign(sites.begin(), sites.end());
    last.assign(sites.begin(), sites.end());
    cells_ = engine_->evaluate(sites);
    if (last != first) cells_.moments[0].second *= 20;
    ++evaluations;
    return cells_;
  }
  [[nodiscard]] const std::vector<RegionId>& labels() const override { return engine_->labels(); }
  [[nodiscard]] const Cells& cells() const override { return cells_; }

  std::vector<Vec3> first;
  std::vector<Vec3> last;
  int evaluations = 0;

 private:
  std::unique_ptr<SurfaceEngine> engine_;
  Cells cells_;
};

TEST(SiteDescent, EndsWhereNothingIsGained) {
  const FineMesh mesh = surface_input_of(icosphere(500)).fine;
  const SitedMesh sited = spread_sites(mesh, 10);
  RisingEngine engine(mesh);
  engine.assign(sited.labels, sited.is_fixed);
  std::vector<Vec3> sites = sited.sites;
  const std::vector<std::uint8_t> is_fixed(sites.size(), 0);
  DescentOptions options;
  options.is_fixed = is_fixed;
  options.most_iterations = 50;
  options.longest_move = 1;
  descend(mesh, engine, sites, options);
  EXPECT_EQ(sites, sited.sites);
  EXPECT_EQ(engine.last, sited.sites) << "the engine is left with what was tried";
  EXPECT_LT(engine.evaluations, 20);
}

TEST(SiteDescent, EndsWhereLittleIsGained) {
  for (const double least_gain : {0.5, 1e-2, 1e-4}) {
    RelaxedGround ground(surface_input_of(icosphere(2000)).fine, 50);
    std::vector<double> energies = {ground.energy_of(ground.sites)};
    DescentOptions options;
    options.is_fixed = ground.is_fixed;
    options.most_iterations = 1000;
    options.longest_move = 0.5 * ground.mean_spacing();
    options.least_gain = least_gain;
    options.keep_going = [&](double energy, std::span<const Vec3>) {
      energies.push_back(energy);
      return true;
    };
    descend(ground.mesh, *ground.engine, ground.sites, options);
    const std::size_t last = energies.size() - 1;
    EXPECT_EQ(last % 10, 0U);
    for (std::size_t i = 10; i <= last; i += 10) {
      const double gain = (energies[i - 10] - energies[i]) / energies[i - 10];
      EXPECT_EQ(gain < least_gain, i == last) << i;
    }
  }
}

TEST(SiteDescent, LetsSitesStay) {
  for (const FineMesh& mesh : open_and_closed()) {
    RelaxedGround ground(mesh, 50);
    for (std::size_t r = 0; r < 50; r += 3) ground.is_fixed[r] = 1;
    const std::vector<Vec3> before = ground.sites;
    const double start = ground.energy_of(before);
    ground.descend(25, 0.5 * ground.mean_spacing());
    for (std::size_t r = 0; r < 50; ++r) {
      EXPECT_EQ(ground.sites[r] == before[r], ground.is_fixed[r] != 0) << r;
    }
    EXPECT_LT(ground.last(), start);
    ground.is_fixed.assign(50, 1);
    const std::vector<Vec3> all = ground.sites;
    ground.descend(5, 1);
    EXPECT_EQ(ground.sites, all);
  }
}

TEST(SiteDescent, TakesNoLongSteps) {
  for (const double longest : {0.0, 1e-3, 0.02}) {
    RelaxedGround ground(surface_input_of(torus(2000, 1)).fine, 40);
    for (int i = 0; i < 5; ++i) {
      const std::vector<Vec3> before = ground.sites;
      ground.descend(1, longest);
      for (std::size_t r = 0; r < before.size(); ++r) {
        EXPECT_LE(norm(ground.sites[r] - before[r]), longest * (1 + 1e-12));
      }
    }
  }
}

TEST(SiteDescent, EndsWhenAsked) {
  RelaxedGround ground(surface_input_of(icosphere(1000)).fine, 20);
  int calls = 0;
  DescentOptions options;
  options.is_fixed = ground.is_fixed;
  options.most_iterations = 30;
  options.longest_move = 1;
  options.keep_going = [&](double, std::span<const Vec3>) { return ++calls < 3; };
  const double energy = descend(ground.mesh, *ground.engine, ground.sites, options);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(energy, ground.energy_of(ground.sites));
  options.most_iterations = 0;
  EXPECT_EQ(descend(ground.mesh, *ground.engine, ground.sites, options), energy);
  EXPECT_EQ(calls, 3);
}

// Sites that have nothing have nowhere to go.
TEST(SiteDescent, LeavesSitesWithoutACell) {
  RelaxedGround ground(surface_input_of(icosphere(1000)).fine, 20);
  SitedMesh sited = spread_sites(ground.mesh, 20);
  sited.sites.emplace_back(0.5, 0.5, 0.5);
  ground.assign(sited);
  ground.descend(10, 1);
  EXPECT_EQ(ground.sites[20], Vec3(0.5, 0.5, 0.5));
}

// Hexagons about those that may move; their neighbours on the boundary stay.
TEST(SiteDescent, LeavesAHexagonalLatticeAsItIs) {
  const FineMesh mesh = surface_input_of(irregular_plane(8000, 1)).fine;
  const double spacing = 0.2;
  SitedMesh sited = spread_sites(mesh, 1);
  sited.sites.clear();
  for (int row = -9; row <= 9; ++row) {
    for (int column = -9; column <= 9; ++column) {
      const Vec3 site((column + 0.5 * (row & 1)) * spacing, row * std::sqrt(0.75) * spacing, 0);
      if (site.cwiseAbs().maxCoeff() < 1) sited.sites.push_back(site);
    }
  }
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const auto nearest = std::ranges::min_element(
        sited.sites, {}, [&](const Vec3& site) { return norm(site - mesh.positions[v]); });
    sited.labels[v] = static_cast<RegionId>(nearest - sited.sites.begin());
  }
  RelaxedGround ground(mesh, 1);
  ground.assign(sited);
  for (std::size_t r = 0; r < sited.sites.size(); ++r) {
    ground.is_fixed[r] = sited.sites[r].cwiseAbs().maxCoeff() > 1 - 1.5 * spacing ? 1 : 0;
  }
  ASSERT_GT(std::ranges::count(ground.is_fixed, 0), 20);
  ground.descend(20, 0.1);
  for (std::size_t r = 0; r < sited.sites.size(); ++r) {
    EXPECT_LE(norm(ground.sites[r] - sited.sites[r]), 1e-3 * spacing);
  }
  // Disturbed, it returns, for the lattice is a minimum.
  for (std::size_t r = 0; r < sited.sites.size(); ++r) {
    if (ground.is_fixed[r] == 0) ground.sites[r] += 0.1 * spacing * Vec3(random_unit(1, r), 0, 0);
  }
  ground.engine->evaluate(ground.sites);
  ground.descend(60, 0.1);
  for (std::size_t r = 0; r < sited.sites.size(); ++r) {
    EXPECT_LE(norm(ground.sites[r] - sited.sites[r]), 1e-3 * spacing);
  }
}

}  // namespace
}  // namespace geolloyd

#include "core/surface/result/surface_repair.h"

#include <algorithm>
#include <utility>

#include "core/dual/seed_insertion.h"
#include "core/surface/cells/cell_labels.h"
#include "core/surface/result/labelled_surface.h"
#include "core/surface/sites/site_balance.h"

namespace geolloyd {
namespace {

constexpr std::size_t first_iterations = 10;
constexpr std::size_t more_iterations = 5;

enum class Inserted { free, fixed };

class SurfaceRepair {
 public:
  SurfaceRepair(const DividedSurface& surface, RestingSites resting, SiteRelaxer& relaxer,
                Executor& executor)
      : input_(surface.input),
        curves_(surface.curves),
        budget_(std::move(resting.budget)),
        wanted_(budget_.total()),
        level_(fine_level(surface)),
        relaxer_(relaxer),
        executor_(executor) {
    result_.state = std::move(resting.state);
  }

  DualisedSites run() {
    relaxer_.relax(level_, result_.state, first_iterations);
    dualise();
    if (has_violations() && insert(Inserted::free)) {
      relaxer_.relax(level_, result_.state, more_iterations);
      dualise();
    }
    while (has_violations() && insert(Inserted::fixed)) {
      relaxer_.relax(level_, result_.state, 0);
      dualise();
    }
    if (!has_violations() && result_.state.sites.size() > wanted_) try_without_surplus();
    if (!has_violations()) try_without_holding();
    return std::move(result_);
  }

 private:
  // After a sweep.
  void dualise() {
    take_cells();
    tidy();
    for (int attempt = 0; has_site_without_cell() && attempt < 4; ++attempt) {
      balance_sites(level_, budget_.free, result_.cells, result_.state.sites, result_.state.labels);
      relaxer_.relax(level_, result_.state, 0);
      take_cells();
      tidy();
    }
    remove_sites_without_cells();
    surface_ = label_surface(input_, curves_, result_.state, executor_);
    result_.dual = make_dual(surface_, executor_);
  }

  void take_cells() { result_.cells = relaxer_.cells(); }

  void tidy() {
    LabelledSites& state = result_.state;
    keep_one_component(*level_.mesh, state.sites.size(), level_.is_on_curve, state.labels,
                       executor_);
    fill_gaps(*level_.mesh, state.sites.positions, state.labels);
    // A patch that its last site has left gets one again.
    for (VertexId v = 0; v < state.labels.size(); ++v) {
      if (state.labels[v] != no_id) continue;
      state.labels[v] = static_cast<RegionId>(state.sites.size());
      state.sites.add(level_.mesh->positions[v], level_.patch[v]);
      result_.cells.add_empty();
      fill_gaps(*level_.mesh, state.sites.positions, state.labels);
    }
  }

  [[nodiscard]] std::vector<std::uint8_t> sites_without_cells() const {
    std::vector<std::uint8_t> is_without(result_.state.sites.size(), 1);
    for (const RegionId r : result_.state.labels) is_without[r] = 0;
    return is_without;
  }
  [[nodiscard]] bool has_site_without_cell() const {
    const std::vector<std::uint8_t> is_without = sites_without_cells();
    return std::find(is_without.begin(), is_without.end(), 1) != is_without.end();
  }

  void remove_sites_without_cells() {
    const std::vector<std::uint8_t> is_removed = sites_without_cells();
    remove_sites(is_removed, result_.state.sites, result_.state.labels);
    result_.cells.remove(is_removed);
  }

  [[nodiscard]] bool has_violations() const { return any_removable(result_.dual.violations); }

  // False where there is no place for any.
  bool insert(Inserted how) {
    SurfaceSites& sites = result_.state.sites;
    const std::vector<VertexId> places = insertion_places();
    if (how == Inserted::free) make_room(places.size());
    const std::size_t before = sites.size();
    for (const VertexId v : places) {
      if (level_.is_on_curve[v] != 0) {
        insert_on_curve(v);
      } else {
        result_.state.labels[v] = static_cast<RegionId>(sites.size());
        sites.add(input_.fine.positions[v], level_.patch[v]);
        sites.is_fixed.back() = how == Inserted::fixed ? 1 : 0;
      }
    }
    return sites.size() > before;
  }

  [[nodiscard]] std::vector<VertexId> insertion_places() const {
    std::vector<VertexId> places;
    for (const SeedInsertion& insertion : leave_out_neighbours(
             find_seed_insertions(surface_, result_.dual), result_.state.sites.size())) {
      places.push_back(insertion.point);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  [[nodiscard]] std::vector<RegionId> regions_of_violations() const {
    std::vector<RegionId> regions;
    for (const ClosedBallViolation& violation : result_.dual.violations) {
      for (const RegionId r : violation.regions) {
        if (r != no_id) regions.push_back(r);
      }
    }
    return regions;
  }

  // As it was, if violations come back even where the sites hardly move.
  void try_without_surplus() {
    for (int ring = 0; ring < 2; ++ring) hold_neighbours();
    const DualisedSites before = result_;
    for (const std::size_t iterations : {more_iterations, std::size_t{1}}) {
      make_room(0);
      if (result_.state.sites.size() == before.state.sites.size()) return;
      relaxer_.relax(level_, result_.state, iterations);
      dualise();
      if (!has_violations()) return;
      result_ = before;
    }
  }

  // Sites that were held where they were inserted are seldom at rest. As it was, if violations come
  // back.
  void try_without_holding() {
    std::vector<std::uint8_t>& is_fixed = result_.state.sites.is_fixed;
    const auto first_free =
        is_fixed.begin() + static_cast<std::ptrdiff_t>(result_.state.sites.on_curves);
    if (std::count(first_free, is_fixed.end(), 1) == 0) return;
    const DualisedSites before = result_;
    std::fill(first_free, is_fixed.end(), std::uint8_t{0});
    relaxer_.relax(level_, result_.state, more_iterations);
    dualise();
    if (has_violations() || result_.state.sites.size() != before.state.sites.size()) {
      result_ = before;
    }
  }

  // Neighbours of inserted sites that are fixed.
  void hold_neighbours() {
    SurfaceSites& sites = result_.state.sites;
    std::vector<std::uint8_t> is_fixed = sites.is_fixed;
    const auto is_held = [&](RegionId r) { return r >= sites.on_curves && sites.is_fixed[r] != 0; };
    for (const Triangle& t : result_.dual.triangles) {
      if (!std::any_of(t.begin(), t.end(), is_held)) continue;
      for (const RegionId r : t) is_fixed[r] = 1;
    }
    sites.is_fixed = std::move(is_fixed);
  }

  // Removes sites of least energy so that with `count` more there are as many as wanted: free ones
  // that no violation concerns, in patches with many.
  void make_room(std::size_t count) {
    SurfaceSites& sites = result_.state.sites;
    if (sites.size() + count <= wanted_) return;
    constexpr std::size_t few = 16;
    std::vector<std::size_t> of_patch(budget_.free.size(), 0);
    for (std::size_t r = sites.on_curves; r < sites.size(); ++r) ++of_patch[sites.patch[r]];
    std::vector<std::uint8_t> is_needed = sites.is_fixed;
    for (const RegionId r : regions_of_violations()) is_needed[r] = 1;
    const CellEnergies energies(input_.fine, result_.cells);
    std::vector<std::pair<double, RegionId>> by_energy;
    for (RegionId r = 0; r < sites.size(); ++r) {
      if (is_needed[r] != 0 || of_patch[sites.patch[r]] <= few) continue;
      by_energy.emplace_back(energies.at(r, sites.positions[r]), r);
    }
    std::sort(by_energy.begin(), by_energy.end());
    by_energy.resize(std::min(by_energy.size(), sites.size() + count - wanted_));
    std::vector<std::uint8_t> is_removed(sites.size(), 0);
    for (const auto& [energy, r] : by_energy) is_removed[r] = 1;
    remove_sites(is_removed, sites, result_.state.labels);
  }

  // A site on a curve, with that vertex alone there.
  void insert_on_curve(VertexId v) {
    LabelledSites& state = result_.state;
    const RegionId old = state.labels[v];
    if (count_curve_vertices(old) < 2) return;
    const auto added = static_cast<RegionId>(state.sites.on_curves);
    const auto at = static_cast<std::ptrdiff_t>(added);
    state.sites.positions.insert(state.sites.positions.begin() + at, input_.fine.positions[v]);
    state.sites.patch.insert(state.sites.patch.begin() + at, no_id);
    state.sites.is_fixed.insert(state.sites.is_fixed.begin() + at, 1);
    ++state.sites.on_curves;
    for (RegionId& label : state.labels) {
      if (label != no_id && label >= added) ++label;
    }
    state.labels[v] = added;
  }

  [[nodiscard]] std::size_t count_curve_vertices(RegionId r) const {
    return static_cast<std::size_t>(
        std::count_if(curves_.vertices.begin(), curves_.vertices.end(),
                      [&](VertexId v) { return result_.state.labels[v] == r; }));
  }

  const SurfaceInput& input_;
  const FeatureCurves& curves_;
  SiteBudget budget_;
  std::size_t wanted_;
  LevelMesh level_;
  SiteRelaxer& relaxer_;
  Executor& executor_;
  DualisedSites result_;
  RegionSurface surface_;
};

}  // namespace

DualisedSites repair_dual(const DividedSurface& surface, RestingSites resting, SiteRelaxer& relaxer,
                          Executor& executor) {
  return SurfaceRepair(surface, std::move(resting), relaxer, executor).run();
}

}  // namespace geolloyd

#include "core/surface/sites/site_levels.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/random.h"
#include "core/surface/cells/cell_labels.h"
#include "core/surface/features/curve_sites.h"
#include "core/surface/sites/level_mesh.h"
#include "core/surface/sites/site_balance.h"
#include "core/surface/sites/site_refinement.h"

namespace geolloyd {
namespace {

// Irregular sites of a level are inherited by the next one, so coarse levels, where an iteration
// costs little, come to rest best.
std::size_t iterations_on(const LevelMesh& level, const RestEffort& effort) {
  return std::clamp(effort.vertex_visits / level.patch.size(), effort.fewest_iterations,
                    effort.most_iterations);
}

// The whole course goes on from the few sites of the first levels, which may have come to rest in a
// poor place.
std::uint64_t attempts_with(std::size_t sites) {
  if (sites <= 150) return 6;
  return sites <= 600 ? 2 : 0;
}

// From the last level to the first.
std::vector<SiteBudget> plan_levels(const SiteBudgeter& budgeter, std::size_t count) {
  constexpr std::size_t fewest = 50;
  std::vector<SiteBudget> levels = {budgeter.of_size(count)};
  while (levels.back().total() > fewest) {
    SiteBudget coarser = budgeter.at_spacing(2 * levels.back().spacing);
    if (2 * coarser.total() > levels.back().total()) break;
    levels.push_back(std::move(coarser));
  }
  return levels;
}

std::vector<double> spacings_of(const std::vector<SiteBudget>& levels) {
  std::vector<double> spacings;
  spacings.reserve(levels.size());
  for (const SiteBudget& level : levels) spacings.push_back(level.spacing);
  return spacings;
}

class LevelByLevel {
 public:
  LevelByLevel(const DividedSurface& surface, std::vector<SiteBudget> levels, SiteRelaxer& relaxer,
               const RestEffort& effort, Executor& executor)
      : surface_(surface),
        levels_(std::move(levels)),
        meshes_(surface, spacings_of(levels_), executor),
        relaxer_(relaxer),
        effort_(effort),
        executor_(executor) {}

  // After an interrupt no more sites come, and those that are there go to the fine mesh.
  RestingSites run() {
    const std::size_t first = levels_.size() - 1;
    on_ = &meshes_.at(first);
    curve_sites_ = place_curve_sites(surface_.input, surface_.curves, levels_[first].spacing);
    start_sites(*on_, levels_[first].free, curve_sites_, state_.sites, state_.labels);
    settle(first);
    for (std::size_t level = first; level-- > 0 && goes_on();) {
      refine(level);
      settle(level);
    }
    if (on_ != &meshes_.fine()) move_to_fine();
    if (goes_on()) balance(0);
    return {std::move(state_), std::move(levels_[0])};
  }

 private:
  bool goes_on() { return relaxer_.ask(state_.sites); }

  void balance(std::size_t level) {
    relaxer_.sweep(*on_, state_);
    balance_sites(*on_, levels_[level].free, relaxer_.cells(), state_.sites, state_.labels);
  }

  // What is too large after the first iterations is so for want of sites, not of iterations: each
  // site removed or inserted leaves irregular ones about it.
  void settle(std::size_t level) {
    constexpr std::size_t first_iterations = 10;
    relaxer_.relax(*on_, state_, first_iterations);
    if (!goes_on()) return;
    balance(level);
    const double energy = relaxer_.relax(*on_, state_, iterations_on(*on_, effort_));
    if (effort_.tries_again) try_again(energy, levels_[level].spacing);
  }

  // Each attempt starts from the best one, shaken.
  void try_again(double energy, double spacing) {
    const std::uint64_t attempts = attempts_with(state_.sites.size());
    for (std::uint64_t attempt = 1; attempt <= attempts && goes_on(); ++attempt) {
      LabelledSites shaken = state_;
      shake(shaken, spacing, attempt);
      const double reached = relaxer_.relax(*on_, shaken, iterations_on(*on_, effort_));
      if (reached >= energy) continue;
      energy = reached;
      state_ = std::move(shaken);
    }
  }

  void shake(LabelledSites& state, double spacing, std::uint64_t attempt) const {
    constexpr double share = 0.3;  // of a spacing, along each axis, at most
    SurfaceSites& sites = state.sites;
    const std::vector<double> inverse_sizing =
        inverse_sizing_at_sites(*on_->mesh, sites.size(), state.labels);
    const std::vector<Metric> metric = metric_at_sites(*on_->mesh, sites.size(), state.labels);
    for (std::size_t r = 0; r < sites.size(); ++r) {
      if (sites.is_fixed[r] != 0) continue;
      const double reach = share * (inverse_sizing.empty() ? spacing : spacing / inverse_sizing[r]);
      Vec3 offset;
      for (int axis = 0; axis < 3; ++axis) {
        const double unit = random_unit(attempt, 3 * r + static_cast<std::size_t>(axis));
        offset[axis] = reach * (2 * unit - 1);
      }
      if (!metric.empty() && dot(offset, offset) > 0) {
        offset *= share * spacing / metric[r].length(offset);
      }
      sites.positions[r] += offset;
    }
  }

  void refine(std::size_t level) {
    const auto adjacent = adjacent_cells(*on_, state_.labels);
    const auto on_curves = neighbours_on_curves(surface_.curves, curve_sites_.label);
    const LevelMesh& next = meshes_.at(level);
    curve_sites_ = place_curve_sites(surface_.input, surface_.curves, levels_[level].spacing);
    Refinement refinement =
        refine_sites(state_.sites, adjacent, on_curves, curve_sites_,
                     metric_at_sites(*on_->mesh, state_.sites.size(), state_.labels));
    state_.labels =
        inherit_labels(next, refinement, state_.labels, meshes_.map(next, *on_), executor_);
    state_.sites = std::move(refinement.sites);
    on_ = &next;
    label_curve_vertices(*on_, curve_sites_, state_.labels);
  }

  // The same sites. Nobody needs the other meshes any more.
  void move_to_fine() {
    relaxer_.release_engine();
    std::vector<std::uint32_t> labels = meshes_.map(meshes_.fine(), *on_);
    for (std::uint32_t& label : labels) label = state_.labels[label];
    state_.labels = std::move(labels);
    on_ = &meshes_.fine();
    meshes_.forget_coarser();
    label_curve_vertices(*on_, curve_sites_, state_.labels);
  }

  const DividedSurface& surface_;
  std::vector<SiteBudget> levels_;
  LevelMeshes meshes_;
  SiteRelaxer& relaxer_;
  RestEffort effort_;
  Executor& executor_;
  const LevelMesh* on_ = nullptr;
  LabelledSites state_;
  CurveSites curve_sites_;
};

}  // namespace

RestingSites rest_sites(const DividedSurface& surface, std::size_t count, SiteRelaxer& relaxer,
                        const RestEffort& effort, Executor& executor) {
  const SiteBudgeter budgeter(surface);
  relaxer.set_wanted_sites(count);
  return LevelByLevel(surface, plan_levels(budgeter, count), relaxer, effort, executor).run();
}

}  // namespace geolloyd

#include "core/surface/sites/site_relaxer.h"

#include <bit>
#include <cmath>
#include <utility>

#include "core/base/hexagonal_energy.h"
#include "core/base/random.h"
#include "core/surface/cells/cell_labels.h"
#include "core/surface/sites/site_descent.h"

namespace geolloyd {

SiteRelaxer::SiteRelaxer(const SurfaceInput& input, const RemeshOptions& options, Runtime& runtime,
                         bool finds_sizes)
    : input_(input), options_(options), runtime_(runtime), finds_sizes_(finds_sizes) {}

SurfaceEngine& SiteRelaxer::engine_for(const LevelMesh& level) {
  if (mesh_ != level.mesh) {
    engine_.reset();
    engine_ = runtime_.make_surface_engine(*level.mesh);
    mesh_ = level.mesh;
  }
  return *engine_;
}

void SiteRelaxer::sweep(const LevelMesh& level, LabelledSites& state) {
  SurfaceEngine& engine = engine_for(level);
  keep_one_component(*level.mesh, state.sites.size(), level.is_on_curve, state.labels,
                     runtime_.executor());
  engine.assign(std::move(state.labels), level.is_on_curve);
  engine.evaluate(state.sites.positions);
  state.labels = engine.labels();
}

double SiteRelaxer::relax(const LevelMesh& level, LabelledSites& state, std::size_t iterations) {
  SurfaceEngine& engine = engine_for(level);
  const std::size_t count = state.sites.size();
  if (steps_.empty()) watch_ = Stopwatch();
  std::size_t iteration = 0;
  const std::vector<double> inverse_sizing =
      inverse_sizing_at_sites(*level.mesh, state.sites.size(), state.labels);
  engine.assign(std::move(state.labels), level.is_on_curve);
  DescentOptions options;
  options.is_fixed = state.sites.is_fixed;
  options.most_iterations = is_interrupted_ ? 0 : iterations;
  options.longest_move = 0.5 * std::sqrt(input_.fine.whole_sized_area / static_cast<double>(count));
  options.inverse_sizing = inverse_sizing;
  options.least_gain = 1e-5;
  options.keep_going = [&](double reached, std::span<const Vec3> sites) {
    return record(level, ++iteration, reached, sites);
  };
  const double energy =
      descend(*level.mesh, engine, state.sites.positions, options, runtime_.executor());
  state.labels = engine.labels();
  add_to_fingerprint(state);
  return energy;
}

bool SiteRelaxer::record(const LevelMesh& level, std::size_t iteration, double energy,
                         std::span<const Vec3> sites) {
  fingerprint_ = mix_bits(fingerprint_ ^ std::bit_cast<std::uint64_t>(energy));
  const double unit = 1 / input_.frame.scale;
  const double square = unit * unit;
  steps_.push_back(
      {sites.size(), level.mesh->vertex_count(), energy * square * square, watch_.seconds()});
  const double area = input_.fine.whole_sized_area;
  iteration_ = iteration;
  energy_ratio_ = energy / hexagonal_energy(area, area, sites.size());
  tell_progress(sites);
  return !is_interrupted_;
}

bool SiteRelaxer::ask(const SurfaceSites& sites) {
  if (!is_interrupted_) tell_progress(sites.positions);
  return !is_interrupted_;
}

void SiteRelaxer::tell_progress(std::span<const Vec3> sites) {
  if (!options_.progress) return;
  const auto place = [&](std::size_t site) { return input_.frame.to_mesh(sites[site]); };
  is_interrupted_ = !options_.progress(
      {sites.size(), wanted_sites_, iteration_, energy_ratio_, place, finds_sizes_});
}

void SiteRelaxer::add_to_fingerprint(const LabelledSites& state) {
  for (const Vec3& p : state.sites.positions) {
    for (const double x : p)
      fingerprint_ = mix_bits(fingerprint_ ^ std::bit_cast<std::uint64_t>(x));
  }
  for (const RegionId label : state.labels) fingerprint_ = mix_bits(fingerprint_ ^ label);
}

}  // namespace geolloyd

#include "bench/support/rested_surface.h"

#include <utility>

#include "core/mesh/mesh_measure.h"
#include "core/surface/sites/site_relaxer.h"

namespace geolloyd {
namespace {

std::vector<double> spacings_of_levels(const SiteBudgeter& budgeter, std::size_t sites) {
  constexpr std::size_t fewest = 50;
  SiteBudget budget = budgeter.of_size(sites);
  std::vector<double> spacings = {budget.spacing};
  while (budget.total() > fewest) {
    SiteBudget coarser = budgeter.at_spacing(2 * spacings.back());
    if (2 * coarser.total() > budget.total()) break;
    spacings.push_back(coarser.spacing);
    budget = std::move(coarser);
  }
  return spacings;
}

double energy_of(const SurfaceInput& input, const LabelledSites& state,
                 std::span<const Moments> cells) {
  const MomentUnit unit(input.fine.whole_mass);
  double energy = 0;
  for (std::size_t r = 0; r < cells.size(); ++r) {
    energy += unit.energy(cells[r], state.sites.positions[r]);
  }
  return energy;
}

}  // namespace

SurfaceFineness surface_fineness(const Mesh& mesh, const MeshEdges& edges, std::size_t sites) {
  SurfaceFineness fineness;
  for (const double area : triangle_areas(mesh, edges.duplicates)) fineness.area += area;
  fineness.options = surface_options(mesh, edges.duplicates, fineness.area, sites);
  return fineness;
}

RestedSurface rest_on_surface(const Mesh& mesh, const MeshEdges& edges, std::size_t sites) {
  const double area = surface_fineness(mesh, edges, sites).area;
  RestedSurface rested{
      make_surface_start(mesh, edges.duplicates, area, sites, {}, {}, reference_runtime()), {}, 0};
  rested.spacings = spacings_of_levels(SiteBudgeter(rested.surface()), sites);
  const RemeshOptions options;
  SiteRelaxer relaxer(rested.input(), options, reference_runtime());
  relaxer.sweep(fine_level(rested.surface()), rested.resting.state);
  rested.energy = energy_of(rested.input(), rested.resting.state, relaxer.cells().moments);
  return rested;
}

}  // namespace geolloyd

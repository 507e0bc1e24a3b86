#include "bench/support/surface_start.h"

#include <cmath>
#include <utility>

#include "core/mesh/mesh_measure.h"
#include "core/surface/reference_surface_engine.h"

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

SurfaceInputOptions SurfaceFineness::options(std::span<const TriangleId> duplicates) const {
  SurfaceInputOptions options;
  options.duplicates = duplicates;
  options.longest_edge = longest_edge;
  options.vertex_limit = vertex_limit;
  return options;
}

SurfaceFineness surface_fineness(const Mesh& mesh, const MeshEdges& edges, std::size_t sites) {
  const auto count = static_cast<double>(sites);
  SurfaceFineness fineness;
  for (const double area : triangle_areas(mesh, edges.duplicates)) fineness.area += area;
  fineness.longest_edge = 0.6 * std::sqrt(fineness.area / count);
  fineness.vertex_limit = 20 * sites + 4 * mesh.vertex_count();
  return fineness;
}

SurfaceStart make_surface_start(const Mesh& mesh, const MeshEdges& edges, std::size_t sites) {
  const SurfaceFineness fineness = surface_fineness(mesh, edges, sites);
  SurfaceStart start;
  start.whole = std::make_unique<const SurfaceInput>(
      make_surface_input(mesh, fineness.options(edges.duplicates)));
  const double spacing =
      std::sqrt(2 * start.input().fine.whole_area / (std::sqrt(3.0) * static_cast<double>(sites)));
  start.divided = std::make_unique<const DividedSurface>(start.input(), spacing, true);
  start.spacings = spacings_of_levels(SiteBudgeter(start.surface()), sites);
  SurfaceRemeshOptions options;
  options.vertex_count = sites;
  const MakeSurfaceEngine make_engine = make_reference_surface_engine;
  SiteRelaxer relaxer(make_engine, options, start.input().fine.whole_area,
                      1 / start.input().frame.scale, sequential());
  start.resting = rest_sites(start.surface(), sites, relaxer);
  const LevelMesh level = fine_level(start.surface());
  relaxer.sweep(level, start.resting.state);
  start.energy = energy_of(start.input(), start.resting.state, relaxer.cells());
  return start;
}

}  // namespace geolloyd

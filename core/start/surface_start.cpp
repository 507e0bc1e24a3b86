#include "core/start/surface_start.h"

#include <cmath>

#include "core/surface/site_relaxer.h"
#include "core/surface/sizing.h"

namespace geolloyd {

SurfaceInputOptions surface_options(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                    double area, std::size_t sites) {
  SurfaceInputOptions options;
  options.duplicates = duplicates;
  options.longest_edge = 0.6 * std::sqrt(area / static_cast<double>(sites));
  options.vertex_limit = 20 * sites + 4 * mesh.vertex_count();
  return options;
}

SurfaceStart make_surface_start(const Mesh& mesh, std::span<const TriangleId> duplicates,
                                double area, std::size_t sites, const RestEffort& effort,
                                const MakeSurfaceEngine& make_engine, Executor& executor) {
  SurfaceStart start;
  start.whole = std::make_unique<const SurfaceInput>(
      make_surface_input(mesh, surface_options(mesh, duplicates, area, sites), executor));
  const double whole_area = start.input().fine.whole_area;
  const double spacing = spacing_of(whole_area, static_cast<double>(sites));
  start.divided = std::make_unique<const DividedSurface>(start.input(), spacing, true, executor);
  const SurfaceRemeshOptions options;
  SiteRelaxer relaxer(make_engine, options, whole_area, 1 / start.input().frame.scale, executor);
  start.resting = rest_sites(start.surface(), sites, relaxer, effort, executor);
  return start;
}

}  // namespace geolloyd

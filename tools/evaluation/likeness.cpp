#include "tools/evaluation/likeness.h"

#include <vector>

#include "core/base/hexagonal_energy.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"
#include "tools/evaluation/distances/point_queries.h"
#include "tools/evaluation/distances/surface_distance.h"
#include "tools/evaluation/site_energy.h"

namespace geolloyd {

Likeness compare(const Mesh& remesh, const Mesh& original, std::span<const TriangleId> duplicates,
                 double area, std::size_t samples, Executor& executor) {
  Likeness likeness;
  likeness.samples = samples;
  likeness.distance = measure_distance(executor, remesh, original, samples);
  std::vector<Vec3> sites = referenced_positions(remesh, executor);
  const ClosestPoint closest(original, executor.threads());
  parallel_for(executor, sites.size(), 256,
               [&](std::size_t r) { sites[r] = closest.find(sites[r]).position; });
  likeness.energy = site_energy(original, duplicates, sites, executor);
  likeness.hexagonal = hexagonal_energy(area, area, sites.size());
  return likeness;
}

}  // namespace geolloyd

#include "tools/evaluation/site_energy.h"

#include <cstdint>
#include <numeric>
#include <vector>

#include "core/base/executor.h"
#include "core/base/loops.h"
#include "tools/evaluation/point_queries.h"

namespace geolloyd {

double site_energy(Executor& executor, std::span<const Vec3> points, std::span<const double> mass,
                   std::span<const Vec3> sites) {
  const NearestSite nearest(sites, executor.threads());
  std::vector<double> of_range(points.size() / small_items + 1, 0);
  parallel_for_ranges(executor, points.size(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        double energy = 0;
                        std::uint32_t site = 0;
                        for (std::size_t v = begin; v < end; ++v) {
                          site = nearest.find(points[v], site);
                          const Vec3 away = points[v] - sites[site];
                          energy += mass[v] * dot(away, away);
                        }
                        of_range[begin / small_items] = energy;
                      });
  return std::accumulate(of_range.begin(), of_range.end(), 0.0);
}

}  // namespace geolloyd

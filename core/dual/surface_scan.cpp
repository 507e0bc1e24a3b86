#include "core/dual/surface_scan.h"

#include "core/base/loops.h"

namespace geolloyd {

SurfaceScan scan_surface(const RegionSurface& surface, Executor& executor) {
  constexpr std::size_t grain = 1 << 15;
  const std::vector<RegionId>& region = surface.region;
  std::vector<std::vector<std::int64_t>> of_worker(executor.threads());
  const auto counts_of = [&](std::size_t worker) {
    of_worker[worker].resize(surface.region_count, 0);
    return of_worker[worker].data();
  };
  parallel_for_ranges(executor, region.size(), grain,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        std::int64_t* const doubled_euler = counts_of(worker);
                        for (std::size_t p = begin; p < end; ++p) {
                          if (region[p] != no_id) doubled_euler[region[p]] += 2;
                        }
                      });
  std::vector<std::vector<std::uint32_t>> borders(surface.triangles.size() / grain + 1);
  parallel_for_ranges(executor, surface.triangles.size(), grain,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        std::int64_t* const doubled_euler = counts_of(worker);
                        for (std::size_t i = begin; i < end; ++i) {
                          const auto& [a, b, c] = surface.triangles[i];
                          if (region[a] != region[b] || region[b] != region[c]) {
                            borders[begin / grain].push_back(static_cast<std::uint32_t>(i));
                          } else if (region[a] != no_id) {
                            doubled_euler[region[a]] += 2 - 3;
                          }
                        }
                      });
  SurfaceScan scan;
  scan.doubled_euler.assign(surface.region_count, 0);
  for (const std::vector<std::int64_t>& counts : of_worker) {
    for (std::size_t r = 0; r < counts.size(); ++r) scan.doubled_euler[r] += counts[r];
  }
  for (const std::vector<std::uint32_t>& part : borders) {
    scan.borders.insert(scan.borders.end(), part.begin(), part.end());
  }
  return scan;
}

}  // namespace geolloyd

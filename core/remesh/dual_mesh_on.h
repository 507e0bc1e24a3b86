#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/remesh/region_surface.h"

namespace geolloyd {

/// What is to be known of all points and triangles of a surface before its dual is made.
struct SurfaceScan {
  /// Per region: twice the Euler characteristic, an edge within it counting half for each of its
  /// triangles.
  std::vector<std::int64_t> doubled_euler;
  std::vector<std::uint32_t> borders;  ///< triangles with several regions, ascending
};

template <class Executor>
SurfaceScan scan_surface_on(Executor& executor, const RegionSurface& surface) {
  constexpr std::size_t grain = 1 << 15;
  const std::vector<RegionId>& region = surface.region;
  std::vector<std::vector<std::int64_t>> of_worker(executor.threads());
  const auto counts_of = [&](std::size_t worker) {
    of_worker[worker].resize(surface.region_count, 0);
    return of_worker[worker].data();
  };
  for_ranges(executor, region.size(), grain,
             [&](std::size_t begin, std::size_t end, std::size_t worker) {
               std::int64_t* const doubled_euler = counts_of(worker);
               for (std::size_t p = begin; p < end; ++p) {
                 if (region[p] != no_id) doubled_euler[region[p]] += 2;
               }
             });
  std::vector<std::vector<std::uint32_t>> borders(surface.triangles.size() / grain + 1);
  for_ranges(executor, surface.triangles.size(), grain,
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

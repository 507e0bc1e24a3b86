#include "tools/evaluation/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"
#include "tools/evaluation/point_queries.h"
#include "tools/evaluation/surface_samples.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t sampling_seed = 1;

struct Sums {
  double distances = 0;
  double squares = 0;
  double largest = 0;

  void add(double distance) {
    distances += distance;
    squares += distance * distance;
    largest = std::max(largest, distance);
  }
  void add(const Sums& more) {
    distances += more.distances;
    squares += more.squares;
    largest = std::max(largest, more.largest);
  }
};

// Sums over fixed ranges, then over these in order, so that threads do not matter.
Sums sum_over_samples(Executor& executor, const SurfaceSamples& samples,
                      const ClosestPoint& closest) {
  std::vector<Sums> of_range(samples.size() / small_items + 1);
  parallel_for_ranges(executor, samples.size(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        Sums sums;
                        for (std::size_t i = begin; i < end; ++i) {
                          sums.add(closest.find(samples.at(i)).distance);
                        }
                        of_range[begin / small_items] = sums;
                      });
  Sums total;
  for (const Sums& sums : of_range) total.add(sums);
  return total;
}

double largest_of_vertices(Executor& executor, const Mesh& mesh, const ClosestPoint& closest) {
  const std::vector<std::uint8_t> referenced = referenced_vertices(mesh, executor);
  std::vector<double> of_worker(executor.threads(), 0);
  parallel_for_ranges(executor, mesh.vertex_count(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        double& largest = of_worker[worker];
                        for (std::size_t v = begin; v < end; ++v) {
                          if (referenced[v] == 0) continue;
                          largest = std::max(largest, closest.find(mesh.positions[v]).distance);
                        }
                      });
  return *std::max_element(of_worker.begin(), of_worker.end());
}

DistanceFigures one_sided(Executor& executor, const Mesh& from, const Mesh& to,
                          std::size_t samples) {
  const ClosestPoint closest(to, executor.threads());
  const Sums sums =
      sum_over_samples(executor, SurfaceSamples(from, samples, sampling_seed), closest);
  const auto count = static_cast<double>(samples);
  return {sums.distances / count, std::sqrt(sums.squares / count),
          std::max(sums.largest, largest_of_vertices(executor, from, closest))};
}

}  // namespace

DistanceFigures SurfaceDistance::two_sided() const {
  return {std::max(from_first.mean, from_second.mean), std::max(from_first.rms, from_second.rms),
          std::max(from_first.largest, from_second.largest)};
}

SurfaceDistance measure_distance(Executor& executor, const Mesh& first, const Mesh& second,
                                 std::size_t samples) {
  return {one_sided(executor, first, second, samples), one_sided(executor, second, first, samples)};
}

}  // namespace geolloyd

#include "tools/evaluation/distances/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/executor.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_measure.h"
#include "tools/evaluation/distances/point_queries.h"
#include "tools/evaluation/distances/surface_samples.h"

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

// Sums over fixed ranges, then over these in order, so that threads do not matter. Successive
// points are mostly near each other, so the triangle that is closest to one is a good guess for the
// next.
Sums sum_over_samples(Executor& executor, const SurfaceSamples& samples,
                      const ClosestPoint& closest) {
  std::vector<Sums> of_range(samples.size() / small_items + 1);
  parallel_for_ranges(executor, samples.size(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        Sums sums;
                        TriangleId triangle = no_id;
                        for (std::size_t i = begin; i < end; ++i) {
                          const FoundPoint found = closest.find(samples.at(i), triangle);
                          sums.add(found.distance);
                          triangle = found.triangle;
                        }
                        of_range[begin / small_items] = sums;
                      });
  Sums total;
  for (const Sums& sums : of_range) total.add(sums);
  return total;
}

// `largest`, or more where a vertex is farther away. Hardly a vertex needs to know its closest
// point: any triangle near enough will do, and mostly one that did for an earlier vertex.
double largest_of_vertices(Executor& executor, const Mesh& mesh, const ClosestPoint& closest,
                           double largest) {
  const std::vector<std::uint8_t> referenced = referenced_vertices(mesh, executor);
  std::vector<double> of_worker(executor.threads(), largest);
  parallel_for_ranges(executor, mesh.vertex_count(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        TriangleId triangle = no_id;
                        for (std::size_t v = begin; v < end; ++v) {
                          const Vec3& p = mesh.positions[v];
                          if (referenced[v] == 0) continue;
                          double& most = of_worker[worker];
                          if (triangle != no_id && closest.distance_to(p, triangle) <= most)
                            continue;
                          triangle = closest.find_within(p, most);
                          if (triangle != no_id) continue;
                          const FoundPoint found = closest.find(p);
                          most = std::max(most, found.distance);
                          triangle = found.triangle;
                        }
                      });
  return *std::max_element(of_worker.begin(), of_worker.end());
}

}  // namespace

DistanceFigures measure_distance_one_way(Executor& executor, const Mesh& from,
                                         const MeshEdges& edges, const Mesh& to,
                                         std::size_t samples) {
  const Buffer<double> areas = triangle_areas(from, edges.duplicates, executor);
  const SurfaceSamples points(from, {areas.data(), areas.size()}, samples, sampling_seed);
  const ClosestPoint closest(to, executor.threads());
  const Sums sums = sum_over_samples(executor, points, closest);
  const auto count = static_cast<double>(samples);
  return {sums.distances / count, std::sqrt(sums.squares / count),
          largest_of_vertices(executor, from, closest, sums.largest)};
}

DistanceFigures SurfaceDistance::two_sided() const {
  return {std::max(from_first.mean, from_second.mean), std::max(from_first.rms, from_second.rms),
          std::max(from_first.largest, from_second.largest)};
}

SurfaceDistance measure_distance(Executor& executor, const Mesh& first, const Mesh& second,
                                 std::size_t samples) {
  const auto one_way = [&](const Mesh& from, const Mesh& to) {
    return measure_distance_one_way(executor, from, find_edges(from, executor), to, samples);
  };
  return {one_way(first, second), one_way(second, first)};
}

}  // namespace geolloyd

#include "parallel/engine/region_totals.h"

#include "core/base/loops.h"
#include "core/base/stopwatch.h"
#include "core/voronoi/fingerprint.h"
#include "core/voronoi/forest.h"

namespace geolloyd {
namespace {

struct SliceTotals {
  Score score = 0;
  std::uint64_t digest = 0;
};

void derive_parents_of(const Graph& graph, std::span<const NodeId> nodes, Partition& partition) {
  for (const NodeId v : nodes) partition.parent[v] = derive_parent(graph, partition.key, v);
}

SliceTotals total_of(const Graph& graph, std::span<const NodeId> nodes,
                     const Partition& partition) {
  SliceTotals totals;
  for (const NodeId v : nodes) {
    totals.score += node_score(distance_of(partition.key[v]), graph.mass[v]);
    totals.digest += digest(v, partition.key[v], partition.parent[v]);
  }
  return totals;
}

}  // namespace

// Range by range of slices, so that what the first loop fetched is in the cache for the second.
void derive_parents_and_totals(Scheduler& scheduler, const Graph& graph,
                               const RegionNodes& region_nodes, std::span<const RegionSlice> slices,
                               Partition& partition, RegionTotals& totals, KernelSeconds& seconds) {
  const Stopwatch watch;
  std::vector<SliceTotals> of_slice(slices.size());
  struct alignas(64) WorkerSeconds : KernelSeconds {};
  std::vector<WorkerSeconds> of_worker(scheduler.threads());
  parallel_for_ranges(scheduler, slices.size(), grain_of(slices),
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        {
                          const Timed timed(of_worker[worker].free_search);
                          for (std::size_t i = begin; i < end; ++i) {
                            derive_parents_of(graph, nodes_of(region_nodes, slices[i]), partition);
                          }
                        }
                        const Timed timed(of_worker[worker].scoring);
                        for (std::size_t i = begin; i < end; ++i) {
                          of_slice[i] =
                              total_of(graph, nodes_of(region_nodes, slices[i]), partition);
                        }
                      });

  for (const RegionSlice& p : slices) {
    totals.score[p.region] = 0;
    totals.digest[p.region] = 0;
  }
  for (std::size_t i = 0; i < slices.size(); ++i) {
    totals.score[slices[i].region] += of_slice[i].score;
    totals.digest[slices[i].region] += of_slice[i].digest;
  }
  KernelSeconds of_threads;
  for (const WorkerSeconds& s : of_worker) of_threads += s;
  share_out(watch.seconds(), of_threads, seconds);
}

}  // namespace geolloyd

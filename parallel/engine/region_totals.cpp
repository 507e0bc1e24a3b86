#include "parallel/engine/region_totals.h"

#include "core/base/loops.h"
#include "core/base/stopwatch.h"
#include "core/voronoi/fingerprint.h"
#include "core/voronoi/forest.h"

namespace geolloyd {
namespace {

struct PieceTotals {
  Score score = 0;
  std::uint64_t digest = 0;
};

void derive_parents_of(const Graph& graph, std::span<const NodeId> nodes, Partition& partition) {
  for (const NodeId v : nodes) partition.parent[v] = derive_parent(graph, partition.key, v);
}

PieceTotals total_of(const Graph& graph, std::span<const NodeId> nodes,
                     const Partition& partition) {
  PieceTotals totals;
  for (const NodeId v : nodes) {
    totals.score += node_score(distance_of(partition.key[v]), graph.mass[v]);
    totals.digest += digest(v, partition.key[v], partition.parent[v]);
  }
  return totals;
}

}  // namespace

// Range by range of pieces, so that what the first loop fetched is in the cache for the second.
void derive_parents_and_totals(Scheduler& scheduler, const Graph& graph,
                               const RegionNodes& region_nodes, std::span<const Piece> pieces,
                               Partition& partition, RegionTotals& totals, KernelSeconds& seconds) {
  const Stopwatch watch;
  std::vector<PieceTotals> of_piece(pieces.size());
  struct alignas(64) WorkerSeconds : KernelSeconds {};
  std::vector<WorkerSeconds> of_worker(scheduler.threads());
  parallel_for_ranges(scheduler, pieces.size(), grain_of(pieces),
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        {
                          const Timed timed(of_worker[worker].free_search);
                          for (std::size_t i = begin; i < end; ++i) {
                            derive_parents_of(graph, nodes_of(region_nodes, pieces[i]), partition);
                          }
                        }
                        const Timed timed(of_worker[worker].scoring);
                        for (std::size_t i = begin; i < end; ++i) {
                          of_piece[i] =
                              total_of(graph, nodes_of(region_nodes, pieces[i]), partition);
                        }
                      });

  for (const Piece& p : pieces) {
    totals.score[p.region] = 0;
    totals.digest[p.region] = 0;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    totals.score[pieces[i].region] += of_piece[i].score;
    totals.digest[pieces[i].region] += of_piece[i].digest;
  }
  KernelSeconds of_threads;
  for (const WorkerSeconds& s : of_worker) of_threads += s;
  share_out(watch.seconds(), of_threads, seconds);
}

}  // namespace geolloyd

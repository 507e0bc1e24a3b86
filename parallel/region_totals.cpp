#include "parallel/region_totals.h"

#include "core/fingerprint.h"
#include "core/forest.h"
#include "parallel/primitives.h"

namespace geolloyd {

void derive_parents_and_totals(Scheduler& scheduler, const Graph& graph, const Members& members,
                               std::span<const Piece> pieces, Partition& partition,
                               RegionTotals& totals) {
  std::vector<Score> score(pieces.size());
  std::vector<std::uint64_t> sum(pieces.size());
  for_items(scheduler, pieces.size(), grain_of(pieces), [&](std::size_t i) {
    Score piece_score = 0;
    std::uint64_t piece_sum = 0;
    for (const NodeId v : nodes_of(members, pieces[i])) {
      const Key key = partition.key[v];
      const NodeId parent = derive_parent(graph, partition.key, v);
      partition.parent[v] = parent;
      piece_score += node_score(distance_of(key), graph.mass[v]);
      piece_sum += digest(v, key, parent);
    }
    score[i] = piece_score;
    sum[i] = piece_sum;
  });

  for (const Piece& p : pieces) {
    totals.score[p.region] = 0;
    totals.digest[p.region] = 0;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    totals.score[pieces[i].region] += score[i];
    totals.digest[pieces[i].region] += sum[i];
  }
}

}  // namespace geolloyd

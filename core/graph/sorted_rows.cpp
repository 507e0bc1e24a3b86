#include "core/graph/sorted_rows.h"

#include <algorithm>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

// Both directions of each arc; loops go.
Bucketed<PlacedArc> bucket_by_source(std::span<const UndirectedArc> arcs, std::size_t nodes,
                                     Executor& executor) {
  return bucket_sort<PlacedArc>(executor, nodes, arcs.size(), [&](std::size_t i, auto&& put) {
    const UndirectedArc& arc = arcs[i];
    if (arc.a == arc.b) return;
    put(arc.a, (PlacedArc{arc.b} << 32) | i);
    put(arc.b, (PlacedArc{arc.a} << 32) | i);
  });
}

// Returns how many are left, in front.
std::uint32_t sort_and_deduplicate(std::span<PlacedArc> row, std::span<const UndirectedArc> arcs) {
  sort_entries(row);
  std::uint32_t kept = 0;
  for (const PlacedArc arc : row) {
    if (kept == 0 || target_of(row[kept - 1]) != target_of(arc)) {
      row[kept++] = arc;
    } else if (length_of(arc, arcs) < length_of(row[kept - 1], arcs)) {
      row[kept - 1] = arc;
    }
  }
  return kept;
}

// An arc to a node reached for the first time, and how deep the node is; before its level is
// complete, how deep the node that it was reached from is.
struct Reached {
  PlacedArc arc;
  double depth;
};

}  // namespace

SortedRows sort_rows(std::span<const UndirectedArc> arcs, std::size_t nodes, Executor& executor) {
  SortedRows rows{bucket_by_source(arcs, nodes, executor), {}};
  rows.first_arc = huge_vector<ArcId>(nodes + 1);
  parallel_for(executor, nodes, small_items, [&](std::size_t v) {
    rows.first_arc[v] = sort_and_deduplicate(rows.placed[v], arcs);
  });
  exclusive_scan<ArcId>(executor, rows.first_arc);
  return rows;
}

// The tree is that of first discovery, row by row: another tree would lead to another tick. Nothing
// here branches on whether a node is new: a guess would be wrong once per node.
Depth tree_depth(const SortedRows& rows, std::span<const UndirectedArc> all_arcs) {
  constexpr std::size_t while_ahead = 12;
  std::vector<std::uint8_t> seen(rows.node_count(), 0);
  Buffer<Reached> reached(rows.node_count() + 1);
  std::size_t size = 0;
  Depth deepest;
  const auto reach = [&](NodeId v, double depth) {
    for (const PlacedArc arc : rows.row(v)) {
      reached[size] = {arc, depth};
      size += 1 - seen[target_of(arc)];
      seen[target_of(arc)] = 1;
    }
  };
  for (NodeId root = 0; root < rows.node_count(); ++root) {
    if (seen[root] != 0) continue;
    seen[root] = 1;
    size = 0;
    reach(root, 0);
    std::size_t level = 0;
    for (std::size_t arcs = 1; level < size; ++arcs) {
      deepest.arcs = std::max(deepest.arcs, arcs);
      const std::size_t end = size;
      for (std::size_t i = level; i < end; ++i) {
        reached[i].depth += length_of(reached[i].arc, all_arcs);
        deepest.length = std::max(deepest.length, reached[i].depth);
      }
      for (; level < end; ++level) {
        // Rows lie wherever their nodes do, but which come next is known a while before. (In a
        // function of their own the compiler would take prefetches for nothing.)
        if (level + 2 * while_ahead < end) {
          const NodeId later = target_of(reached[level + 2 * while_ahead].arc);
          __builtin_prefetch(rows.placed.end.data() + later);
          __builtin_prefetch(rows.first_arc.data() + later);
          __builtin_prefetch(rows.row(target_of(reached[level + while_ahead].arc)).data());
        }
        reach(target_of(reached[level].arc), reached[level].depth);
      }
    }
  }
  return deepest;
}

}  // namespace geolloyd

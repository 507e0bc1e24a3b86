#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/graph.h"
#include "core/partition.h"
#include "parallel/members.h"
#include "parallel/scheduler.h"

namespace geolloyd {

/// Makes a partition, regions free, out of upper bounds: `keys` that are each the length of some
/// way from the seed of the region they name, 0 at the seeds, and that no arc can lower but those
/// at nodes of the `suspects`. Threads relax what they find there, and all it leads to, in any
/// order: there is only one place where nothing can be lowered. Sets `is_dirty` of each region that
/// a node of it changed in, left or joined.
void repair(Scheduler& scheduler, const Graph& graph, const Members& members,
            std::span<const Piece> suspects, std::vector<Key>& keys,
            std::vector<std::uint8_t>& is_dirty);

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <span>

#include "core/partition.h"

namespace geolloyd {

/// 64 bits for a set of seeds in their order.
std::uint64_t digest(std::span<const NodeId> seeds);

/// 64 bits for a whole state: seeds, regions, distances, parents. A sum over nodes, so that it can
/// be taken in any order.
std::uint64_t digest(std::span<const NodeId> seeds, const Partition& partition);

/// The digest of a sequence of states.
std::uint64_t chain(std::uint64_t fingerprint, std::uint64_t next_digest);

}  // namespace geolloyd

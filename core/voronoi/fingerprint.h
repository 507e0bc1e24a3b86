#pragma once

#include <cstdint>
#include <span>

#include "core/base/random.h"
#include "core/graph/graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// 64 bits for a set of seeds in their order.
std::uint64_t digest(std::span<const NodeId> seeds);

/// 64 bits for a whole state: seeds, regions, distances, parents. Made from the sum of its nodes'
/// digests, so that it can be taken in any order.
std::uint64_t digest(std::span<const NodeId> seeds, const Partition& partition);
std::uint64_t digest(std::span<const NodeId> seeds, std::uint64_t sum_of_nodes);
inline std::uint64_t digest(NodeId node, Key key, NodeId parent);

/// 64 bits for all of a graph.
std::uint64_t digest(const Graph& graph);

/// The digest of a sequence of states.
std::uint64_t chain(std::uint64_t fingerprint, std::uint64_t next_digest);

namespace fingerprint_detail {

// Odd, from the golden ratio: keeps equal contents at different places apart.
inline constexpr std::uint64_t stride = 0x9e3779b97f4a7c15u;

inline std::uint64_t at_place(std::uint64_t place, std::uint64_t content) {
  return mix_bits(content + (place + 1) * stride);
}

}  // namespace fingerprint_detail

inline std::uint64_t digest(NodeId node, Key key, NodeId parent) {
  return mix_bits(fingerprint_detail::at_place(node, key) ^ parent);
}

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/types.h"

namespace geolloyd {

/// A node's distance (ticks, high half) and region (low half) in one word, so that comparing keys
/// compares distance first and region second, and adding a length to the high half walks along an
/// arc.
using Key = std::uint64_t;

constexpr Key make_key(std::uint32_t distance, RegionId region) {
  return (Key{distance} << 32) | region;
}
constexpr Key along(Key key, std::uint32_t length) {
  return key + (Key{length} << 32);
}
constexpr std::uint32_t distance_of(Key key) {
  return static_cast<std::uint32_t>(key >> 32);
}
constexpr RegionId region_of(Key key) {
  return static_cast<RegionId>(key);
}

/// The same, but no farther than any distance is (graph.h), so that there is room for one more arc.
constexpr Key bounded_along(Key key, std::uint32_t length) {
  constexpr std::uint32_t farthest = std::uint32_t{1} << 31;
  const std::uint64_t distance = std::uint64_t{distance_of(key)} + length;
  return distance < farthest ? along(key, length) : make_key(farthest, region_of(key));
}

/// No path is so long: distances stay below 2^30, or 2^31 in locked regions (graph.h).
inline constexpr std::uint32_t unreached_distance = std::numeric_limits<std::uint32_t>::max();
/// Of a node that no seed can reach.
inline constexpr Key unreached = make_key(unreached_distance, no_id);

inline bool same_region(const std::vector<Key>& keys, NodeId a, NodeId b) {
  return region_of(keys[a]) == region_of(keys[b]);
}

/// The graph Voronoi diagram of some seeds, with its shortest-path forest (design: canonical
/// definition). Regions free: each key is the smallest over all seeds. Regions locked: each node's
/// region is given, and its distance is that from the region's own seed by way of the region.
/// Parent: the smallest neighbour of the same region on a shortest path; no_id at seeds and at
/// unreached nodes.
struct Partition {
  std::vector<Key> key;        ///< per node
  std::vector<NodeId> parent;  ///< per node
};

}  // namespace geolloyd

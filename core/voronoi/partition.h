#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/graph/graph.h"

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

/// Every distance is below this, regions free or locked. Free ones are below half of it (graph.h).
/// In a locked region a node can always be reached by way of the seed that the region was found
/// from, and neither part of that way is longer than a free distance.
inline constexpr std::uint32_t most_distance = 2 * most_length;

/// The same as along(), but no farther than that, so that there is room for one more arc.
constexpr Key bounded_along(Key key, std::uint32_t length) {
  const std::uint64_t distance = std::uint64_t{distance_of(key)} + length;
  return distance < most_distance ? along(key, length) : make_key(most_distance, region_of(key));
}

inline constexpr std::uint32_t unreached_distance = std::numeric_limits<std::uint32_t>::max();
static_assert(std::uint64_t{most_distance} + most_length < unreached_distance,
              "one arc beyond the farthest node a distance still fits, and is no mark");
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

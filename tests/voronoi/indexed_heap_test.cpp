#include "core/voronoi/indexed_heap.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/random.h"

namespace geolloyd {
namespace {

TEST(IndexedHeap, AgreesWithASortedSet) {
  constexpr NodeId nodes = 200;
  for (std::uint64_t random_seed = 0; random_seed < 20; ++random_seed) {
    IndexedHeap heap(nodes);
    std::set<std::pair<Key, NodeId>> expected;
    std::vector<Key> key(nodes, unreached);
    for (std::uint64_t n = 0; n < 3000; ++n) {
      const std::uint64_t bits = random_bits(random_seed, n);
      const auto node = static_cast<NodeId>(bits % nodes);
      if (bits >> 63 == 0 && !expected.empty()) {
        const NodeId popped = heap.pop();
        ASSERT_EQ(key[popped], expected.begin()->first);
        ASSERT_EQ(expected.erase({key[popped], popped}), 1U);
        key[popped] = unreached;
      } else if ((bits >> 32) % 1000 < key[node]) {
        expected.erase({key[node], node});
        key[node] = (bits >> 32) % 1000;
        expected.emplace(key[node], node);
        heap.push_or_decrease(node, key[node]);
      }
      ASSERT_EQ(heap.empty(), expected.empty());
    }
  }
}

}  // namespace
}  // namespace geolloyd

#pragma once

#include <atomic>

#include "core/voronoi/partition.h"

namespace geolloyd {

// Keys that several threads read and lower at once. The final keys do not depend on the order,
// so no order is asked for; the end of a parallel loop makes them visible to all.

inline Key load_key(const Key& key) {
  return std::atomic_ref(const_cast<Key&>(key)).load(std::memory_order_relaxed);
}

inline void store_key(Key& key, Key value) {
  std::atomic_ref(key).store(value, std::memory_order_relaxed);
}

/// Lowers `key` to `offered` where it is higher. Returns what it was before.
inline Key lower_key(Key& key, Key offered) {
  const std::atomic_ref shared(key);
  Key seen = shared.load(std::memory_order_relaxed);
  while (offered < seen &&
         !shared.compare_exchange_weak(seen, offered, std::memory_order_relaxed)) {
  }
  return seen;
}

}  // namespace geolloyd

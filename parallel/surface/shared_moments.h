#pragma once

#include <atomic>
#include <cstdint>

#include "core/surface/cells/moments.h"

namespace geolloyd {

// Adds to moments that other threads may be adding to. Sums of integers are the same in any order.

inline void add_shared(Moments& sum, const Moments& more) {
  const auto add = [](std::int64_t& to, std::int64_t x) {
    std::atomic_ref(to).fetch_add(x, std::memory_order_relaxed);
  };
  add(sum.area, more.area);
  for (int i = 0; i < 3; ++i) add(sum.first[i], more.first[i]);
  add(sum.second, more.second);
}

inline void add_shared(MetricMoments& sum, const MetricMoments& more) {
  add_shared(sum.moments, more.moments);
  for (int i = 0; i < 6; ++i) {
    std::atomic_ref(sum.metric.parts[i]).fetch_add(more.metric.parts[i], std::memory_order_relaxed);
  }
}

}  // namespace geolloyd

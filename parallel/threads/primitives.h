#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// Calls body(begin, end, worker) for ranges of at most `grain` that make up [0, count), in no
/// particular order; whoever is free takes the next. No two calls with the same `worker` run at
/// once. An exception ends the work and reaches the caller.
template <class Body>
void for_ranges(Scheduler& scheduler, std::size_t count, std::size_t grain, Body&& body) {
  const std::size_t workers = std::min(scheduler.threads(), (count + grain - 1) / grain);
  if (workers <= 1) {
    for (std::size_t begin = 0; begin < count; begin += grain) {
      body(begin, std::min(begin + grain, count), std::size_t{0});
    }
    return;
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  scheduler.run(workers, [&](std::size_t worker) {
    try {
      while (!failed.load(std::memory_order_relaxed)) {
        const std::size_t begin = next.fetch_add(grain, std::memory_order_relaxed);
        if (begin >= count) return;
        body(begin, std::min(begin + grain, count), worker);
      }
    } catch (...) {
      failed.store(true, std::memory_order_relaxed);
      throw;
    }
  });
}

/// The same, item by item: body(i).
template <class Body>
void for_items(Scheduler& scheduler, std::size_t count, std::size_t grain, Body&& body) {
  for_ranges(scheduler, count, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Sum of body(begin, end) over such ranges. For types whose sum is exact, the same every time.
template <class Sum, class Body>
Sum sum_ranges(Scheduler& scheduler, std::size_t count, std::size_t grain, Body&& body) {
  std::vector<Sum> of_worker(scheduler.threads());
  for_ranges(scheduler, count, grain, [&](std::size_t begin, std::size_t end, std::size_t worker) {
    of_worker[worker] += body(begin, end);
  });
  Sum sum{};
  for (const Sum& s : of_worker) sum += s;
  return sum;
}

/// Replaces each value by the sum of those before it and returns the sum of all.
template <class T>
T exclusive_scan(Scheduler& scheduler, std::span<T> values) {
  constexpr std::size_t grain = 1 << 15;
  std::vector<T> before((values.size() + grain - 1) / grain, T{0});
  for_ranges(scheduler, values.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
    T sum{0};
    for (std::size_t i = begin; i < end; ++i) sum += values[i];
    before[begin / grain] = sum;
  });
  T total{0};
  for (T& b : before) {
    const T sum = b;
    b = total;
    total += sum;
  }
  for_ranges(scheduler, values.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
    T running = before[begin / grain];
    for (std::size_t i = begin; i < end; ++i) {
      const T value = values[i];
      values[i] = running;
      running += value;
    }
  });
  return total;
}

/// Calls each of `works` once, at the same time where there are threads for it.
template <class... Works>
void run_each(Scheduler& scheduler, Works&&... works) {
  const std::array<std::function<void()>, sizeof...(Works)> each{std::ref(works)...};
  for_items(scheduler, each.size(), 1, [&](std::size_t i) { each[i](); });
}

// Values that several threads may touch at once; nothing else is ordered by them.

template <class T>
T load(Scheduler& /*scheduler*/, T& value) {
  return std::atomic_ref(value).load(std::memory_order_relaxed);
}
template <class T>
void store(Scheduler& /*scheduler*/, T& value, T desired) {
  std::atomic_ref(value).store(desired, std::memory_order_relaxed);
}
/// Writes `desired` if `value` is `expected`, and returns whether it was.
inline bool replace(Scheduler& /*scheduler*/, std::uint32_t& value, std::uint32_t expected,
                    std::uint32_t desired) {
  return std::atomic_ref(value).compare_exchange_strong(expected, desired,
                                                        std::memory_order_relaxed);
}

}  // namespace geolloyd

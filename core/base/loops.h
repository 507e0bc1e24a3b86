#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/executor.h"

namespace geolloyd {

/// Items to visit at a time where each costs some nanoseconds.
inline constexpr std::size_t small_items = 1 << 12;

/// Calls body(begin, end, worker) for ranges of at most `grain` that make up [0, count), in no
/// particular order; `begin` is a multiple of `grain`. Whoever is free takes the next range. No two
/// calls with the same `worker` run at once. An exception ends the work and reaches the caller.
template <class Body>
void parallel_for_ranges(Executor& executor, std::size_t count, std::size_t grain, Body&& body) {
  const std::size_t workers = std::min(executor.threads(), (count + grain - 1) / grain);
  if (workers <= 1) {
    for (std::size_t begin = 0; begin < count; begin += grain) {
      executor.heed();
      body(begin, std::min(begin + grain, count), std::size_t{0});
    }
    return;
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  executor.run(workers, [&](std::size_t worker) {
    try {
      while (!failed.load(std::memory_order_relaxed)) {
        if (worker == 0) executor.heed();
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

/// Calls body(i) for each i in [0, count), `grain` of them at a time.
template <class Body>
void parallel_for(Executor& executor, std::size_t count, std::size_t grain, Body&& body) {
  parallel_for_ranges(executor, count, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Sum of body(begin, end) over ranges of at most `grain`. `Sum` must add exactly, so that the
/// order of additions is free.
template <class Sum, class Body>
Sum parallel_reduce(Executor& executor, std::size_t count, std::size_t grain, Body&& body) {
  std::vector<Sum> of_worker(executor.threads());
  parallel_for_ranges(executor, count, grain,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        of_worker[worker] += body(begin, end);
                      });
  Sum sum{};
  for (const Sum& s : of_worker) sum += s;
  return sum;
}

/// Replaces each value by the sum of those before it and returns the sum of all.
template <class T>
T exclusive_scan(Executor& executor, std::span<T> values) {
  constexpr std::size_t grain = 1 << 15;
  const auto scan = [&](std::size_t begin, std::size_t end, T sum) {
    for (std::size_t i = begin; i < end; ++i) sum += std::exchange(values[i], sum);
    return sum;
  };
  if (executor.threads() == 1) return scan(0, values.size(), T{0});
  std::vector<T> before((values.size() + grain - 1) / grain, T{0});
  parallel_for_ranges(executor, values.size(), grain,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        T sum{0};
                        for (std::size_t i = begin; i < end; ++i) sum += values[i];
                        before[begin / grain] = sum;
                      });
  T total{0};
  for (T& b : before) total += std::exchange(b, total);
  parallel_for_ranges(executor, values.size(), grain,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        scan(begin, end, before[begin / grain]);
                      });
  return total;
}

/// Calls each of `works` once, at the same time where there are threads for it.
template <class... Works>
void parallel_invoke(Executor& executor, Works&&... works) {
  const std::array<std::function<void()>, sizeof...(Works)> each{std::ref(works)...};
  parallel_for(executor, each.size(), 1, [&](std::size_t i) { each[i](); });
}

// Values that several threads may touch at once. Nothing else is ordered by them; the end of a loop
// makes all writes visible.

template <class T>
T relaxed_load(T& value) {
  return std::atomic_ref(value).load(std::memory_order_relaxed);
}
template <class T>
void relaxed_store(T& value, T desired) {
  std::atomic_ref(value).store(desired, std::memory_order_relaxed);
}
/// Writes `desired` if `value` is `expected`, and returns whether it was.
template <class T>
bool compare_exchange(T& value, T expected, T desired) {
  return std::atomic_ref(value).compare_exchange_strong(expected, desired,
                                                        std::memory_order_relaxed);
}

}  // namespace geolloyd

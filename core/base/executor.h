#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace geolloyd {

/// What happens between a mesh and its graph happens item by item, so it is written once, in
/// templates whose names end in `_on` and whose first argument, the executor, says who visits the
/// items: Sequential, or the Scheduler of a later room, for which the functions below exist with
/// the same meaning (parallel/threads/primitives.h). The result of such a template is the same to
/// the byte in whatever order items are visited, however many at a time. What several items may
/// write to at once they touch only by load, store and replace.
struct Sequential {
  static std::size_t threads() { return 1; }
};

/// Items to visit at a time where each costs some nanoseconds.
inline constexpr std::size_t small_items = 1 << 12;

/// Calls body(begin, end, worker) for ranges that make up [0, count): begin is a multiple of
/// `grain`, worker counts from 0.
template <class Body>
void for_ranges(Sequential& /*executor*/, std::size_t count, std::size_t /*grain*/, Body&& body) {
  if (count > 0) body(std::size_t{0}, count, std::size_t{0});
}

/// Calls body(i) for each i in [0, count).
template <class Body>
void for_items(Sequential& /*executor*/, std::size_t count, std::size_t /*grain*/, Body&& body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

/// Sum of body(begin, end) over such ranges, of a type whose sum is exact.
template <class Sum, class Body>
Sum sum_ranges(Sequential& /*executor*/, std::size_t count, std::size_t /*grain*/, Body&& body) {
  return body(std::size_t{0}, count);
}

/// Replaces each value by the sum of those before it and returns the sum of all.
template <class T>
T exclusive_scan(Sequential& /*executor*/, std::span<T> values) {
  T sum{0};
  for (T& value : values) sum += std::exchange(value, sum);
  return sum;
}

/// Calls each of `works`, at the same time if it can.
template <class... Works>
void run_each(Sequential& /*executor*/, Works&&... works) {
  (works(), ...);
}

template <class T>
T load(Sequential& /*executor*/, T& value) {
  return value;
}
template <class T>
void store(Sequential& /*executor*/, T& value, T desired) {
  value = desired;
}
/// Writes `desired` if `value` is `expected`, and returns whether it was.
inline bool replace(Sequential& /*executor*/, std::uint32_t& value, std::uint32_t expected,
                    std::uint32_t desired) {
  if (value != expected) return false;
  value = desired;
  return true;
}

}  // namespace geolloyd

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/loops.h"

namespace geolloyd {

/// Entries by bucket, those of a bucket in the order of their items.
template <class Entry>
struct Bucketed {
  std::vector<std::uint32_t> end;  ///< per bucket: into `entry`; the next bucket begins there
  Buffer<Entry> entry;

  [[nodiscard]] std::size_t size() const { return end.size(); }
  [[nodiscard]] std::span<Entry> operator[](std::size_t bucket) {
    return {entry.data() + begin(bucket), entry.data() + end[bucket]};
  }
  [[nodiscard]] std::span<const Entry> operator[](std::size_t bucket) const {
    return {entry.data() + begin(bucket), entry.data() + end[bucket]};
  }

 private:
  [[nodiscard]] std::size_t begin(std::size_t bucket) const {
    return bucket > 0 ? end[bucket - 1] : 0;
  }
};

/// Counting sort: emit(item, put) calls put(bucket, entry) for each entry of an item; it is called
/// twice per item. At most 2^32 - 1 entries. Each thread counts a part of the items and then gets
/// room of its own in each bucket. The counts of more than eight parts would take too much memory.
template <class Entry, class Emit>
Bucketed<Entry> bucket_sort(Executor& executor, std::size_t buckets, std::size_t items,
                            Emit&& emit) {
  const std::size_t parts =
      std::clamp(items / small_items, std::size_t{1}, std::min(executor.threads(), std::size_t{8}));
  const auto for_part = [&](std::size_t part, auto&& put) {
    for (std::size_t i = items * part / parts; i < items * (part + 1) / parts; ++i) emit(i, put);
  };
  std::vector<std::vector<std::uint32_t>> place(parts);  // per part and bucket
  parallel_for(executor, parts, 1, [&](std::size_t part) {
    place[part] = huge_vector<std::uint32_t>(buckets);
    std::uint32_t* count = place[part].data();
    for_part(part, [=](std::size_t bucket, const Entry&) { ++count[bucket]; });
  });

  Bucketed<Entry> result;
  result.end = huge_vector<std::uint32_t>(buckets);
  parallel_for(executor, buckets, small_items, [&](std::size_t g) {
    for (std::size_t part = 0; part < parts; ++part) result.end[g] += place[part][g];
  });
  result.entry = Buffer<Entry>(exclusive_scan<std::uint32_t>(executor, result.end));
  parallel_for(executor, buckets, small_items, [&](std::size_t g) {
    for (std::size_t part = 0; part < parts; ++part) {
      result.end[g] += std::exchange(place[part][g], result.end[g]);
    }
  });
  parallel_for(executor, parts, 1, [&](std::size_t part) {
    std::uint32_t* next = place[part].data();
    Entry* entries = result.entry.data();
    for_part(part,
             [=](std::size_t bucket, const Entry& entry) { entries[next[bucket]++] = entry; });
  });
  return result;
}

/// Up to eight entries, by a network (Batcher 1968). It branches on no entry: such a guess would be
/// wrong every other time.
inline void sort_few_entries(std::span<std::uint64_t> entries) {
  constexpr std::size_t most = 8;
  const std::size_t size = entries.size();
  if (size < 2) return;
  const std::uint64_t* from = entries.data();
  std::array<std::uint64_t, most> e;
  for (std::size_t i = 0; i < most; ++i) {
    e[i] = from[std::min(i, size - 1)] | (i < size ? std::uint64_t{0} : ~std::uint64_t{0});
  }
  const auto order = [&e](std::size_t i, std::size_t j) {
    const std::uint64_t a = e[i];
    const std::uint64_t b = e[j];
    e[i] = b < a ? b : a;
    e[j] = b < a ? a : b;
  };
  order(0, 2), order(1, 3), order(4, 6), order(5, 7);
  order(0, 4), order(1, 5), order(2, 6), order(3, 7);
  order(0, 1), order(2, 3), order(4, 5), order(6, 7);
  order(2, 4), order(3, 5);
  order(1, 4), order(3, 6);
  order(1, 2), order(3, 4), order(5, 6);
  std::uint64_t* to = entries.data();
  for (std::size_t i = 0; i < most; ++i) {
    if (i < size) to[i] = e[i];
  }
}

/// A bucket mostly has some six entries. For some more, insertion beats the call of a library sort.
inline void sort_entries(std::span<std::uint64_t> entries) {
  constexpr std::size_t few = 32;
  if (entries.size() <= 8) return sort_few_entries(entries);
  if (entries.size() > few) {
    std::sort(entries.begin(), entries.end());
    return;
  }
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const std::uint64_t entry = entries[i];
    std::size_t slot = i;
    for (; slot > 0 && entries[slot - 1] > entry; --slot) entries[slot] = entries[slot - 1];
    entries[slot] = entry;
  }
}

}  // namespace geolloyd

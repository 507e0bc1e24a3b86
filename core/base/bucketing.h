#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/loops.h"
#include "core/base/sorting_network.h"

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

/// A bucket mostly has six or twelve entries.
inline void sort_entries(std::span<std::uint64_t> entries) {
  if (entries.size() <= 8) return sort_by_network<8>(entries);
  if (entries.size() <= 16) return sort_by_network<16>(entries);
  if (entries.size() <= 32) return sort_by_network<32>(entries);
  std::sort(entries.begin(), entries.end());
}

}  // namespace geolloyd

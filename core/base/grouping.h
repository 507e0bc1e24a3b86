#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/executor.h"

namespace geolloyd {

/// Entries by group, those of a group in the order of their items.
template <class Entry>
struct Groups {
  std::vector<std::uint32_t> end;  ///< per group: into `entry`; the next group begins there
  Buffer<Entry> entry;

  [[nodiscard]] std::size_t size() const { return end.size(); }
  [[nodiscard]] std::span<Entry> operator[](std::size_t group) {
    return {entry.data() + begin(group), entry.data() + end[group]};
  }
  [[nodiscard]] std::span<const Entry> operator[](std::size_t group) const {
    return {entry.data() + begin(group), entry.data() + end[group]};
  }

 private:
  [[nodiscard]] std::size_t begin(std::size_t group) const {
    return group > 0 ? end[group - 1] : 0;
  }
};

/// Puts entries into groups: emit(item, put) calls put(group, entry) for each entry of an item, and
/// is called twice per item. There may be 2^32 - 1 entries. Each thread has a part of the items,
/// counts on its own, and is then given room of its own in each group; the counts of more parts
/// than eight would fill too much memory.
template <class Entry, class Executor, class Emit>
Groups<Entry> group_items(Executor& executor, std::size_t groups, std::size_t items, Emit&& emit) {
  const std::size_t parts =
      std::clamp(items / small_items, std::size_t{1}, std::min(executor.threads(), std::size_t{8}));
  const auto for_part = [&](std::size_t part, auto&& put) {
    for (std::size_t i = items * part / parts; i < items * (part + 1) / parts; ++i) emit(i, put);
  };
  std::vector<std::vector<std::uint32_t>> place(parts);  // per part and group
  for_items(executor, parts, 1, [&](std::size_t part) {
    place[part].assign(groups, 0);
    std::uint32_t* count = place[part].data();
    for_part(part, [=](std::size_t group, const Entry&) { ++count[group]; });
  });

  Groups<Entry> result;
  result.end.resize(groups);
  for_items(executor, groups, small_items, [&](std::size_t g) {
    for (std::size_t part = 0; part < parts; ++part) result.end[g] += place[part][g];
  });
  result.entry = Buffer<Entry>(exclusive_scan<std::uint32_t>(executor, result.end));
  for_items(executor, groups, small_items, [&](std::size_t g) {
    for (std::size_t part = 0; part < parts; ++part) {
      result.end[g] += std::exchange(place[part][g], result.end[g]);
    }
  });
  for_items(executor, parts, 1, [&](std::size_t part) {
    std::uint32_t* next = place[part].data();
    Entry* entries = result.entry.data();
    for_part(part, [=](std::size_t group, const Entry& entry) { entries[next[group]++] = entry; });
  });
  return result;
}

/// Mostly there are some six entries in a group: insertion beats a library sort by the cost of its
/// call.
inline void sort_entries(std::span<std::uint64_t> entries) {
  constexpr std::size_t few = 32;
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

/// A place in one array for what each of many items puts out, in the order of the items.
template <class SizeOf>
class Packing {
 public:
  /// `size_of(item)` is how much an item puts out.
  template <class Executor>
  Packing(Executor& executor, std::size_t items, SizeOf size_of)
      : items_(items), size_of_(std::move(size_of)), before_(items / small_items + 1, 0) {
    for_ranges(executor, items, small_items, [&](std::size_t begin, std::size_t end, std::size_t) {
      std::uint64_t sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += size_of_(i);
      before_[begin / small_items] = sum;
    });
    for (std::uint64_t& before : before_) total_ += std::exchange(before, total_);
  }

  [[nodiscard]] std::uint64_t total() const { return total_; }

  /// Calls write(item, place) for each item that puts out anything.
  template <class Executor, class Write>
  void for_each(Executor& executor, Write&& write) const {
    if (total_ == 0) return;
    for_ranges(executor, items_, small_items, [&](std::size_t begin, std::size_t end, std::size_t) {
      std::uint64_t place = before_[begin / small_items];
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint64_t size = size_of_(i);
        if (size > 0) write(i, place);
        place += size;
      }
    });
  }

 private:
  std::size_t items_;
  SizeOf size_of_;
  std::vector<std::uint64_t> before_;  // per range of items, what those before it put out
  std::uint64_t total_ = 0;
};

/// The items for which `holds(item)`, ascending. It may be called twice.
template <class Executor, class Predicate>
std::vector<std::uint32_t> items_where(Executor& executor, std::size_t items, Predicate&& holds) {
  const Packing packing(executor, items,
                        [&](std::size_t i) { return holds(i) ? std::uint64_t{1} : 0; });
  std::vector<std::uint32_t> found(packing.total());
  packing.for_each(executor, [&](std::size_t i, std::uint64_t place) {
    found[place] = static_cast<std::uint32_t>(i);
  });
  return found;
}

}  // namespace geolloyd

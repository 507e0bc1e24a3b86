#include "core/base/sorting_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/base/bucketing.h"
#include "core/base/random.h"

namespace geolloyd {
namespace {

// A network that sorts all sequences of zeros and ones sorts everything.
TEST(SortingNetwork, SortsAllZerosAndOnes) {
  for (std::size_t size = 0; size <= 16; ++size) {
    for (std::uint32_t bits = 0; bits < std::uint32_t{1} << size; ++bits) {
      std::vector<std::uint64_t> numbers;
      for (std::size_t i = 0; i < size; ++i) numbers.push_back((bits >> i) & 1U);
      auto sorted = numbers;
      sort_by_network<16>(sorted);
      ASSERT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
      ASSERT_EQ(std::count(sorted.begin(), sorted.end(), 1U),
                std::count(numbers.begin(), numbers.end(), 1U));
    }
  }
}

TEST(SortingNetwork, OfEntriesGivesWhatTheLibraryDoes) {
  for (std::uint64_t random_seed = 0; random_seed < 2000; ++random_seed) {
    std::vector<std::uint64_t> entries(random_seed % 45);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i] = random_seed % 2 == 0 ? random_bits(random_seed, i) : random_bits(1, i) % 5;
    }
    if (!entries.empty() && random_seed % 3 == 0) entries.front() = ~std::uint64_t{0};
    auto expected = entries;
    std::sort(expected.begin(), expected.end());
    sort_entries(entries);
    ASSERT_EQ(entries, expected);
  }
}

}  // namespace
}  // namespace geolloyd

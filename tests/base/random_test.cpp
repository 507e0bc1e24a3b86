#include "core/base/random.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/weighted_sampler.h"

namespace geolloyd {
namespace {

TEST(Random, NumbersAreSpreadEvenly) {
  std::array<int, 10> count{};
  double sum = 0;
  for (std::uint64_t n = 0; n < 100000; ++n) {
    ++count[static_cast<std::size_t>(random_below(7, n, 10))];
    sum += random_unit(7, n);
  }
  for (const int c : count) EXPECT_NEAR(c, 10000, 500);
  EXPECT_NEAR(sum / 100000, 0.5, 0.01);
}

TEST(Random, SequencesDiffer) {
  EXPECT_NE(random_bits(1, 0), random_bits(2, 0));
  EXPECT_NE(random_bits(1, 0), random_bits(1, 1));
  EXPECT_EQ(random_bits(1, 5), random_bits(1, 5));
}

TEST(Random, ReachesBoundsBeyondSixtyFourBits) {
  const Uint128 bound = Uint128{1} << 100;
  Uint128 largest = 0;
  for (std::uint64_t n = 0; n < 100; ++n) largest = std::max(largest, random_below(3, n, bound));
  EXPECT_LT(largest, bound);
  EXPECT_GT(largest, bound / 2);
}

TEST(WeightedSampler, FindsTheItemAtEachPlace) {
  WeightedSampler sampler(5000);
  sampler.set(3, 2);
  sampler.set(1500, 5);
  sampler.set(1500, 1);
  sampler.set(4999, Uint128{1} << 90);
  EXPECT_EQ(sampler.total(), (Uint128{1} << 90) + 3);
  EXPECT_EQ(sampler.at(0), 3U);
  EXPECT_EQ(sampler.at(1), 3U);
  EXPECT_EQ(sampler.at(2), 1500U);
  EXPECT_EQ(sampler.at(3), 4999U);
  EXPECT_EQ(sampler.at(sampler.total() - 1), 4999U);
}

}  // namespace
}  // namespace geolloyd

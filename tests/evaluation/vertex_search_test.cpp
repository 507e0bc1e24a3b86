// The search for the fewest vertices, on distances that are known.
#include "tools/evaluation/vertex_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>

#include "core/base/random.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

using Distance = std::function<double(std::size_t vertices)>;

struct Found {
  std::size_t best = 0;
  std::size_t trials = 0;
};

Found search(double tolerance, const Distance& distance) {
  VertexSearch search(tolerance, 1'000'000);
  Found found;
  while (const auto vertices = search.next()) {
    if (search.add({*vertices, distance(*vertices), 0})) found.best = *vertices;
  }
  found.trials = search.trials().size();
  return found;
}

TEST(VertexSearch, ComesCloseToTheFewest) {
  for (const double fewest : {5.0, 77.0, 2'300.0, 400'000.0}) {
    const Found found = search(1, [&](std::size_t n) { return fewest / static_cast<double>(n); });
    EXPECT_GE(static_cast<double>(found.best), fewest);
    EXPECT_LE(static_cast<double>(found.best), 1.06 * fewest + 1);
    EXPECT_LE(found.trials, 20U);
  }
}

// One bad triangle in remeshes of 2700 to 3700 vertices.
TEST(VertexSearch, GoesOnBelowWhatIsTooFarForOnce) {
  const Found found = search(1, [](std::size_t n) {
    const double share = 2'300 / static_cast<double>(n);
    return n > 2'700 && n < 3'700 ? 1.05 : share * share;
  });
  EXPECT_LE(found.best, 2'700U);
}

TEST(VertexSearch, EndsOnDistancesWithoutAnyOrder) {
  const Found found = search(1, [](std::size_t n) { return n * 7919 % 13 < 4 ? 0.5 : 1.5; });
  EXPECT_GT(found.best, 0U);
  EXPECT_LE(found.trials, 40U);
}

// The topology takes a hundred vertices more where fewer are asked for.
TEST(VertexSearch, ComparesTheVerticesThatThereAre) {
  VertexSearch search(1, 1'000'000);
  std::size_t fewest = 1'000'000;
  std::size_t best = 0;
  while (const auto asked = search.next()) {
    const std::size_t vertices = *asked < 1'000 ? *asked + 100 : *asked;
    const double distance = *asked < 930 ? 1.5 : 0.5;
    if (distance <= 1) fewest = std::min(fewest, vertices);
    if (search.add({vertices, distance, distance})) best = vertices;
  }
  EXPECT_EQ(best, fewest);
}

// Whatever the order of distances is, the best is the smallest of those within.
TEST(VertexSearch, NeedsNoOrderOfDistances) {
  for (std::uint64_t random_seed = 1; random_seed < 40; ++random_seed) {
    VertexSearch search(1, 1'000'000);
    std::size_t fewest = 1'000'000;
    std::size_t best = 0;
    while (const auto vertices = search.next()) {
      const double noise = 0.3 + 2 * random_unit(random_seed, *vertices);
      const double distance = 2'000 * noise / static_cast<double>(*vertices);
      if (distance <= 1) fewest = std::min(fewest, *vertices);
      if (search.add({*vertices, distance, distance})) best = *vertices;
    }
    EXPECT_EQ(best, fewest);
    EXPECT_LE(search.trials().size(), 40U);
  }
}

TEST(VertexSearch, RefusesWhatNoNumberReaches) {
  EXPECT_THROW(search(1e-9, [](std::size_t) { return 1.0; }), InvalidInput);
}

}  // namespace
}  // namespace geolloyd

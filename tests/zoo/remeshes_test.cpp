// Remeshes of the zoo, judged by what is true of its parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "bench/zoo/judge.h"
#include "bench/zoo/zoo.h"

namespace geolloyd::zoo {
namespace {

/// What holds for each part of a kind at 2000 vertices.
struct Bounds {
  std::string kind;
  double angle;      ///< at least, degrees; or half of what the part forces
  double valence_6;  ///< at least, a share
  double volume;     ///< off by at most, a share
  double hausdorff;  ///< at most, a share of the diagonal
  double kept;       ///< of sharp edges, at least
};

const std::vector<Bounds>& all_bounds() {
  static const std::vector<Bounds> bounds = {
      {"plate with holes", 2, 0.15, 0.03, 0.012, 0.6},
      {"ribs and steps", 8, 0.5, 1e-4, 0.002, 0.99},
      {"chamfers and fillets", 18, 0.85, 0.002, 0.012, 0.2},
      {"pockets and letters", 2, 0.35, 0.002, 0.005, 0.95},
      {"screw or spring", 4, 0.6, 0.2, 0.015, 0.4},
      {"thin wall", 2, 0.7, 0.002, 0.01, 0.3},
      {"cone or hub", 2, 0.88, 0.002, 0.01, 0.5},
      {"turned part", 25, 0.85, 0.2, 0.008, 0.8},
      {"many pieces", 12, 0.25, 0.06, 0.008, 0.95},
      {"needles", 25, 0.85, 0.004, 0.01, 0.7},
      {"turned aside", 25, 0.85, 0.001, 0.008, 0.7},
      {"fine triangles", 25, 0.85, 0.001, 0.01, 0.7},
      {"split vertices", 25, 0.7, 0.002, 0.008, 0.8},
      {"soft shape", 30, 0.9, 0.06, 0.008, 1},
  };
  return bounds;
}

// Of every part, at any number of vertices.
void expect_sound(const Part& part, const Verdict& verdict) {
  EXPECT_TRUE(verdict.is_manifold);
  EXPECT_TRUE(verdict.has_topology);
  EXPECT_EQ(verdict.flat, 0U);
  EXPECT_LE(static_cast<double>(verdict.vertices), 1.05 * static_cast<double>(verdict.wanted));
  EXPECT_TRUE(!verdict.is_bad() || !verdict.warnings.empty())
      << "volume " << verdict.volume_error << ", Hausdorff " << verdict.hausdorff;
  EXPECT_TRUE(!part.is_soft || verdict.features == 0);
}

void expect_bounds(const Part& part, const Verdict& verdict, const Bounds& bounds) {
  EXPECT_GE(verdict.smallest_angle, std::min(bounds.angle, part.truth.forced_angle / 2));
  EXPECT_GE(verdict.valence_6, bounds.valence_6);
  EXPECT_LE(std::abs(verdict.volume_error), bounds.volume);
  EXPECT_LE(verdict.hausdorff, bounds.hausdorff);
  EXPECT_GE(verdict.kept.value_or(1), bounds.kept);
}

// Quick ones, of most kinds.
TEST(RemeshOfTheZoo, IsSoundAtFewVertices) {
  const std::set<std::string> quick = {
      "plate_4_holes", "countersunk_plate", "ribs",          "chamfer_wide",  "star",
      "tray",          "shaft_fillets",     "spring_square", "thread_square", "needles_plate",
      "split_shaft",   "boxes_36",          "knot",          "ellipsoid"};
  std::size_t seen = 0;
  for (const Cage& cage : zoo()) {
    if (!quick.contains(cage.name)) continue;
    SCOPED_TRACE(cage.name);
    ++seen;
    const Part part = cage.make();
    expect_sound(part, judge(part, 500));
  }
  EXPECT_EQ(seen, quick.size());
}

class RemeshOfAKind : public testing::TestWithParam<Bounds> {};

TEST_P(RemeshOfAKind, IsAsGoodAsItWas) {
  if (std::getenv("GEOLLOYD_LONG_TESTS") == nullptr) {
    GTEST_SKIP() << "set GEOLLOYD_LONG_TESTS to run this";
  }
  for (const Cage& cage : zoo()) {
    const Part part = cage.make();
    if (part.kind != GetParam().kind) continue;
    SCOPED_TRACE(cage.name);
    const Verdict verdict = judge(part, 2000);
    expect_sound(part, verdict);
    expect_bounds(part, verdict, GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RemeshOfAKind, testing::ValuesIn(all_bounds()),
                         [](const auto& given) {
                           std::string name = given.param.kind;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(RemeshOfTheZoo, HasBoundsForEachKind) {
  for (const Cage& cage : zoo()) {
    const std::string kind = cage.make().kind;
    EXPECT_TRUE(std::any_of(all_bounds().begin(), all_bounds().end(), [&](const Bounds& bounds) {
      return bounds.kind == kind;
    })) << kind;
  }
}

}  // namespace
}  // namespace geolloyd::zoo

// Remeshes of the zoo, judged by what is true of its parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "bench/zoo/judge.h"
#include "bench/zoo/zoo.h"

namespace geolloyd::zoo {
namespace {

/// What each part of a kind has at 2000 vertices.
struct Kind {
  std::string name;
  double valence_6 = 0;           ///< share of the vertices, at least
  std::set<std::string> worse{};  ///< parts that are not good in all other figures
};

std::ostream& operator<<(std::ostream& out, const Kind& kind) {
  return out << kind.name;
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"plate with holes",
       0.28,
       {"plate_100_tiny_holes", "plate_close_holes", "plate_thin", "plate_random_1",
        "plate_random_2", "flange_small_bolts", "narrow_slots", "grille_thin_bars",
        "honeycomb_thin"}},
      {"ribs and steps", 0.76, {"heat_sink", "ribs_flat", "step_pyramid_fine", "staircase_fine"}},
      {"thin wall",
       0.85,
       {"box_thin", "tray_thin", "tray_paper", "cup_thin", "bowl_paper", "tube_thin"}},
      {"chamfers and fillets", 0.92, {}},
      {"pockets and letters", 0.57, {"pocket_shallow", "letters_tiny", "gear_fine"}},
      {"screw or spring", 0.70, {"spring_round", "spring_wire", "thread_fine"}},
      {"cone or hub", 0.91, {"cone_spike"}},
      {"turned part", 0.89, {}},
      {"many pieces", 0.35, {"boxes_144", "block_with_crumbs"}},
      {"soft shape", 0.92, {}},
      {"needles", 0.91, {}},
      {"turned aside", 0.91, {}},
      {"fine triangles", 0.91, {}},
      {"split vertices", 0.86, {}},
  };
  return all;
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
  EXPECT_GE(verdict.smallest_angle, std::min(2.0, part.truth.forced_angle / 2));
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

class RemeshOfAKind : public testing::TestWithParam<Kind> {};

TEST_P(RemeshOfAKind, IsAsGoodAsItWas) {
  if (std::getenv("GEOLLOYD_LONG_TESTS") == nullptr) {
    GTEST_SKIP() << "set GEOLLOYD_LONG_TESTS to run this";
  }
  for (const Cage& cage : zoo()) {
    if (cage.kind != GetParam().name) continue;
    SCOPED_TRACE(cage.name);
    const Part part = cage.make();
    const Verdict verdict = judge(part, 2000);
    expect_sound(part, verdict);
    EXPECT_GE(verdict.valence_6, GetParam().valence_6);
    EXPECT_TRUE(verdict.is_good() || GetParam().worse.contains(cage.name));
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RemeshOfAKind, testing::ValuesIn(kinds()), [](const auto& given) {
  std::string name = given.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(RemeshOfTheZoo, IsTestedForEachKind) {
  for (const Cage& cage : zoo()) {
    EXPECT_TRUE(std::any_of(kinds().begin(), kinds().end(), [&](const Kind& known) {
      return known.name == cage.kind;
    })) << cage.kind;
  }
}

}  // namespace
}  // namespace geolloyd::zoo

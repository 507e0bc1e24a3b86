// Triangles that cross, against definitions by segments and by points of whole numbers; and boxes
// that overlap.
#include "core/repair/crossing_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/mesh_quality.h"
#include "core/repair/crossings.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

using Corners = std::array<Vec3, 3>;

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(b - a, c - a), d - a);
}

// The segment passes through the inside.
bool pierces(const Vec3& p, const Vec3& q, const Corners& t) {
  if (volume(t[0], t[1], t[2], p) * volume(t[0], t[1], t[2], q) >= 0) return false;
  const double x = volume(p, q, t[0], t[1]);
  const double y = volume(p, q, t[1], t[2]);
  const double z = volume(p, q, t[2], t[0]);
  return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
}

bool any_edge_pierces(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (pierces(a[i], a[(i + 1) % 3], b) || pierces(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

class Points {
 public:
  explicit Points(std::uint64_t seed) : seed_(seed) {}
  double number() { return random_unit(seed_, next_++); }
  Vec3 point() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  Corners triangle() {
    const Vec3 a = point();
    const Vec3 b = point();
    return {a, b, point()};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

TEST(CrossingTriangles, AreThoseOfWhichAnEdgePassesThroughTheOther) {
  Points random(1);
  std::size_t crossing = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double size = i % 2 == 0 ? 1 : 1e-9;
    Corners a = random.triangle();
    Corners b = random.triangle();
    if (i % 3 == 1) b[0] = a[0];
    if (i % 3 == 2) b = {a[0], a[1], b[2]};
    for (std::size_t c = 0; c < 3; ++c) {
      a[c] = size * a[c] + Vec3(5, 5, 5);
      b[c] = size * b[c] + Vec3(5, 5, 5);
    }
    const bool is_edge_shared = i % 3 == 2;
    EXPECT_EQ(do_cross(a, b), !is_edge_shared && any_edge_pierces(a, b)) << i;
    EXPECT_EQ(do_cross(b, a), do_cross(a, b)) << i;
    crossing += do_cross(a, b) ? 1 : 0;
  }
  EXPECT_GT(crossing, 1'000U);
}

TEST(CrossingTriangles, InOnePlaneAreThoseThatOverlap) {
  const Corners a = {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}};
  EXPECT_TRUE(do_cross(a, a));
  EXPECT_TRUE(do_cross(a, {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}}));  // inside
  EXPECT_TRUE(do_cross(a, {{{1, 1, 1}, {9, 1, 1}, {1, 9, 1}}}));
  EXPECT_TRUE(do_cross(a, {{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}}}));    // beside one edge, same side
  EXPECT_FALSE(do_cross(a, {{{0, 0, 1}, {4, 0, 1}, {0, -4, 1}}}));  // the other side
  EXPECT_FALSE(do_cross(a, {{{0, 0, 1}, {-4, 0, 1}, {0, -4, 1}}}));
  EXPECT_FALSE(do_cross(a, {{{4, 4, 1}, {4, 0, 1}, {0, 4, 1}}}));
  EXPECT_FALSE(do_cross(a, {{{0, 0, 1.5}, {4, 0, 1.5}, {0, 4, 1.5}}}));
}

TEST(CrossingTriangles, AreThoseThatTouchBesideTheirCorners) {
  const Corners a = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  EXPECT_TRUE(do_cross(a, {{{1, 1, 0}, {1, 1, 2}, {2, 1, 2}}}));       // a corner on the inside
  EXPECT_TRUE(do_cross(a, {{{2, 0, 0}, {1, -1, 2}, {2, -1, 2}}}));     // a corner on an edge
  EXPECT_TRUE(do_cross(a, {{{1, 0, 0}, {3, 0, 0}, {2, -1, 0}}}));      // along a part of an edge
  EXPECT_TRUE(do_cross(a, {{{0, 0, 0}, {2, 0, 0}, {2, -1, 0}}}));      // and with a common corner
  EXPECT_FALSE(do_cross(a, {{{0, 0, 0}, {4, 0, 0}, {2, 1, 1e-75}}}));  // a fold of nearly nothing
  EXPECT_FALSE(do_cross(a, {{{1, 1, 1e-70}, {1, 1, 2}, {2, 1, 2}}}));
}

TEST(CrossingTriangles, HaveAnArea) {
  const Corners a = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const Corners needle = {{{1, 1, -1}, {1, 1, 0}, {1, 1, 1}}};
  const Corners point = {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}};
  for (const Corners& flat : {needle, point, Corners{{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}}}}) {
    EXPECT_FALSE(do_cross(a, flat));
    EXPECT_FALSE(do_cross(flat, a));
    EXPECT_FALSE(do_cross(flat, flat));
  }
}

// A point of whole numbers over a common denominator.
struct Fraction {
  std::array<std::int64_t, 3> over{};
  std::int64_t under = 1;
};

// All corners that the intersection of two small triangles of whole numbers can have.
class WholeTriangles {
 public:
  using Place = std::array<std::int64_t, 3>;
  using Three = std::array<Place, 3>;

  WholeTriangles(const Three& first, const Three& second) : first_(first), second_(second) {}

  [[nodiscard]] bool do_cross() const {
    std::vector<Place> shared;
    for (const Place& p : first_) {
      if (std::find(second_.begin(), second_.end(), p) != second_.end()) shared.push_back(p);
    }
    if (shared.size() == 3) return true;
    const std::vector<Fraction> found = corners();
    return std::any_of(found.begin(), found.end(),
                       [&](const Fraction& f) { return !is_of(f, shared); });
  }
  static Place normal(const Three& t) { return cross(minus(t[1], t[0]), minus(t[2], t[0])); }

 private:
  static Place minus(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static std::int64_t dot(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  // From a place to a fraction, times its denominator.
  static Place way(const Place& from, const Fraction& to) {
    Place way;
    for (std::size_t i = 0; i < 3; ++i) way[i] = to.over[i] - to.under * from[i];
    return way;
  }
  // Within the shared corner, or on the shared edge.
  static bool is_of(const Fraction& f, const std::vector<Place>& shared) {
    if (shared.empty()) return false;
    const Place along = way(shared[0], f);
    if (along == Place{}) return true;
    if (shared.size() < 2) return false;
    const Place edge = minus(shared[1], shared[0]);
    return cross(edge, along) == Place{} && dot(edge, along) >= 0 &&
           dot(edge, along) <= f.under * dot(edge, edge);
  }
  static bool is_in(const Fraction& f, const Three& t) {
    const Place n = normal(t);
    if (dot(n, way(t[0], f)) != 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (dot(n, cross(minus(t[(i + 1) % 3], t[i]), way(t[i], f))) < 0) return false;
    }
    return true;
  }
  static Fraction between(const Place& p, const Place& q, std::int64_t share, std::int64_t of) {
    if (of < 0) return between(p, q, -share, -of);
    Fraction f{{}, of};
    for (std::size_t i = 0; i < 3; ++i) f.over[i] = of * p[i] + share * (q[i] - p[i]);
    return f;
  }
  // Where the lines of edges of the one pass the plane of the other; in one plane, its edges.
  static void add(const Three& one, const Three& other, std::vector<Fraction>& found) {
    const Place n = normal(other);
    for (std::size_t i = 0; i < 3; ++i) {
      const Place& p = one[i];
      const Place& q = one[(i + 1) % 3];
      found.push_back({p, 1});
      const std::int64_t height = dot(n, minus(p, other[0]));
      const std::int64_t fall = height - dot(n, minus(q, other[0]));
      if (fall != 0) found.push_back(between(p, q, height, fall));
      if (fall != 0 || height != 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Place across = cross(n, minus(other[(k + 1) % 3], other[k]));
        const std::int64_t way = dot(across, minus(p, other[k]));
        const std::int64_t approach = way - dot(across, minus(q, other[k]));
        if (approach != 0) found.push_back(between(p, q, way, approach));
      }
    }
  }
  [[nodiscard]] std::vector<Fraction> corners() const {
    std::vector<Fraction> found;
    add(first_, second_, found);
    add(second_, first_, found);
    std::erase_if(found,
                  [&](const Fraction& f) { return !is_in(f, first_) || !is_in(f, second_); });
    return found;
  }

  Three first_;
  Three second_;
};

// In a small grid, where all that is degenerate is common; also moved to where rounding would hide
// it.
TEST(CrossingTriangles, AreThoseOfWholeNumbers) {
  std::uint64_t next = 0;
  const auto place = [&] {
    WholeTriangles::Place p;
    for (std::int64_t& x : p) x = static_cast<std::int64_t>(4 * random_unit(5, next++));
    return p;
  };
  std::array<std::size_t, 2> counts{};
  for (std::size_t i = 0; i < 60'000; ++i) {
    const WholeTriangles::Three a = {place(), place(), place()};
    WholeTriangles::Three b = {place(), place(), place()};
    if (i % 4 == 1) b[i % 3] = a[i % 2];
    if (i % 4 == 2) b = {a[1], b[1], a[2]};
    if (WholeTriangles::normal(a) == WholeTriangles::Place{} ||
        WholeTriangles::normal(b) == WholeTriangles::Place{}) {
      continue;
    }
    const double origin = i % 5 == 0 ? 0x1p50 : 0;
    const auto corners = [&](const WholeTriangles::Three& t) {
      Corners c;
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t x = 0; x < 3; ++x) {
          c[k][static_cast<Eigen::Index>(x)] = origin + static_cast<double>(t[k][x]);
        }
      }
      return c;
    };
    const bool expected = WholeTriangles(a, b).do_cross();
    ++counts[expected ? 1 : 0];
    EXPECT_EQ(do_cross(corners(a), corners(b)), expected) << i;
    EXPECT_EQ(do_cross(corners(b), corners(a)), expected) << i;
  }
  EXPECT_GT(counts[0], 10'000U);
  EXPECT_GT(counts[1], 10'000U);
}

std::vector<GrowingBox> some_boxes(std::size_t count, Points& random) {
  std::vector<GrowingBox> boxes(count);
  for (GrowingBox& box : boxes) {
    const Vec3 low = random.point();
    box.add(low);
    box.add(low + 0.3 * random.point());
  }
  return boxes;
}

bool overlap(const GrowingBox& a, const GrowingBox& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

TEST(BoxTree, FindsAllBoxesThatOverlap) {
  Points random(2);
  for (const std::size_t count : {0U, 1U, 8U, 9U, 300U}) {
    const auto boxes = some_boxes(count, random);
    const BoxTree tree(count, [&](std::size_t i) { return boxes[i]; });
    for (int trial = 0; trial < 50; ++trial) {
      GrowingBox asked;
      asked.add(random.point());
      asked.add(random.point());
      std::set<std::uint32_t> found;
      EXPECT_FALSE(tree.any(asked, [&](std::uint32_t i) { return !found.insert(i).second; }));
      std::set<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < count; ++i) {
        if (overlap(boxes[i], asked)) expected.insert(i);
      }
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, FindsAllPairsThatOverlapOnce) {
  Points random(4);
  for (const std::size_t count : {0U, 1U, 8U, 9U, 1000U}) {
    const auto boxes = some_boxes(count, random);
    const BoxTree tree(count, [&](std::size_t i) { return boxes[i]; });
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    tree.for_each_pair(sequential(), [&](std::uint32_t i, std::uint32_t k, std::size_t) {
      EXPECT_TRUE(found.insert({std::min(i, k), std::max(i, k)}).second);
      return true;
    });
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t k = 0; k < count; ++k) {
      for (std::uint32_t i = 0; i < k; ++i) {
        if (overlap(boxes[i], boxes[k])) expected.insert({i, k});
      }
    }
    EXPECT_EQ(found, expected);
  }
}

// Rounding to smaller numbers loses none that touch.
TEST(BoxTree, FindsBoxesThatTouch) {
  Points random(6);
  std::vector<GrowingBox> boxes(200);
  Vec3 last = random.point();
  for (GrowingBox& box : boxes) {
    box.add(last);
    last += 1e-3 * random.point();
    box.add(last);
  }
  const BoxTree tree(boxes.size(), [&](std::size_t i) { return boxes[i]; });
  std::size_t touching = 0;
  tree.for_each_pair(sequential(), [&](std::uint32_t i, std::uint32_t k, std::size_t) {
    touching += std::max(i, k) - std::min(i, k) == 1 ? 1 : 0;
    return true;
  });
  EXPECT_EQ(touching, boxes.size() - 1);
}

TEST(BoxTree, LeavesABoxWhenItIsTold) {
  const std::size_t count = 100;
  const GrowingBox box = [] {
    GrowingBox of;
    of.add(Vec3(0, 0, 0));
    of.add(Vec3(1, 1, 1));
    return of;
  }();
  const BoxTree tree(count, [&](std::size_t) { return box; });
  std::vector<int> pairs(count, 0);
  tree.for_each_pair(sequential(),
                     [&](std::uint32_t i, std::uint32_t, std::size_t) { return ++pairs[i] < 3; });
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(std::vector<int>(pairs.begin(), pairs.begin() + 3), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(pairs[3], 3);
  EXPECT_EQ(pairs.back(), 3);
}

std::vector<TrianglePair> crossings_of_all_pairs(const Mesh& mesh) {
  std::vector<TrianglePair> found;
  for (TriangleId a = 0; a < mesh.triangle_count(); ++a) {
    for (TriangleId b = a + 1; b < mesh.triangle_count(); ++b) {
      const auto corners = [&](TriangleId t) { return corners_of(mesh, mesh.triangles[t]); };
      if (do_cross(corners(a), corners(b))) found.push_back({a, b});
    }
  }
  return found;
}

// From smooth to crumpled: fans that are plain, that fold, and that are open.
TEST(Crossings, AreThoseOfAllPairsOfASurface) {
  for (const double crumpled : {0.0, 0.1, 0.3, 1.0}) {
    for (Mesh mesh : {icosphere(320), torus(300, 1)}) {
      mesh.triangles.erase(mesh.triangles.begin() + 9, mesh.triangles.begin() + 20);
      Points random(7);
      for (Vec3& p : mesh.positions) p += crumpled * random.point();
      if (crumpled > 0.2) mesh.triangles[3] = {mesh.triangles[3][1], mesh.triangles[3][0], 60};
      const auto expected = crossings_of_all_pairs(mesh);
      EXPECT_TRUE(crumpled > 0 || expected.empty());
      EXPECT_TRUE(crumpled < 1 || expected.size() > 100);
      EXPECT_EQ(find_crossings(mesh), expected) << crumpled;
    }
  }
}

// A cone that goes twice around its tip: each triangle is beside its neighbours, and all of the
// first round are on those of the second.
TEST(Crossings, AreThoseOfAConeThatGoesTwiceAround) {
  Mesh cone;
  cone.positions.emplace_back(0, 0, 0);
  const std::array<Vec3, 4> around = {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
  for (VertexId i = 0; i < 8; ++i) {
    cone.positions.push_back((i < 4 ? 1 : 2) * around[i % 4]);
    cone.triangles.push_back({0, i + 1, (i + 1) % 8 + 1});
  }
  EXPECT_EQ(find_crossings(cone), crossings_of_all_pairs(cone));
  EXPECT_GE(find_crossings(cone).size(), 4U);
}

TEST(Crossings, AreNoneWithoutTriangles) {
  EXPECT_TRUE(find_crossings(Mesh{}).empty());
}

TEST(Crossings, AreThoseOfAllPairs) {
  Mesh soup;
  for (std::uint32_t t = 0; t < 200; ++t) {
    const Vec3 at(random_unit(3, 12 * t), random_unit(3, 12 * t + 1), random_unit(3, 12 * t + 2));
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t i = 12 * t + 3 + 3 * c;
      soup.positions.push_back(
          at + 0.6 * Vec3(random_unit(3, i), random_unit(3, i + 1), random_unit(3, i + 2)));
    }
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  soup.triangles.push_back(soup.triangles.front());
  const std::vector<TrianglePair> expected = crossings_of_all_pairs(soup);
  EXPECT_GT(expected.size(), 100U);
  EXPECT_EQ(find_crossings(soup), expected);
}

// The work and the memory for them are not in proportion to the square of their number.
TEST(Crossings, OfATriangleAreNotMoreThanAHundred) {
  Mesh stack;
  stack.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  stack.triangles.assign(1000, {0, 1, 2});
  const std::size_t last = 100 * 99 / 2;  // pairs among the last hundred
  EXPECT_EQ(find_crossings(stack).size(), 100 * 900 + last);
}

}  // namespace
}  // namespace geolloyd

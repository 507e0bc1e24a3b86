// Triangles that pass through each other, against a definition by segments; and boxes that overlap.
#include "core/repair/crossing_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "core/base/box_tree.h"
#include "core/base/random.h"
#include "core/mesh/mesh_quality.h"
#include "core/repair/crossings.h"

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

TEST(BoxTree, FindsAllBoxesThatOverlap) {
  Points random(2);
  for (const std::size_t count : {0U, 1U, 4U, 5U, 300U}) {
    std::vector<GrowingBox> boxes(count);
    for (GrowingBox& box : boxes) {
      const Vec3 low = random.point();
      box.add(low);
      box.add(low + 0.3 * random.point());
    }
    const BoxTree tree(boxes);
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
  soup.triangles.push_back(soup.triangles.front());  // has vertices in common with the first
  std::vector<TrianglePair> expected;
  for (TriangleId b = 0; b < 200; ++b) {
    for (TriangleId a = 0; a < b; ++a) {
      const auto corners = [&](TriangleId t) { return corners_of(soup, soup.triangles[t]); };
      if (do_cross(corners(a), corners(b))) expected.push_back({a, b});
    }
  }
  for (TriangleId a = 1; a < 200; ++a) {
    if (do_cross(corners_of(soup, soup.triangles[a]), corners_of(soup, soup.triangles[200]))) {
      expected.push_back({a, 200});
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_GT(expected.size(), 100U);
  EXPECT_EQ(find_crossings(soup), expected);
}

}  // namespace
}  // namespace geolloyd

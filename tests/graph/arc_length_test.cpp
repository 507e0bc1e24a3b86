#include "core/graph/arc_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace geolloyd {
namespace {

// The edge is on the x axis from 0 to 1; `a` on one plane, `b` on one turned by `fold` about it.
double hinge(double ax, double ay, double bx, double by, double fold) {
  return unfolded_distance({ax, ay, 0}, {bx, -by * std::cos(fold), by * std::sin(fold)}, {0, 0, 0},
                           {1, 0, 0});
}

TEST(UnfoldedDistance, IsStraightAcrossAFlatEdge) {
  EXPECT_DOUBLE_EQ(hinge(0.5, 1, 0.5, 1, 0), 2);
  EXPECT_DOUBLE_EQ(hinge(0.2, 0.3, 0.6, 0.9, 0), std::hypot(0.4, 1.2));
}

// The original program measures the chord, 1.414 for the right-angled fold.
TEST(UnfoldedDistance, DoesNotDependOnTheFold) {
  for (const double fold : {0.1, 0.5 * std::numbers::pi, 2.0, 3.1, -1.0}) {
    EXPECT_NEAR(hinge(0.5, 1, 0.5, 1, fold), 2, 1e-14) << fold;
    EXPECT_NEAR(hinge(0.2, 0.3, 0.6, 0.9, fold), std::hypot(0.4, 1.2), 1e-14) << fold;
  }
}

TEST(UnfoldedDistance, GoesThroughAnEndWhereTheLineMissesTheEdge) {
  // Both points far to the right of the edge: the line would cross its axis at x = 3.
  const double through_end = std::hypot(2, 1) + std::hypot(2, 1);
  EXPECT_NEAR(hinge(3, 1, 3, 1, 0.0), through_end, 1e-14);
  EXPECT_NEAR(hinge(3, 1, 3, 1, 1.0), through_end, 1e-14);
  // To the left, by the other end.
  EXPECT_NEAR(hinge(-2, 1, -1, 0.5, 1.0), std::hypot(2, 1) + std::hypot(1, 0.5), 1e-14);
  // Just inside and just outside of the end the two ways agree.
  EXPECT_NEAR(hinge(1, 1, 1, 1, 1.0), 2, 1e-14);
}

TEST(UnfoldedDistance, OfAnEdgeWithoutLengthGoesThroughIt) {
  EXPECT_DOUBLE_EQ(unfolded_distance({1, 0, 0}, {0, 2, 0}, {0, 0, 0}, {0, 0, 0}), 3);
}

TEST(UnfoldedDistance, OfTrianglesWithoutAreaStaysFinite) {
  // All on the axis: along the edge where the way touches it, else through the nearer end twice.
  EXPECT_DOUBLE_EQ(hinge(0.25, 0, 0.75, 0, 0), 0.5);
  EXPECT_DOUBLE_EQ(hinge(-1, 0, 2, 0, 0), 3);
  EXPECT_DOUBLE_EQ(hinge(2, 0, 3, 0, 0), 3);
  EXPECT_DOUBLE_EQ(unfolded_distance({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 0);
}

TEST(UnfoldedDistance, WorksAtAnySize) {
  for (const double s : {1e-60, 1e-30, 1e30, 1e60}) {
    const double d = unfolded_distance({0.5 * s, s, 0}, {0.5 * s, 0, s}, {0, 0, 0}, {s, 0, 0});
    EXPECT_NEAR(d / s, 2, 1e-14) << s;
  }
}

TEST(Measure, FollowsTheAxesOfTheCoordinatesWithoutAField) {
  const Vec3 d(3, -4, 12);
  EXPECT_DOUBLE_EQ(measure(d, Norm::geodesic), 13);
  EXPECT_DOUBLE_EQ(measure(d, Norm::manhattan), 19);
  EXPECT_DOUBLE_EQ(measure(d, Norm::linf), 12);
}

TEST(Measure, FollowsTheFieldAndAppliesEachMagnitudeOnce) {
  const double c = std::numbers::sqrt2 / 2;
  const TangentSpace space{{c, c, 0}, {-c, c, 0}, 3, 1};
  const Vec3 along = Vec3(c, c, 0) * 2;
  const Vec3 across = Vec3(-c, c, 0) * 2;
  // The original program squares the magnitude: 18.
  EXPECT_NEAR(measure(along, space, Norm::geodesic), 6, 1e-14);
  EXPECT_NEAR(measure(across, space, Norm::geodesic), 2, 1e-14);
  EXPECT_NEAR(measure(along + across, space, Norm::geodesic), std::hypot(6, 2), 1e-14);
  EXPECT_NEAR(measure(along + across, space, Norm::manhattan), 8, 1e-14);
  EXPECT_NEAR(measure(along + across, space, Norm::linf), 6, 1e-14);
}

}  // namespace
}  // namespace geolloyd

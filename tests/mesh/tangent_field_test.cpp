#include "core/fields/tangent_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "core/base/random.h"
#include "core/fields/tangent_field_file.h"
#include "core/graph/arc_length.h"
#include "geolloyd/errors.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

const TangentSpace axes{{1, 0, 0}, {0, 1, 0}, 3, 1};

TangentSpace turned(const TangentSpace& s, double angle) {
  return {s.tangent * std::cos(angle) + s.bitangent * std::sin(angle),
          s.bitangent * std::cos(angle) - s.tangent * std::sin(angle), s.tangent_magnitude,
          s.bitangent_magnitude};
}

TEST(TangentSpaces, AverageOfTwoNearOnesLiesBetweenThem) {
  const TangentSpace mean = average(axes, turned(axes, 0.4), Averaging::pairwise);
  const TangentSpace expected = turned(axes, 0.2);
  EXPECT_NEAR((mean.tangent - expected.tangent).norm(), 0, 1e-14);
  EXPECT_NEAR((mean.bitangent - expected.bitangent).norm(), 0, 1e-14);
  EXPECT_DOUBLE_EQ(mean.tangent_magnitude, 3);
  EXPECT_DOUBLE_EQ(mean.bitangent_magnitude, 1);
}

// The same metric written with its directions turned by quarters must average to the same metric.
// The original program forgets to let the magnitudes follow.
TEST(TangentSpaces, AverageDoesNotDependOnHowTheSecondIsWritten) {
  const TangentSpace other = turned(axes, 0.3);
  const TangentSpace opposite{-other.tangent, -other.bitangent, 3, 1};
  const TangentSpace swapped{other.bitangent, -other.tangent, 1, 3};
  const TangentSpace swapped_back{-other.bitangent, other.tangent, 1, 3};
  const TangentSpace mirrored{other.tangent, -other.bitangent, 3, 1};
  const TangentSpace exchanged{other.bitangent, other.tangent, 1, 3};
  const Vec3 d(0.3, -0.8, 0.1);
  const double expected = measure(d, average(axes, other, Averaging::pairwise), Norm::geodesic);
  for (const TangentSpace& same : {opposite, swapped, swapped_back, mirrored, exchanged}) {
    EXPECT_NEAR(measure(d, average(axes, same, Averaging::pairwise), Norm::geodesic), expected,
                1e-14);
  }
}

TEST(TangentSpaces, AverageIsSymmetricAsAMetric) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const TangentSpace other{
        normalized({random_unit(1, 6 * i) - 0.5, random_unit(1, 6 * i + 1) - 0.5, 0}),
        normalized({0, random_unit(1, 6 * i + 2) - 0.5, 0.1}), 2, 5};
    const Vec3 d(random_unit(1, 6 * i + 3), random_unit(1, 6 * i + 4), random_unit(1, 6 * i + 5));
    EXPECT_NEAR(measure(d, average(axes, other, Averaging::pairwise), Norm::geodesic),
                measure(d, average(other, axes, Averaging::pairwise), Norm::geodesic), 1e-12);
  }
}

TEST(TangentSpaces, OfATriangleWeighsItsThirdVertexTwice) {
  const TangentSpace of_triangle =
      triangle_space({0, 1, 2}, {axes, turned(axes, 0.4), turned(axes, 0.6)}, Averaging::pairwise);
  EXPECT_NEAR((of_triangle.tangent - turned(axes, 0.4).tangent).norm(), 0, 1e-14);
}

class TangentFieldFile : public testing::Test {
 protected:
  std::vector<TangentSpace> read(const std::string& text, std::size_t vertices) {
    return read_tangent_field(folder_.write("a.vfield", text), vertices);
  }

  void expect_refused(const std::string& text, std::size_t vertices, const std::string& message) {
    try {
      read(text, vertices);
      FAIL() << "accepted: " << text;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("a.vfield: line "), std::string::npos);
    }
  }

  TemporaryFolder folder_;
};

constexpr const char* column_names = "k1\t k2\t k1v_x\t k1v_y\t k1v_z\t k2v_x\t k2v_y\t k2v_z\n";

TEST_F(TangentFieldFile, IsReadWithAndWithoutHeaderLines) {
  const std::string rows = "3 1 0 2 0 0 0 1\r\n-2 1 1 0 0 0 1 0\n";
  for (const std::string header :
       {"", "# Thresholds used: tk_thresh = , a_thresh = \ntarget frame \n2\n"}) {
    const auto spaces = read(header + column_names + rows, 2);
    ASSERT_EQ(spaces.size(), 2U);
    EXPECT_EQ(spaces[0].tangent, Vec3(0, 1, 0));  // the magnitude is k1's alone
    EXPECT_EQ(spaces[0].bitangent, Vec3(0, 0, 1));
    EXPECT_EQ(spaces[0].tangent_magnitude, 3);
    EXPECT_EQ(spaces[1].tangent_magnitude, 2);
  }
}

TEST_F(TangentFieldFile, IsRefusedWithTheLineWhereItIsWrong) {
  const std::string row = "3 1 0 2 0 0 0 1\n";
  expect_refused("", 1, "no line of column names");
  expect_refused(row, 1, "no line of column names");
  expect_refused(column_names + row, 2, "ends after 1 vertices, but the mesh has 2");
  expect_refused(column_names + row + row, 1, "line 3: more lines than the mesh has vertices");
  expect_refused(column_names + row + "3 1 0 2 0 0 0\n", 2, "line 3");
  expect_refused(column_names + row + "3 1 0 2 0 0 0 1 9\n", 2, "line 3: more than the eight");
  expect_refused(column_names + row + "3 1 x 2 0 0 0 1\n", 2, "line 3");
  expect_refused(column_names + std::string("3 1 nan 2 0 0 0 1\n"), 1, "line 2: k1v_x");
  expect_refused(column_names + std::string("1e300 1 0 2 0 0 0 1\n"), 1, "line 2: k1");
}

}  // namespace
}  // namespace geolloyd

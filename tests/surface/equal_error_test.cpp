#include "core/surface/sizing/equal_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/closest_on_triangle.h"
#include "core/shapes/shapes.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"
#include "tests/support/spiked_sphere.h"

namespace geolloyd {
namespace {

double cells_at(const std::vector<MeasuredCell>& cells, const std::vector<double>& lengths) {
  double sum = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    sum += std::pow(cells[c].length / lengths[c], 2);
  }
  return sum;
}

TEST(EqualError, OfAlikeCellsIsEven) {
  const std::vector<MeasuredCell> cells(100, {0.1, 0.002});
  for (const double length : lengths_of_equal_error(cells, 100)) EXPECT_NEAR(length, 0.1, 1e-9);
  for (const double length : lengths_of_equal_error(cells, 400)) EXPECT_NEAR(length, 0.05, 1e-9);
}

TEST(EqualError, ShortensByTheRootWhereSmoothAndInProportionWhereSharp) {
  std::vector<MeasuredCell> cells(100, {0.1, 1e-5});
  cells[7].distance = 4e-5;
  cells[8].distance = 0;
  const std::vector<double> smooth = lengths_of_equal_error(cells, 100);
  EXPECT_NEAR(smooth[7], smooth[0] / 2, 1e-3 * smooth[0]);
  EXPECT_NEAR(smooth[8], 1.2 * 0.1, 1e-9);
  EXPECT_NEAR(cells_at(cells, smooth), 100, 1e-6);
  std::vector<MeasuredCell> sharp(100, {0.1, 0.05});
  sharp[7] = {0.2, 0.1};
  const std::vector<double> lengths = lengths_of_equal_error(sharp, 100);
  EXPECT_NEAR(lengths[7], lengths[0], 1e-9);
  EXPECT_NEAR(cells_at(sharp, lengths), 100, 1e-6);
}

TEST(EqualError, KeepsLengthsWithinLimits) {
  std::vector<MeasuredCell> cells(10'000, {0.01, 1e-7});
  cells[7].distance = 0.005;
  const std::vector<double> lengths = lengths_of_equal_error(cells, 10'000);
  EXPECT_NEAR(lengths[7], 0.0025, 1e-9);
  EXPECT_LE(*std::max_element(lengths.begin(), lengths.end()), 0.012 * (1 + 1e-9));
  for (const double length : lengths_of_equal_error(std::vector<MeasuredCell>(9, {1, 0}), 9)) {
    EXPECT_TRUE(length > 0.9 && length < 1.3) << length;
  }
}

Remesh remesh_with(const Mesh& mesh, std::size_t vertices, bool equal_error) {
  RemeshOptions options;
  options.vertex_count = vertices;
  options.sizing.equal_error = equal_error;
  return remesh(mesh, options, reference_runtime());
}

TEST(EqualError, OfASphereAndATorusIsEven) {
  for (const Mesh& mesh : {icosphere(8000), torus(8000, 1)}) {
    const Remesh made = remesh_with(mesh, 300, true);
    EXPECT_TRUE(made.edge_lengths.empty());
    EXPECT_EQ(made.fingerprint, remesh_with(mesh, 300, false).fingerprint);
  }
}

double largest_distance(const Mesh& mesh, const Mesh& remesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : remesh.triangles) {
      const std::array<Vec3, 3> corners = {remesh.positions[a] - p, remesh.positions[b] - p,
                                           remesh.positions[c] - p};
      const auto [v, w] = barycentric_closest_to_origin(corners);
      least = std::min(least, norm((1 - v - w) * corners[0] + v * corners[1] + w * corners[2]));
    }
    largest = std::max(largest, least);
  }
  return largest;
}

TEST(EqualError, OfASpikeHasShortEdgesThereAndIsCloser) {
  const Mesh mesh = spiked_sphere();
  const Remesh made = remesh_with(mesh, 400, true);
  EXPECT_TRUE(made.has_input_topology());
  EXPECT_EQ(made.mesh.vertex_count(), 400U);
  double at_spike = 0;
  double elsewhere = 0;
  for (std::size_t v = 0; v < made.edge_lengths.size(); ++v) {
    const double z = made.mesh.positions[v].z();
    if (z > 1.4) at_spike = made.edge_lengths[v];
    if (z < -0.9) elsewhere = made.edge_lengths[v];
  }
  ASSERT_GT(at_spike, 0);
  EXPECT_LT(at_spike, 0.6 * elsewhere);
  EXPECT_LT(largest_distance(mesh, made.mesh),
            0.7 * largest_distance(mesh, remesh_with(mesh, 400, false).mesh));
}

}  // namespace
}  // namespace geolloyd

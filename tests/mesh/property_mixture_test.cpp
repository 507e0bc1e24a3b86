// Properties of a remesh, from those of the mesh.
#include "core/properties/property_mixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/properties/properties.h"
#include "core/shapes/shapes.h"
#include "geolloyd/remesh.h"

namespace geolloyd {
namespace {

template <class Number>
Number mixed(const std::string& name, std::vector<Number> values, const Mixture& mixture) {
  const std::vector<Property> properties = {{name, std::move(values)}};
  const std::vector<Property> one = mix(properties, std::span(&mixture, 1));
  return std::get<std::vector<Number>>(one.at(0).values).at(0);
}

const Mixture thirds = {{{0, 1.0 / 3}, {1, 1.0 / 3}, {2, 1.0 / 3}}};

TEST(PropertyMixture, NumbersAreWeightedMeans) {
  EXPECT_DOUBLE_EQ(mixed<double>("q", {1, 2, 6}, thirds), 3);
  EXPECT_FLOAT_EQ(mixed<float>("q", {0, 4}, {{{0, 0.25}, {1, 0.75}}}), 3);
}

TEST(PropertyMixture, EqualNumbersKeepTheirBits) {
  const double odd = 0.1;
  EXPECT_EQ(mixed<double>("q", {odd, odd, odd}, thirds), odd);
  EXPECT_TRUE(std::signbit(mixed<double>("q", {-0.0, -0.0, -0.0}, thirds)));
  EXPECT_EQ(mixed<double>("q", {odd, 7, 8}, {{{0, 1}, {1, 0}, {2, 0}}}), odd);
}

TEST(PropertyMixture, NeverLeavesTheRangeOfWhatIsMixed) {
  const double most = std::numeric_limits<double>::max();
  const Mixture more = {{{0, 0.5}, {1, 0.5000000000000002}}};
  EXPECT_EQ(mixed<double>("q", {most, std::nextafter(most, 0.0)}, more), most);
  EXPECT_EQ(mixed<std::uint32_t>("red", {4294967295U, 4294967294U}, more), 4294967295U);
}

TEST(PropertyMixture, WhatIsNoNumberCountsOnlyWithAWeight) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(mixed<double>("q", {none, 1, 2}, thirds)));
  EXPECT_EQ(mixed<double>("q", {none, 1, 3}, {{{0, 0}, {1, 0.5}, {2, 0.5}}}), 2);
  EXPECT_EQ(mixed<double>("q", {infinite, 1, 3}, {{{0, 0}, {1, 0.5}, {2, 0.5}}}), 2);
  EXPECT_EQ(mixed<double>("q", {infinite, 1, 3}, thirds), infinite);
  EXPECT_TRUE(std::isnan(mixed<double>("q", {infinite, -infinite, 3}, thirds)));
  EXPECT_TRUE(std::isnan(mixed<double>("q", {1, 2, 3}, Mixture{})));
  EXPECT_EQ(mixed<std::uint8_t>("red", {1, 2, 3}, Mixture{}), 0);
}

TEST(PropertyMixture, ColoursAreRounded) {
  const Mixture halves = {{{0, 0.5}, {1, 0.5}}};
  EXPECT_EQ(mixed<std::uint8_t>("red", {0, 255}, halves), 128);
  EXPECT_EQ(mixed<std::uint8_t>("alpha", {1, 2}, {{{0, 0.75}, {1, 0.25}}}), 1);
  EXPECT_EQ(mixed<std::uint8_t>("diffuse_red", {10, 20}, halves), 15);
  EXPECT_EQ(mixed<std::int16_t>("input_blue", {-3, -4}, halves), -3);
}

TEST(PropertyMixture, LabelsGoByMajority) {
  const Mixture shares = {{{0, 0.3}, {1, 0.4}, {2, 0.3}}};
  EXPECT_EQ(mixed<std::int32_t>("label", {9, 2, 9}, shares), 9);
  EXPECT_EQ(mixed<std::int32_t>("label", {9, 2, 1}, shares), 2);
  EXPECT_EQ(mixed<std::uint8_t>("reddish", {200, 100, 0}, shares), 100);
  const Mixture even = {{{0, 0.25}, {1, 0.25}, {2, 0.25}, {3, 0.25}}};
  EXPECT_EQ(mixed<std::int32_t>("label", {5, 7, 7, 5}, even), 5);
  EXPECT_EQ(mixed<std::int32_t>("label", {5, 7, -7, -8}, even), -8);
}

TEST(PropertyMixture, NormalsHaveLengthOne) {
  const std::vector<Property> normals = {{"nx", std::vector<float>{1, 0, 0}},
                                         {"ny", std::vector<float>{0, 1, 0}},
                                         {"nz", std::vector<float>{0, 0, 1}}};
  const std::vector<Mixture> mixtures = {thirds, {{{0, 0.9}, {2, 0.1}}}};
  const std::vector<Property> made = mix(normals, mixtures);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 n(value_at(made[0], i), value_at(made[1], i), value_at(made[2], i));
    EXPECT_NEAR(norm(n), 1, 1e-7);
  }
  EXPECT_NEAR(value_at(made[0], 0), std::sqrt(1.0 / 3), 1e-7);
  const std::vector<Property> opposite = {{"nx", std::vector<double>{1, -1}},
                                          {"ny", std::vector<double>{0, 0}},
                                          {"nz", std::vector<double>{0, 0}}};
  const std::vector<Mixture> halves = {{{{0, 0.5}, {1, 0.5}}}};
  EXPECT_EQ(value_at(mix(opposite, halves)[0], 0), 0);
}

// A linear function on a flat and on a curved surface stays one.
TEST(PropertyMixture, LinearFunctionsAreInterpolatedExactly) {
  for (const Mesh& mesh : {irregular_plane(2000, 1), icosphere(2000)}) {
    const auto linear = [](const Vec3& p) { return 1 + 2 * p.x() - 3 * p.y() + 0.5 * p.z(); };
    std::vector<double> q;
    std::vector<std::uint8_t> red;
    for (const Vec3& p : mesh.positions) {
      q.push_back(linear(p));
      red.push_back(static_cast<std::uint8_t>(100.5 + 40 * p.x()));
    }
    RemeshOptions options;
    options.vertex_count = 100;
    options.fit = false;
    const Remesh made = remesh(mesh, options, reference_runtime());
    const std::vector<Property> properties = {{"q", q}, {"red", red}};
    const std::vector<Property> values =
        values_at(mesh, properties, made.places, reference_runtime());
    for (std::size_t v = 0; v < made.mesh.vertex_count(); ++v) {
      const Vec3& p = made.mesh.positions[v];
      EXPECT_NEAR(value_at(values[0], v), linear(p), 1e-13);
      EXPECT_NEAR(value_at(values[1], v), 100 + 40 * p.x(), 1.01);
    }
  }
}

}  // namespace
}  // namespace geolloyd

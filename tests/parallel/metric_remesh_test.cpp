// Remeshes in a metric: as regular in it as others are in space.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/fields/principal_direction.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_quality.h"
#include "core/shapes/shapes.h"
#include "core/surface/result/remesh.h"
#include "core/surface/sizing/field_metric.h"
#include "geolloyd/threads.h"
#include "tests/support/sanitizers.h"

namespace geolloyd {
namespace {

// Of the torus of core/shapes, around its axis and across.
TangentSpace ring_space(const Vec3& p, double around, double across) {
  const Vec3 outward = normalized(Vec3(p.x(), p.y(), 0));
  const Vec3 ring = cross(Vec3::UnitZ(), outward);
  const Vec3 normal = normalized(p - outward);
  return {ring, cross(normal, ring), around, across};
}

// Turned in its plane.
TangentSpace turned(const TangentSpace& space, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * space.tangent + s * space.bitangent, c * space.bitangent - s * space.tangent,
          space.tangent_magnitude, space.bitangent_magnitude};
}

struct JudgedRemesh {
  Remesh remesh;
  MeshQuality quality;  ///< in the metric
};

class MetricRemesh : public testing::Test {
 protected:
  void SetUp() override {
    if (under_sanitizer) GTEST_SKIP() << "takes minutes with a sanitizer";
  }

  [[nodiscard]] JudgedRemesh remesh_in(const Mesh& mesh,
                                       const std::function<TangentSpace(const Vec3&)>& field) {
    RemeshOptions options;
    options.vertex_count = 1024;
    for (const Vec3& p : mesh.positions) options.field.push_back(field(p));
    JudgedRemesh judged;
    judged.remesh = make_remesh(mesh, find_edges(mesh), options, runtime_);
    judged.quality =
        measure_quality(judged.remesh.mesh, find_edges(judged.remesh.mesh),
                        shapes_at(mesh, shapes_of(options.field), judged.remesh.places));
    return judged;
  }

 private:
  Threads runtime_;
};

void expect_regular(const JudgedRemesh& judged, double quality, double valence_6) {
  EXPECT_TRUE(judged.remesh.has_input_topology());
  EXPECT_EQ(judged.remesh.mesh.vertex_count(), 1024U);
  EXPECT_GE(judged.quality.mean_quality, quality);
  EXPECT_GE(judged.quality.share_valence_6, valence_6);
}

TEST_F(MetricRemesh, OfATorusWithConstantStretchIsRegular) {
  const JudgedRemesh judged =
      remesh_in(torus(10'000, 1), [](const Vec3& p) { return ring_space(p, 3, 1); });
  expect_regular(judged, 0.93, 0.9);
}

TEST_F(MetricRemesh, OfAVaryingFieldIsRegular) {
  const JudgedRemesh judged = remesh_in(torus(10'000, 1), [](const Vec3& p) {
    return turned(ring_space(p, 2.5 + p.x(), 1), 2 * p.z());
  });
  expect_regular(judged, 0.9, 0.8);
}

// Directions turn by half a turn about the middle: there is none in the middle itself.
TEST_F(MetricRemesh, OfASingularFieldIsRegular) {
  const JudgedRemesh judged = remesh_in(irregular_plane(20'000, 1), [](const Vec3& p) {
    const auto [c, s] = principal_direction(p.x() - 0.5, p.y() - 0.5);
    return TangentSpace{{c, s, 0}, {-s, c, 0}, 3, 1};
  });
  expect_regular(judged, 0.9, 0.85);
}

TEST_F(MetricRemesh, LosesNoSiteWhereTheStretchIsEight) {
  const JudgedRemesh across =
      remesh_in(torus(10'000, 1), [](const Vec3& p) { return ring_space(p, 1, 8); });
  expect_regular(across, 0.82, 0.75);
  const JudgedRemesh around =
      remesh_in(torus(10'000, 1), [](const Vec3& p) { return ring_space(p, 8, 1); });
  expect_regular(around, 0.88, 0.75);
}

}  // namespace
}  // namespace geolloyd

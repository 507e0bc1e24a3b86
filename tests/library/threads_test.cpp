// The public headers on threads: what the reference computes, to the bit.
#include <geolloyd/geolloyd.h>
#include <gtest/gtest.h>

#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

TEST(Threads, ComputeWhatTheReferenceComputes) {
  const Mesh mesh = creature(6000, 1);
  TessellateOptions options;
  options.seed_count = 40;
  const Tessellation expected = tessellate(mesh, options);
  const Remesh expected_remesh = remesh(mesh, expected);
  for (const Backend backend : {Backend::tbb, Backend::openmp}) {
    for (const std::size_t count : {1U, 2U, 3U}) {
      Threads threads(count, backend);
      EXPECT_EQ(threads.count(), count);
      const Tessellation tested = tessellate(mesh, options, threads);
      EXPECT_EQ(tested.fingerprint, expected.fingerprint);
      EXPECT_EQ(tested.region, expected.region);
      EXPECT_EQ(tested.distance, expected.distance);
      EXPECT_EQ(tested.parent, expected.parent);
      const Remesh tested_remesh = remesh(mesh, tested, {}, threads);
      EXPECT_EQ(tested_remesh.mesh.positions, expected_remesh.mesh.positions);
      EXPECT_EQ(tested_remesh.mesh.triangles, expected_remesh.mesh.triangles);
    }
  }
}

}  // namespace
}  // namespace geolloyd

// The public headers on threads: what the reference computes, to the bit.
#include <geolloyd/geolloyd.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

TEST(Threads, ComputeWhatTheReferenceComputes) {
  const Mesh mesh = creature(6000, 1);
  RelaxOptions options;
  options.seed_count = 40;
  const Tessellation expected = relax(mesh, options, reference_runtime());
  const Dual expected_remesh = dual(mesh, expected, {}, reference_runtime());
  for (const Backend backend : {Backend::tbb, Backend::openmp}) {
    for (const std::size_t count : {1U, 2U, 3U}) {
      Threads threads(count, backend);
      EXPECT_EQ(threads.count(), count);
      const Tessellation tested = relax(mesh, options, threads);
      EXPECT_EQ(tested.fingerprint, expected.fingerprint);
      EXPECT_EQ(tested.region, expected.region);
      EXPECT_EQ(tested.distance, expected.distance);
      EXPECT_EQ(tested.parent, expected.parent);
      const Dual tested_remesh = dual(mesh, tested, {}, threads);
      EXPECT_EQ(tested_remesh.mesh.positions, expected_remesh.mesh.positions);
      EXPECT_EQ(tested_remesh.mesh.triangles, expected_remesh.mesh.triangles);
    }
  }
}

// The default runtime.
TEST(Threads, AllOfThemServeSeveralCallersAtOnce) {
  const Mesh mesh = creature(6000, 1);
  RelaxOptions options;
  options.seed_count = 40;
  const std::uint64_t expected = relax(mesh, options, reference_runtime()).fingerprint;
  std::vector<std::uint64_t> found(3, 0);
  std::vector<std::thread> callers;
  for (std::uint64_t& fingerprint : found) {
    callers.emplace_back([&] { fingerprint = relax(mesh, options).fingerprint; });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(found, std::vector<std::uint64_t>(3, expected));
}

TEST(Threads, AreAtMostAsManyAsAllowed) {
  EXPECT_THROW(Threads(most_threads + 1), InvalidInput);
  EXPECT_THROW(Threads(static_cast<std::size_t>(-1), Backend::openmp), InvalidInput);
}

TEST(Threads, AThrowingCallbackEndsTheWorkAndTheNextOneGoesOn) {
  const Mesh mesh = creature(6000, 1);
  Threads threads(4);
  RelaxOptions options;
  options.seed_count = 40;
  const std::uint64_t expected = relax(mesh, options, threads).fingerprint;
  options.progress = [](const Progress&) -> bool { throw std::runtime_error("from the callback"); };
  EXPECT_THROW(relax(mesh, options, threads), std::runtime_error);
  options.progress = {};
  EXPECT_EQ(relax(mesh, options, threads).fingerprint, expected);
}

}  // namespace
}  // namespace geolloyd

// What an interrupt leaves to do, by counts: of questions, sweeps and ranges. No clock is asked.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/heeding_executor.h"
#include "core/base/loops.h"
#include "core/library/reference_runtime.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "core/surface/result/remesh.h"
#include "geolloyd/threads.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/walked_topology.h"

namespace geolloyd {
namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

class CountingEngine final : public SurfaceEngine {
 public:
  CountingEngine(std::unique_ptr<SurfaceEngine> engine, std::size_t& sweeps)
      : engine_(std::move(engine)), sweeps_(sweeps) {}
  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    engine_->assign(std::move(labels), is_fixed);
  }
  const Cells& evaluate(std::span<const Vec3> sites) override {
    ++sweeps_;
    return engine_->evaluate(sites);
  }
  [[nodiscard]] const std::vector<RegionId>& labels() const override { return engine_->labels(); }
  [[nodiscard]] const Cells& cells() const override { return engine_->cells(); }

 private:
  std::unique_ptr<SurfaceEngine> engine_;
  std::size_t& sweeps_;
};

class CountingRuntime final : public Runtime {
 public:
  explicit CountingRuntime(Runtime& runtime) : runtime_(runtime) {}
  Executor& executor() override { return runtime_.executor(); }
  std::unique_ptr<Engine> make_engine(const Graph& graph) override {
    return runtime_.make_engine(graph);
  }
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph& graph) override {
    return runtime_.make_growing_search(graph);
  }
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override {
    return std::make_unique<CountingEngine>(runtime_.make_surface_engine(mesh), sweeps);
  }
  std::size_t sweeps = 0;

 private:
  Runtime& runtime_;
};

// A remesh whose n-th question is answered with "stop".
struct Stopped {
  Remesh remesh;
  std::size_t asked = 0;
  std::size_t sweeps_after = 0;  // the answer
};

Stopped stop_at(std::size_t n, const Mesh& mesh, RemeshOptions options, Runtime& runtime) {
  CountingRuntime counting(runtime);
  Stopped stopped;
  options.progress = [&](const RemeshProgress&) {
    counting.sweeps = 0;
    return ++stopped.asked < n;
  };
  stopped.remesh = make_remesh(mesh, find_edges(mesh), options, counting);
  stopped.sweeps_after = counting.sweeps;
  return stopped;
}

RemeshOptions with_vertices(std::size_t count) {
  RemeshOptions options;
  options.vertex_count = count;
  return options;
}

TEST(HeedingExecutor, EndsALoopSoonAfterItIsTold) {
  std::size_t asked = 0;
  HeedingExecutor heeding(sequential(), [&] {
    if (++asked == 3) throw GivenUp();
  });
  std::size_t visited = 0;
  EXPECT_THROW(parallel_for(heeding, 1000, 1, [&](std::size_t) { ++visited; }), GivenUp);
  EXPECT_LE(visited, 3 * 16U);
}

TEST(HeedingExecutor, HeedsWhatItsThreadsHeedAndLeavesThemUsable) {
  Scheduler three(3);
  std::atomic<bool> is_told = false;
  HeedingExecutor heeding(three, [&] {
    if (is_told) throw GivenUp();
  });
  is_told = true;
  EXPECT_THROW(
      {
        for (int i = 0; i < 1'000'000; ++i) parallel_for(heeding, 1000, 1, [](std::size_t) {});
      },
      GivenUp);
  is_told = false;
  std::atomic<std::size_t> visited = 0;
  parallel_for(heeding, 1000, 1, [&](std::size_t) { ++visited; });
  EXPECT_EQ(visited, 1000U);
  three.set_watch([] { throw std::runtime_error("of the threads"); });
  EXPECT_THROW(parallel_for(heeding, 1, 1, [](std::size_t) {}), std::runtime_error);
}

// However early it comes, or late.
TEST(InterruptedRemesh, IsAManifoldAfterFewSweeps) {
  constexpr std::size_t most_sweeps = 6;
  const Mesh mesh = creature(10'000, 1);
  const std::size_t all = stop_at(never, mesh, with_vertices(400), all_threads()).asked;
  ASSERT_GT(all, 50U);
  for (std::size_t n = 1; n < all; n += 1 + all / 12) {
    const Stopped stopped = stop_at(n, mesh, with_vertices(400), all_threads());
    EXPECT_TRUE(stopped.remesh.interrupted);
    EXPECT_EQ(stopped.asked, n);
    EXPECT_LE(stopped.sweeps_after, most_sweeps) << n << " of " << all;
    EXPECT_TRUE(stopped.remesh.has_input_topology()) << n;
    EXPECT_EQ(walk_topology(stopped.remesh.mesh).flaw, "");
    EXPECT_LE(stopped.remesh.mesh.vertex_count(), 450U);
  }
}

// As long as sites move, and in the first fit, no engine and no number of threads matters.
TEST(InterruptedRemesh, IsTheSameWithEveryRuntime) {
  const Mesh mesh = creature(5'000, 1);
  Threads one(1);
  Threads three(3);
  for (const std::size_t n : {1U, 20U, 60U, 150U}) {
    const Remesh expected = stop_at(n, mesh, with_vertices(200), reference_runtime()).remesh;
    ASSERT_TRUE(expected.interrupted);
    for (Runtime* runtime : std::array<Runtime*, 2>{&one, &three}) {
      EXPECT_EQ(stop_at(n, mesh, with_vertices(200), *runtime).remesh.fingerprint,
                expected.fingerprint);
    }
  }
}

// Whenever glides are given up, the result is that of the fit before them.
TEST(InterruptedRemesh, HasTheFirstFitWhereGlidesAreGivenUp) {
  const Mesh mesh = creature(10'000, 1);
  Threads one(1);
  const Stopped whole = stop_at(never, mesh, with_vertices(400), one);
  ASSERT_GT(whole.remesh.glides, 0U);
  std::set<std::uint64_t> found;
  for (std::size_t n = whole.asked - 40; n < whole.asked; n += 8) {
    const Remesh remesh = stop_at(n, mesh, with_vertices(400), one).remesh;
    EXPECT_EQ(remesh.glides, 0U);
    EXPECT_GT(remesh.vertices_fitted, 100U);
    EXPECT_LT(remesh.distance_after_fit, remesh.distance_before_fit);
    found.insert(remesh.fingerprint);
  }
  EXPECT_EQ(found.size(), 1U);
}

TEST(InterruptedRemesh, LeavesTheQuickRemeshAtOnce) {
  const Mesh mesh = creature(5'000, 1);
  RemeshOptions options = with_vertices(200);
  options.sizing.equal_error = true;
  bool found_sizes = false;
  std::size_t asked = 0;
  options.progress = [&](const RemeshProgress& progress) {
    found_sizes = progress.finds_sizes;
    return ++asked < 10;
  };
  const Remesh remesh = make_remesh(mesh, find_edges(mesh), options, all_threads());
  EXPECT_FALSE(found_sizes);  // the last one asked is the remesh, which ends with its first level
  EXPECT_TRUE(remesh.interrupted);
  EXPECT_TRUE(remesh.has_input_topology());
}

}  // namespace
}  // namespace geolloyd

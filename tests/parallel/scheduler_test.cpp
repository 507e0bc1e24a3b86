#include "parallel/threads/scheduler.h"

#include <gtest/gtest.h>

#include <new>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

struct Team {
  std::size_t threads;
  Backend backend;

  friend std::ostream& operator<<(std::ostream& out, const Team& team) {
    return out << team.threads << (team.backend == Backend::tbb ? " of TBB" : " of OpenMP");
  }
};

class SchedulerTest : public testing::TestWithParam<Team> {
 protected:
  Scheduler scheduler_{GetParam().threads, GetParam().backend};
};

TEST_P(SchedulerTest, CallsEachWorkerOnce) {
  for (int turn = 0; turn < 50; ++turn) {
    std::vector<int> calls(scheduler_.threads(), 0);
    scheduler_.run(scheduler_.threads(), [&](std::size_t worker) { ++calls[worker]; });
    EXPECT_EQ(calls, std::vector<int>(scheduler_.threads(), 1));
  }
}

TEST_P(SchedulerTest, WorksApartHaveLoopsOfTheirOwn) {
  for (int turn = 0; turn < 20; ++turn) {
    std::vector<std::uint64_t> sums(scheduler_.threads(), 0);
    scheduler_.run_apart(scheduler_.threads(), [&](std::size_t worker) {
      Scheduler own(GetParam().threads, GetParam().backend);
      for (int loop = 0; loop < 5; ++loop) {
        sums[worker] += parallel_reduce<std::uint64_t>(
            own, 1000, 10, [](std::size_t begin, std::size_t end) { return end - begin; });
      }
    });
    EXPECT_EQ(sums, std::vector<std::uint64_t>(scheduler_.threads(), 5000));
  }
}

TEST_P(SchedulerTest, AnExceptionOfAWorkApartReachesTheCaller) {
  EXPECT_THROW(scheduler_.run_apart(scheduler_.threads(),
                                    [](std::size_t worker) {
                                      if (worker == 0) throw std::runtime_error("expected");
                                    }),
               std::runtime_error);
}

TEST_P(SchedulerTest, RangesCoverEverythingOnce) {
  for (const std::size_t count : {0U, 1U, 7U, 64U, 1000U}) {
    std::vector<int> visits(count, 0);
    parallel_for_ranges(scheduler_, count, 7,
                        [&](std::size_t begin, std::size_t end, std::size_t worker) {
                          ASSERT_LT(worker, scheduler_.threads());
                          ASSERT_LE(end - begin, 7U);
                          for (std::size_t i = begin; i < end; ++i) ++visits[i];
                        });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

TEST_P(SchedulerTest, SumsAndScansAreTheSequentialOnes) {
  std::vector<std::uint64_t> values(100'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i * i % 1009;
  std::vector<std::uint64_t> expected(values.size());
  std::exclusive_scan(values.begin(), values.end(), expected.begin(), std::uint64_t{0});
  const auto total = std::accumulate(values.begin(), values.end(), std::uint64_t{0});
  EXPECT_EQ(parallel_reduce<std::uint64_t>(
                scheduler_, values.size(), 100,
                [&](std::size_t begin, std::size_t end) {
                  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                         values.begin() + static_cast<std::ptrdiff_t>(end),
                                         std::uint64_t{0});
                }),
            total);
  EXPECT_EQ(exclusive_scan<std::uint64_t>(scheduler_, values), total);
  EXPECT_EQ(values, expected);
}

TEST_P(SchedulerTest, AnErrorInATaskReachesTheCallerAndTheNextWorkGoesOn) {
  for (int turn = 0; turn < 20; ++turn) {
    EXPECT_THROW(parallel_for(scheduler_, 1000, 1,
                              [](std::size_t i) {
                                if (i == 500) throw std::runtime_error("in a task");
                              }),
                 std::runtime_error);
    EXPECT_EQ(
        parallel_reduce<std::size_t>(
            scheduler_, 1000, 10, [](std::size_t begin, std::size_t end) { return end - begin; }),
        1000U);
  }
}

TEST_P(SchedulerTest, WhatAWorkerThrowsReachesTheCallerOnceAllHaveEnded) {
  for (int turn = 0; turn < 20; ++turn) {
    std::vector<int> calls(scheduler_.threads(), 0);
    EXPECT_THROW(scheduler_.run(scheduler_.threads(),
                                [&](std::size_t worker) {
                                  ++calls[worker];
                                  throw std::bad_alloc();
                                }),
                 std::bad_alloc);
    EXPECT_EQ(calls, std::vector<int>(scheduler_.threads(), 1));
  }
}

INSTANTIATE_TEST_SUITE_P(Teams, SchedulerTest,
                         testing::Values(Team{1, Backend::tbb}, Team{2, Backend::tbb},
                                         Team{8, Backend::tbb}, Team{1, Backend::openmp},
                                         Team{2, Backend::openmp}, Team{8, Backend::openmp}));

}  // namespace
}  // namespace geolloyd

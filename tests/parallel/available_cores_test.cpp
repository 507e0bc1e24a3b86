#include "parallel/threads/available_cores.h"

#include <gtest/gtest.h>

#include <sched.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "parallel/threads/scheduler.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

class GrantedCores : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) const {
    const std::filesystem::path path = folder_.path() / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  [[nodiscard]] std::size_t found() const { return granted_cores(folder_.path()); }

  TemporaryFolder folder_;
};

TEST_F(GrantedCores, AreUnlimitedWhereNothingIsKnown) {
  EXPECT_EQ(found(), unlimited);
  write("proc/self/cgroup", "0::/box\n");
  EXPECT_EQ(found(), unlimited);
  write("sys/fs/cgroup/box/cpu.max", "nonsense\n");
  EXPECT_EQ(found(), unlimited);
}

TEST_F(GrantedCores, AreTheLeastOfNestedGroupsInWholeCores) {
  write("proc/self/cgroup", "0::/jobs/one\n");
  write("sys/fs/cgroup/jobs/one/cpu.max", "max 100000\n");
  EXPECT_EQ(found(), unlimited);
  write("sys/fs/cgroup/jobs/cpu.max", "350000 100000\n");
  EXPECT_EQ(found(), 3U);
  write("sys/fs/cgroup/jobs/one/cpu.max", "100000 50000\n");
  EXPECT_EQ(found(), 2U);
  write("sys/fs/cgroup/jobs/one/cpu.max", "20000 100000\n");
  EXPECT_EQ(found(), 1U);
}

// A container sees its own group as the root, whatever its path is called outside.
TEST_F(GrantedCores, AreThoseOfTheRootWhereTheGroupIsNotToBeSeen) {
  write("proc/self/cgroup", "0::/outside/name\n");
  write("sys/fs/cgroup/cpu.max", "800000 100000\n");
  EXPECT_EQ(found(), 8U);
}

TEST_F(GrantedCores, AreKnownToTheFirstVersionOfControlGroups) {
  write("proc/self/cgroup", "9:name=systemd:/\n5:cpuset:/set\n4:cpu,cpuacct:/box\n0::/\n");
  write("sys/fs/cgroup/cpuset/set/cpu.cfs_quota_us", "100000\n");
  write("sys/fs/cgroup/cpu/box/cpu.cfs_quota_us", "-1\n");
  write("sys/fs/cgroup/cpu/box/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(found(), unlimited);
  write("sys/fs/cgroup/cpu/box/cpu.cfs_quota_us", "400000\n");
  EXPECT_EQ(found(), 4U);
}

TEST(AvailableCores, AreThoseThatTheProcessMayRunOn) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  EXPECT_LE(available_cores(), static_cast<std::size_t>(CPU_COUNT(&all)));
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(available_cores(), 1U);
  EXPECT_EQ(Scheduler().threads(), 1U);
  sched_setaffinity(0, sizeof all, &all);
}

}  // namespace
}  // namespace geolloyd

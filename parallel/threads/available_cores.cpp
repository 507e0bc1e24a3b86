#include "parallel/threads/available_cores.h"

#include <sched.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <thread>

#include "parallel/threads/control_groups.h"

namespace geolloyd {
namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

// The core time that a group may use in a period of time. A part of a core is no thread's worth:
// threads that wait for each other would all wait for the one that is halted.
std::size_t whole_cores(std::int64_t quota, std::int64_t period) {
  if (quota <= 0 || period <= 0) return unlimited;
  return static_cast<std::size_t>(std::max<std::int64_t>(1, quota / period));
}

std::size_t cores_of(const ControlGroup& group) {
  std::int64_t quota = -1;
  std::int64_t period = -1;
  if (group.version == 2) {  // "150000 100000", or "max 100000", of which no number can be read
    std::ifstream(group.folder / "cpu.max") >> quota >> period;
  } else {
    std::ifstream(group.folder / "cpu.cfs_quota_us") >> quota;  // -1: no limit
    std::ifstream(group.folder / "cpu.cfs_period_us") >> period;
  }
  return whole_cores(quota, period);
}

// More cores than a cpu_set_t holds cannot be asked for so.
std::size_t usable_cores() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) {
    return static_cast<std::size_t>(CPU_COUNT(&cores));
  }
  return std::max(std::thread::hardware_concurrency(), 1U);
}

}  // namespace

std::size_t available_cores() {
  return std::min(usable_cores(), granted_cores());
}

std::size_t granted_cores(const std::filesystem::path& root) {
  std::size_t least = unlimited;
  for (const ControlGroup& group : control_groups("cpu", root)) {
    least = std::min(least, cores_of(group));
  }
  return least;
}

}  // namespace geolloyd

#include "tools/system/available_memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string>

#include "parallel/threads/control_groups.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

// The number behind a word at the beginning of a line; files of the kernel are made of these.
std::optional<std::uint64_t> number_in(const std::filesystem::path& file, const std::string& word) {
  std::ifstream in(file);
  std::string first;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::uint64_t number = 0;
    if (fields >> first && first == word && fields >> number) return number;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> number_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  if (in >> number) return number;
  return std::nullopt;  // no such file, or "max"
}

// What the files of a control group are called.
struct GroupFiles {
  std::span<const char* const> limits;
  const char* usage;
  std::span<const char* const> reclaimable;  // in memory.stat: caches, which the system gives up
};
constexpr std::array limits_1 = {"memory.limit_in_bytes"};
constexpr std::array caches_1 = {"total_inactive_file", "total_active_file"};
constexpr std::array limits_2 = {"memory.max", "memory.high"};
constexpr std::array caches_2 = {"inactive_file", "active_file", "slab_reclaimable"};
constexpr GroupFiles version_1 = {limits_1, "memory.usage_in_bytes", caches_1};
constexpr GroupFiles version_2 = {limits_2, "memory.current", caches_2};

std::uint64_t held_by_group(const std::filesystem::path& folder, const GroupFiles& files) {
  std::uint64_t cached = 0;
  for (const char* word : files.reclaimable) {
    cached += number_in(folder / "memory.stat", word).value_or(0);
  }
  const std::uint64_t usage = number_in(folder / files.usage).value_or(0);
  return usage - std::min(usage, cached);
}

std::uint64_t left_in_groups(const std::filesystem::path& root) {
  std::uint64_t least = unlimited;
  for (const ControlGroup& group : control_groups("memory", root)) {
    const GroupFiles& files = group.version == 1 ? version_1 : version_2;
    for (const char* limit_file : files.limits) {
      const auto most = number_in(group.folder / limit_file);
      if (most)
        least = std::min(least, *most - std::min(*most, held_by_group(group.folder, files)));
    }
  }
  return least;
}

// Of what the shell allows this process (ulimit -v, ulimit -d): now, or if it asks for all.
std::uint64_t left_of(decltype(RLIMIT_DATA) resource, const char* used,
                      rlim_t rlimit::*which = &rlimit::rlim_cur) {
  rlimit allowed{};
  if (getrlimit(resource, &allowed) != 0 || allowed.*which == RLIM_INFINITY) return unlimited;
  const std::uint64_t held = number_in("/proc/self/status", used).value_or(0) * 1024;
  return allowed.*which - std::min<std::uint64_t>(allowed.*which, held);
}

}  // namespace

std::uint64_t available_memory(const std::filesystem::path& root) {
  const auto available = number_in(root / "proc/meminfo", "MemAvailable:");  // in KiB
  return std::min({available ? *available * 1024 : unlimited, left_in_groups(root),
                   left_of(RLIMIT_AS, "VmSize:"), left_of(RLIMIT_DATA, "VmData:")});
}

std::uint64_t data_held() {
  return number_in("/proc/self/status", "VmData:").value_or(0) * 1024;
}

std::uint64_t reservable_memory() {
  return std::min(left_of(RLIMIT_AS, "VmSize:"),
                  left_of(RLIMIT_DATA, "VmData:", &rlimit::rlim_max));
}

}  // namespace geolloyd

#include "tools/memory_limit.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>

#include "core/errors.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t large = 1'000'000'000;

std::uint64_t limit = unlimited;
std::uint64_t told = large;
std::uint64_t held_at_start = 0;
std::size_t threads = 0;
std::optional<rlim_t> data_at_start;

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

// The least of a group and those it is in. A container may see its own group as the root.
std::uint64_t left_in_groups(const std::filesystem::path& mount, std::filesystem::path group,
                             const GroupFiles& files) {
  std::uint64_t least = unlimited;
  for (group = group.relative_path();; group = group.parent_path()) {
    const std::filesystem::path folder = mount / group;
    for (const char* limit_file : files.limits) {
      const auto most = number_in(folder / limit_file);
      if (most) least = std::min(least, *most - std::min(*most, held_by_group(folder, files)));
    }
    if (group.empty()) return least;
  }
}

// Lines like "4:memory:/path" and, of version 2, "0::/path".
std::uint64_t left_in_groups(const std::filesystem::path& root) {
  std::ifstream in(root / "proc/self/cgroup");
  std::uint64_t least = unlimited;
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::filesystem::path group = line.substr(second + 1);
    const std::filesystem::path mounts = root / "sys/fs/cgroup";
    if (controllers == ",,") least = std::min(least, left_in_groups(mounts, group, version_2));
    if (controllers.find(",memory,") != std::string::npos) {
      least = std::min(least, left_in_groups(mounts / "memory", group, version_1));
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

// What OpenMP is told, like "16M": KiB without a unit.
std::uint64_t openmp_stack() {
  const char* const text = std::getenv("OMP_STACKSIZE");
  std::istringstream in(text != nullptr ? text : "");
  std::uint64_t number = 0;
  if (!(in >> number)) return 0;
  char unit = 'K';
  in >> unit;
  switch (std::toupper(static_cast<unsigned char>(unit))) {
    case 'B':
      return number;
    case 'M':
      return number << 20;
    case 'G':
      return number << 30;
    default:
      return number << 10;
  }
}

// A thread reserves a stack, and uses little of it. TBB's have 4 MiB, whatever the shell says.
std::uint64_t stack_bytes() {
  constexpr std::uint64_t usual = std::uint64_t{8} << 20;
  rlimit stack{};
  const bool known = getrlimit(RLIMIT_STACK, &stack) == 0 && stack.rlim_cur != RLIM_INFINITY;
  constexpr std::uint64_t most = std::uint64_t{1} << 40;  // of no use, but sums stay sums
  return std::min(most, std::max({usual, openmp_stack(), known ? stack.rlim_cur : rlim_t{0}}));
}

// What is reserved, and so counted by the system, but not touched, and so not estimated: stacks,
// and the blocks of the allocators, Embree's above all (70 MB beside two threads, measured).
std::uint64_t room_for_reserves() {
  constexpr std::uint64_t blocks = 96'000'000;
  constexpr std::uint64_t blocks_of_thread = 4'000'000;
  // Embree and the other backend may start as many threads as there are cores.
  const std::uint64_t most = threads + 2 * std::uint64_t{std::thread::hardware_concurrency()};
  return blocks + (stack_bytes() + blocks_of_thread) * most;
}

// Where the system will not have it, there is no such net.
void limit_data() {
  rlimit data{};
  if (getrlimit(RLIMIT_DATA, &data) != 0) return;
  if (!data_at_start) data_at_start = data.rlim_cur;
  const std::uint64_t room = held_at_start + room_for_reserves();
  data.rlim_cur =
      std::min<rlim_t>(limit < unlimited - room ? limit + room : RLIM_INFINITY, data.rlim_max);
  setrlimit(RLIMIT_DATA, &data);
}

// Makes "8G" a number of bytes. CLI11 by itself reads -1 as a huge one.
std::string read_size(std::string& text) {
  constexpr std::string_view prefixes = "KMGT";
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  std::string unit(stop, end);
  for (char& c : unit) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const std::size_t power = unit.empty() || unit == "B" ? 0 : prefixes.find(unit[0]) + 1;
  const std::string rest = power == 0 ? "" : unit.substr(1);
  bool is_size = error == std::errc() && number > 0 && (unit.empty() || unit == "B" || power > 0) &&
                 (rest.empty() || rest == "B" || rest == "IB");
  for (std::size_t i = 0; is_size && i < power; ++i) {
    is_size = !__builtin_mul_overflow(number, rest == "IB" ? 1024U : 1000U, &number);
  }
  if (!is_size) return "'" + text + "': give a whole number of bytes above 0, or like 800M or 8G";
  text = std::to_string(number);
  return "";
}

}  // namespace

std::uint64_t available_memory(const std::filesystem::path& root) {
  const auto available = number_in(root / "proc/meminfo", "MemAvailable:");  // in KiB
  return std::min({available ? *available * 1024 : unlimited, left_in_groups(root),
                   left_of(RLIMIT_AS, "VmSize:"), left_of(RLIMIT_DATA, "VmData:")});
}

void limit_memory(std::uint64_t bytes) {
  limit = bytes;
  held_at_start = number_in("/proc/self/status", "VmData:").value_or(0) * 1024;
  limit_data();
}

void make_room_for_threads(std::size_t count) {
  if (count == 0) count = std::max(std::thread::hardware_concurrency(), 1U);
  const std::uint64_t stacks = stack_bytes() * (count - 1);
  const std::uint64_t left =
      std::min(left_of(RLIMIT_AS, "VmSize:"), left_of(RLIMIT_DATA, "VmData:", &rlimit::rlim_max));
  if (stacks > left) {
    throw InvalidInput(fmt::format(
        "--threads: the stacks of {} threads reserve {}, but the shell allows only {}: use fewer "
        "threads, or ulimit -v or -d",
        count, memory_text(stacks), memory_text(left)));
  }
  threads = std::max(threads, count);
  limit_data();
}

LiftedMemoryLimit::LiftedMemoryLimit() {
  rlimit data{};
  if (!data_at_start || getrlimit(RLIMIT_DATA, &data) != 0) return;
  data.rlim_cur = *data_at_start;
  setrlimit(RLIMIT_DATA, &data);
}

LiftedMemoryLimit::~LiftedMemoryLimit() {
  limit_data();
}

void add_memory_option(CLI::App& command) {
  command
      .add_option_function<std::uint64_t>(
          "--memory-limit", limit_memory,
          "Refuse what needs more memory than this, 8G or 800M (default:\n"
          "what the machine has left)")
      ->transform(CLI::Validator(read_size, ""))
      ->type_name("SIZE");
}

void require_memory(const std::string& what, std::uint64_t bytes) {
  if (bytes > limit) {
    throw InvalidInput(fmt::format(
        "{}: needs about {} of memory, but only {} are allowed: use a smaller mesh or picture, a "
        "graph with fewer arcs, or --memory-limit",
        what, memory_text(bytes), memory_text(limit)));
  }
  if (bytes <= told) return;
  told = bytes;
  const char* over_progress = isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "";
  fmt::print(stderr, "{}{}: takes up to {} of memory\n", over_progress, what, memory_text(bytes));
}

std::string out_of_memory_message() {
  return fmt::format(
      "out of memory, of which {} are allowed: use a smaller mesh or picture, a graph with fewer "
      "arcs, or --memory-limit",
      memory_text(limit));
}

std::string memory_text(std::uint64_t bytes) {
  if (bytes < large) return fmt::format("{:.0f} MB", static_cast<double>(bytes) * 1e-6);
  return fmt::format("{:.1f} GB", static_cast<double>(bytes) * 1e-9);
}

}  // namespace geolloyd

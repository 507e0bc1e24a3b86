#include "tools/system/memory_limit.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>
#include <thread>

#include "geolloyd/errors.h"
#include "parallel/threads/available_cores.h"
#include "tools/system/available_memory.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t gigabyte = 1'000'000'000;

std::uint64_t limit = no_limit;
std::uint64_t held_at_start = 0;
std::size_t threads = 0;
std::optional<rlim_t> data_at_start;

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
      std::min<rlim_t>(limit < no_limit - room ? limit + room : RLIM_INFINITY, data.rlim_max);
  setrlimit(RLIMIT_DATA, &data);
}

}  // namespace

// What is smaller stays on the heap, whose free end is kept as far: otherwise a run of a million
// triangles, which needs no thrift, gets and clears its pages again and again.
void return_freed_memory() {
  constexpr int large_array = 1 << 25;  // the C library takes no more
  mallopt(M_MMAP_THRESHOLD, large_array);
  mallopt(M_TRIM_THRESHOLD, large_array);
}

void limit_memory(std::uint64_t bytes) {
  limit = bytes;
  held_at_start = data_held();
  limit_data();
}

std::uint64_t allowed_memory() {
  return limit;
}

void make_room_for_threads(std::size_t count) {
  if (count == 0) count = available_cores();
  const std::uint64_t stacks = stack_bytes() * (count - 1);
  const std::uint64_t left = reservable_memory();
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

void require_memory(const std::string& what, std::uint64_t bytes) {
  if (bytes > limit) {
    throw InvalidInput(fmt::format(
        "{}: needs about {} of memory, but only {} are allowed: use a smaller mesh, remesh or "
        "picture, a graph with fewer arcs, or --memory-limit",
        what, memory_text(bytes), memory_text(limit)));
  }
}

std::string out_of_memory_message() {
  return fmt::format(
      "out of memory, of which {} are allowed: use a smaller mesh, remesh or picture, a graph with "
      "fewer arcs, or --memory-limit",
      memory_text(limit));
}

std::string memory_text(std::uint64_t bytes) {
  if (bytes < gigabyte) return fmt::format("{:.0f} MB", static_cast<double>(bytes) * 1e-6);
  return fmt::format("{:.1f} GB", static_cast<double>(bytes) * 1e-9);
}

}  // namespace geolloyd

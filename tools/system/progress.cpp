#include "tools/system/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "tools/system/memory_limit.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

constexpr double seconds_between_updates = 0.1;
constexpr std::uint64_t large_memory = 1'000'000'000;
constexpr std::size_t bar_width = 12;

// The share of seeds at rest: it does not rise steadily, but it ends full.
std::string bar(std::size_t moving, std::size_t seeds) {
  const std::size_t full = bar_width * (seeds - moving) / seeds;
  return std::string(full, '#') + std::string(bar_width - full, '.');
}

}  // namespace

ProgressLine::ProgressLine(const Console& console)
    : ProgressLine(console.is_silent(), isatty(STDERR_FILENO) != 0 && !console.is_silent()) {}

void ProgressLine::stage(const std::string& what) {
  part_.clear();
  print(what + " ...");
}

void ProgressLine::show(const Progress& progress, std::size_t seed_count) {
  if (!is_due()) return;
  print(fmt::format("{:<7} {:<4} [{}] {:>6} of {} moving  energy {:.5g}  {:.0f} s",
                    name_of(phase_names, progress.phase), progress.step,
                    bar(progress.seeds_moving, seed_count), progress.seeds_moving, seed_count,
                    progress.energy, watch_.seconds()));
}

void ProgressLine::show(const RemeshProgress& progress) {
  if (!is_due()) return;
  print(fmt::format(
      "sites {:>6} of {}  iteration {:<3} energy {:.4f} of a hexagonal tiling  {:.0f} s",
      progress.sites, progress.wanted_sites, progress.iteration, progress.energy_ratio,
      watch_.seconds()));
}

// Time for the next update, which will then be shown.
bool ProgressLine::is_due() {
  if (!on_terminal_ || watch_.seconds() - last_shown_ < seconds_between_updates) return false;
  last_shown_ = watch_.seconds();
  return true;
}

void ProgressLine::clear() {
  if (printed_) std::fputs("\r\033[K", stderr);
  printed_ = false;
}

void ProgressLine::announce_memory(const std::string& what, std::uint64_t bytes) {
  require_memory(what, bytes);
  if (bytes <= large_memory || announced_ || is_silent_) return;
  announced_ = true;
  clear();
  fmt::print(stderr, "{}: takes up to {} of memory\n", what, memory_text(bytes));
}

void ProgressLine::print(const std::string& text) {
  if (!on_terminal_) return;
  // A line that wraps could not be taken back.
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::string line = (part_ + text).substr(0, known ? size.ws_col - 1U : 79U);
  std::fputs(("\r\033[K" + line).c_str(), stderr);
  std::fflush(stderr);
  printed_ = true;
}

}  // namespace geolloyd

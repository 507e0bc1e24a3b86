#include "tools/system/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

namespace geolloyd {
namespace {

constexpr int status_interrupted = 130;

// Any thread may be the one to handle a signal.
std::atomic<bool> is_caught = false;
std::atomic<bool> over_progress = false;  // the line of the progress goes first
std::atomic<bool> is_ending = false;
std::atomic<bool> signal_came = false;
std::atomic<std::int64_t> first_came_at = 0;  // milliseconds
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

// Only what a signal handler may call. A second thread that gets here returns: the first one ends
// the program.
void end_at_once() {
  constexpr std::string_view line = "\r\033[Kgeolloyd: interrupted\n";
  constexpr std::size_t to_clear = 4;
  if (is_ending.exchange(true)) return;
  const std::string_view text = line.substr(over_progress ? 0 : to_clear);
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(status_interrupted);
}

extern "C" void handle_signal(int number) {
  constexpr std::int64_t same_request = 500;
  if (!is_caught) {
    end_at_once();
    return;
  }
  if (!signal_came) {
    first_came_at = milliseconds_now();
    signal_came = true;
  } else if (milliseconds_now() - first_came_at > same_request) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

}  // namespace

void end_on_interrupts() {
  over_progress = ::isatty(STDERR_FILENO) != 0;
  constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
  struct sigaction action {};
  action.sa_handler = handle_signal;
  action.sa_flags = SA_RESTART;
  // Where two signals come at once to two threads, both may count as the first; no harm is done.
  for (const int number : signals) sigaddset(&action.sa_mask, number);
  for (const int number : signals) {
    struct sigaction before {};
    const bool known = sigaction(number, nullptr, &before) == 0;
    if (number == SIGHUP && known && before.sa_handler == SIG_IGN) continue;
    sigaction(number, &action, nullptr);
  }
}

void catch_interrupts() {
  is_caught = true;
}

bool interrupted() {
  return signal_came;
}

void give_up_if_interrupted() {
  if (interrupted()) throw InterruptedExit{};
}

}  // namespace geolloyd

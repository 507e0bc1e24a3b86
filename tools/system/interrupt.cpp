#include "tools/system/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace geolloyd {
namespace {

// Any thread may be the one to handle a signal.
std::atomic<bool> signal_came = false;
std::atomic<std::int64_t> first_came_at = 0;  // milliseconds
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

extern "C" void note_signal(int number) {
  constexpr std::int64_t same_request = 500;
  if (!signal_came) {
    first_came_at = milliseconds_now();
    signal_came = true;
  } else if (milliseconds_now() - first_came_at > same_request) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;
  // Where two signals come at once to two threads, both may count as the first; no harm is done.
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return signal_came;
}

}  // namespace geolloyd

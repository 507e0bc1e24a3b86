#include "tools/interrupt.h"

#include <csignal>
#include <cstdint>
#include <ctime>

namespace geolloyd {
namespace {

volatile std::sig_atomic_t signal_came = 0;
volatile std::int64_t first_came_at = 0;  // milliseconds; read and written by the handler alone

std::int64_t milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

extern "C" void note_signal(int number) {
  constexpr std::int64_t same_request = 500;
  if (signal_came == 0) {
    signal_came = 1;
    first_came_at = milliseconds_now();
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
  // One handler at a time, so that two different signals cannot both be the first.
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return signal_came != 0;
}

}  // namespace geolloyd

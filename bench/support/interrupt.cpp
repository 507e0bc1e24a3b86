#include "bench/support/interrupt.h"

#include <csignal>

namespace geolloyd {
namespace {

volatile std::sig_atomic_t is_interrupted = 0;

extern "C" void note_interrupt(int signal) {
  is_interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

void leave_if_interrupted() {
  if (is_interrupted != 0) throw Interrupted{};
}

bool was_interrupted() {
  return is_interrupted != 0;
}

}  // namespace geolloyd

#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <utility>

#include "core/base/executor.h"

namespace geolloyd {

/// True twenty times a second at most: to ask Python takes its lock.
class Pulse {
 public:
  bool is_due() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::milliseconds(50);
    return true;
  }

 private:
  std::chrono::steady_clock::time_point next_;
};

/// What long work asks Python while it holds no lock of the interpreter: whether Ctrl-C was
/// pressed, and what the user's progress callback says.
class Watch {
 public:
  /// `progress` is a callable, or None.
  explicit Watch(pybind11::object progress) : progress_(std::move(progress)) {}

  /// False where the callback returned False. Throws what it raised, or KeyboardInterrupt.
  template <class... Figures>
  bool keep_going(Figures... figures) {
    if (!pulse_.is_due()) return true;
    const pybind11::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    if (progress_.is_none()) return true;
    const pybind11::object answer = progress_(figures...);
    return !answer.is(pybind11::bool_(false));
  }

 private:
  pybind11::object progress_;
  Pulse pulse_;
};

/// While it lives, Ctrl-C ends the loops of an executor by KeyboardInterrupt. Needs no lock.
class HeedInterrupts {
 public:
  explicit HeedInterrupts(Executor& executor) : executor_(executor) {
    executor_.set_watch([this] {
      if (!pulse_.is_due()) return;
      const pybind11::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    });
  }
  HeedInterrupts(const HeedInterrupts&) = delete;
  HeedInterrupts& operator=(const HeedInterrupts&) = delete;
  ~HeedInterrupts() { executor_.set_watch({}); }

 private:
  Executor& executor_;
  Pulse pulse_;
};

}  // namespace geolloyd

#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <utility>

namespace geolloyd {

/// What long work asks Python while it holds no lock of the interpreter: whether Ctrl-C was
/// pressed, and what the user's progress callback says. Twenty times a second at most.
class Watch {
 public:
  /// `progress` is a callable, or None.
  explicit Watch(pybind11::object progress) : progress_(std::move(progress)) {}

  /// False where the callback returned False. Throws what it raised, or KeyboardInterrupt.
  template <class... Figures>
  bool keep_going(Figures... figures) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return true;
    next_ = now + std::chrono::milliseconds(50);
    const pybind11::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    if (progress_.is_none()) return true;
    const pybind11::object answer = progress_(figures...);
    return !answer.is(pybind11::bool_(false));
  }

 private:
  pybind11::object progress_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace geolloyd

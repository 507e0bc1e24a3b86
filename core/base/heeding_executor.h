#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "core/base/executor.h"

namespace geolloyd {

/// Thrown by a watch where what the work makes is not wanted any more.
struct GivenUp {};

/// The threads of another executor, for work that heeds one watch more. That one is called by the
/// thread that made this, and seldom enough to ask users.
class HeedingExecutor final : public Executor {
 public:
  /// `threads` must live on.
  HeedingExecutor(Executor& threads, std::function<void()> watch)
      : Executor(threads.threads()), inner_(threads), watch_(std::move(watch)) {
    set_watch([this] { heed_both(); });
  }

  void run(std::size_t workers, const std::function<void(std::size_t worker)>& work) override {
    inner_.run(workers, work);
  }

 private:
  void heed_both() {
    constexpr std::size_t seldom = 16;  // ranges of a loop take a millisecond at most
    inner_.heed();
    if (mark_of_thread() == caller_ && ++heeded_ % seldom == 0) watch_();
  }

  static const void* mark_of_thread() {
    thread_local const char mark = 0;
    return &mark;
  }

  Executor& inner_;
  std::function<void()> watch_;
  const void* caller_ = mark_of_thread();
  std::size_t heeded_ = 0;
};

}  // namespace geolloyd

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <thread>

#include "core/base/executor.h"

namespace geolloyd {

/// Loops one after the other, each over some microseconds of work, between which the threads of one
/// call of Executor::run stay awake: waking them costs as much as a short loop. The first worker to
/// come leads. It never waits for one that has not come, so that any executor will do.
class Rounds {
 public:
  Rounds(Executor& executor, std::size_t grain) : executor_(executor), grain_(grain) {}

  /// As often as next() is not 0: calls body(begin, end, worker) for ranges of at most `grain` that
  /// make up [0, next()). No body is at work while next() is. An exception ends the rounds and
  /// reaches the caller.
  template <class Next, class Body>
  void run(Next&& next, Body&& body) {
    is_led_ = false;
    is_over_ = false;
    for (count_ = next(); count_ <= alone(); count_ = next()) {
      if (count_ == 0) return;
      begin_ = 0;
      take_ranges(body, 0);
    }
    executor_.run(executor_.threads(), [&](std::size_t worker) {
      if (!is_led_.exchange(true)) {
        lead(next, body, worker);
      } else {
        help(body, worker);
      }
    });
  }

 private:
  // Up to so many items nobody is woken for.
  [[nodiscard]] std::size_t alone() const {
    return executor_.threads() == 1 ? std::numeric_limits<std::size_t>::max() : grain_;
  }

  // Sets a flag at the end of its life, however that comes about.
  struct EndOf {
    explicit EndOf(std::atomic<bool>& over) : over_(over) {}
    EndOf(const EndOf&) = delete;
    EndOf& operator=(const EndOf&) = delete;
    ~EndOf() { over_ = true; }
    std::atomic<bool>& over_;
  };
  struct Stay {
    explicit Stay(std::atomic<std::size_t>& helpers) : helpers_(helpers) { ++helpers_; }
    Stay(const Stay&) = delete;
    Stay& operator=(const Stay&) = delete;
    ~Stay() { --helpers_; }
    std::atomic<std::size_t>& helpers_;
  };

  template <class Next, class Body>
  void lead(Next&& next, Body&& body, std::size_t worker) {
    const EndOf rounds(is_over_);
    for (; count_ != 0 && !is_over_; count_ = next()) {
      begin_ = 0;
      if (count_ > grain_) is_open_ = true;
      take_ranges(body, worker);
      is_open_ = false;
      wait_while([&] { return helpers_ != 0; });
    }
  }

  // Whoever has come and then finds the round open is waited for.
  template <class Body>
  void help(Body&& body, std::size_t worker) {
    while (true) {
      wait_while([&] { return !is_open_ && !is_over_; });
      if (is_over_) return;
      const Stay stay(helpers_);
      try {
        if (is_open_) take_ranges(body, worker);
      } catch (...) {
        is_over_ = true;
        throw;
      }
    }
  }

  template <class Body>
  void take_ranges(Body&& body, std::size_t worker) {
    while (true) {
      const std::size_t begin = begin_.fetch_add(grain_, std::memory_order_relaxed);
      if (begin >= count_) return;
      body(begin, std::min(begin + grain_, count_), worker);
    }
  }

  template <class Condition>
  static void wait_while(Condition&& condition) {
    constexpr int some = 256;
    for (int tries = 0; condition(); ++tries) {
      if (tries > some) std::this_thread::yield();
    }
  }

  Executor& executor_;
  std::size_t grain_;
  std::size_t count_ = 0;  // of the round
  std::atomic<std::size_t> begin_{0};
  std::atomic<std::size_t> helpers_{0};
  std::atomic<bool> is_led_{false};
  std::atomic<bool> is_open_{false};
  std::atomic<bool> is_over_{false};
};

}  // namespace geolloyd

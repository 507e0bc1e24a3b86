#pragma once

#include <chrono>

namespace geolloyd {

/// Wall seconds since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return Stopwatch().since(*this); }
  /// By how many seconds it was made later than `other`.
  [[nodiscard]] double since(const Stopwatch& other) const {
    return std::chrono::duration<double>(start_ - other.start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

#ifdef GEOLLOYD_UNTIMED  // to find out what timing costs (bench/README.md)
struct Timed {
  explicit Timed(double& /*total*/) {}
};
struct Laps {
  void begin(double /*weight*/) {}
  void end(double& /*total*/) {}
};
#else
/// Adds the time of its own life to `total`.
class Timed {
 public:
  explicit Timed(double& total) : total_(total) {}
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;
  ~Timed() { total_ += watch_.seconds(); }

 private:
  double& total_;
  Stopwatch watch_;
};

/// Divides time among short pieces of work in a row, with one look at the clock for each.
class Laps {
 public:
  /// What follows counts `weight` times; 0: not at all, and costs nothing.
  void begin(double weight) {
    weight_ = weight;
    if (weight_ != 0) watch_ = Stopwatch();
  }
  /// Adds to `total` what has passed since the last begin() or end().
  void end(double& total) {
    if (weight_ == 0) return;
    const Stopwatch now;
    total += weight_ * now.since(watch_);
    watch_ = now;
  }

 private:
  double weight_ = 0;
  Stopwatch watch_;
};
#endif

}  // namespace geolloyd

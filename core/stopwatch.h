#pragma once

#include <chrono>

namespace geolloyd {

/// Wall seconds since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

#ifdef GEOLLOYD_UNTIMED  // to find out what timing costs (bench/README.md)
struct Timed {
  explicit Timed(double& /*total*/) {}
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
#endif

}  // namespace geolloyd

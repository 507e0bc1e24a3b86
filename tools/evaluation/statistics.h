#pragma once

#include <algorithm>
#include <cstddef>

namespace geolloyd {

/// Smallest, mean and largest of some values.
class Statistics {
 public:
  void add(double value) {
    min_ = count_ == 0 ? value : std::min(min_, value);
    max_ = count_ == 0 ? value : std::max(max_, value);
    sum_ += value;
    ++count_;
  }
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double mean() const { return sum_ / static_cast<double>(count_); }
  [[nodiscard]] double max() const { return max_; }

 private:
  double min_ = 0;
  double max_ = 0;
  double sum_ = 0;
  std::size_t count_ = 0;
};

}  // namespace geolloyd

#include "core/surface/sizing/equal_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace geolloyd {
namespace {

constexpr double negligible = 1e-9;  // distance, of a length

class EqualError {
 public:
  EqualError(std::span<const MeasuredCell> cells, double count)
      : cells_(cells), count_(count), even_(std::sqrt(static_cast<double>(cells.size()) / count)) {
    bluntness_.reserve(cells.size());
    for (const auto& [length, distance] : cells) {
      const double half = length / 2;
      bluntness_.push_back(length *
                           std::max(0.0, half / std::max(distance, negligible * length) - 1));
    }
  }

  // Cells are the fewer, the larger the distance may be.
  std::vector<double> run() {
    constexpr int halvings = 50;
    double too_near = 1e-12;
    double far_enough = 4;
    for (int i = 0; i < halvings; ++i) {
      const double middle = std::sqrt(too_near * far_enough);
      (cells_at(middle) > count_ ? too_near : far_enough) = middle;
    }
    std::vector<double> lengths;
    lengths.reserve(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) lengths.push_back(length_at(c, far_enough));
    return lengths;
  }

 private:
  [[nodiscard]] double cells_at(double distance) const {
    double sum = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const double shorter = cells_[c].length / length_at(c, distance);
      sum += shorter * shorter;
    }
    return sum;
  }

  [[nodiscard]] double length_at(std::size_t c, double distance) const {
    constexpr double shortest = 0.25;
    constexpr double longest = 1.2;
    const double wanted = distance + std::sqrt(distance * (distance + 2 * bluntness_[c]));
    const double even = even_ * cells_[c].length;
    return std::clamp(wanted, shortest * even, longest * even);
  }

  std::span<const MeasuredCell> cells_;
  double count_;
  double even_;                    // of evenly spread cells: the length over the measured one
  std::vector<double> bluntness_;  // per cell: g, a length; 0 where the surface is sharp
};

}  // namespace

std::vector<double> lengths_of_equal_error(std::span<const MeasuredCell> cells, double count) {
  return EqualError(cells, count).run();
}

}  // namespace geolloyd

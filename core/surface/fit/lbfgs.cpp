#include "core/surface/fit/lbfgs.h"

#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>

namespace geolloyd {
namespace {

double sum_of_dots(const std::vector<Vec3>& x, const std::vector<Vec3>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += dot(x[i], y[i]);
  return sum;
}

class Lbfgs {
 public:
  Lbfgs(const PointsFunction& function, const PointDescent& options, std::vector<Vec3>& x)
      : function_(function), options_(options), x_(x), gradient_(x.size()) {}

  void run() {
    value_ = function_(x_, gradient_);
    for (int i = 0; i < options_.iterations; ++i) {
      const double before = value_;
      if (!step()) {
        if (pairs_.empty()) return;
        pairs_.clear();  // what was learned is of no use here
        continue;
      }
      if (before - value_ < options_.least_gain * std::abs(value_)) return;
      if (options_.keep_going && !options_.keep_going()) return;
    }
  }

 private:
  // Of two iterations.
  struct Pair {
    std::vector<Vec3> step;
    std::vector<Vec3> turn;  // of the gradient
    double product;          // of both; above 0
  };

  // False where no length of step brings anything.
  bool step() {
    constexpr int attempts = 8;
    constexpr double shorter = 0.4;
    constexpr double least_share = 1e-4;  // of what the slope promises
    const std::vector<Vec3> direction = find_direction();
    const double slope = sum_of_dots(direction, gradient_);
    if (!(slope < 0)) return false;
    std::vector<Vec3> to(x_.size());
    std::vector<Vec3> gradient(x_.size());
    double length = 1;
    for (int attempt = 0; attempt < attempts; ++attempt, length *= shorter) {
      for (std::size_t i = 0; i < x_.size(); ++i) to[i] = x_[i] + length * direction[i];
      const double value = function_(to, gradient);
      if (!(value <= value_ + least_share * length * slope)) continue;
      value_ = value;
      learn(to, gradient);
      x_ = std::move(to);
      gradient_ = std::move(gradient);
      return true;
    }
    return false;
  }

  void learn(const std::vector<Vec3>& to, const std::vector<Vec3>& gradient) {
    constexpr std::size_t most_pairs = 7;
    Pair pair = {to, gradient, 0};
    for (std::size_t i = 0; i < x_.size(); ++i) {
      pair.step[i] -= x_[i];
      pair.turn[i] -= gradient_[i];
    }
    pair.product = sum_of_dots(pair.step, pair.turn);
    if (!(pair.product > 0)) return;
    pairs_.push_back(std::move(pair));
    if (pairs_.size() > most_pairs) pairs_.pop_front();
  }

  // The two loops, with steps cut to the longest.
  [[nodiscard]] std::vector<Vec3> find_direction() const {
    std::vector<Vec3> d = gradient_;
    std::vector<double> share(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      share[k] = sum_of_dots(pairs_[k].step, d) / pairs_[k].product;
      for (std::size_t i = 0; i < d.size(); ++i) d[i] -= share[k] * pairs_[k].turn[i];
    }
    const double scale = scale_of_preconditioner();
    for (std::size_t i = 0; i < d.size(); ++i) d[i] *= scale * options_.preconditioner[i];
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double back = sum_of_dots(pairs_[k].turn, d) / pairs_[k].product;
      for (std::size_t i = 0; i < d.size(); ++i) d[i] += (share[k] - back) * pairs_[k].step[i];
    }
    for (Vec3& step : d) {
      const double length = norm(step);
      step *= length > options_.longest_step ? -options_.longest_step / length : -1;
    }
    return d;
  }

  [[nodiscard]] double scale_of_preconditioner() const {
    if (pairs_.empty()) return 1;
    double sum = 0;
    const Pair& last = pairs_.back();
    for (std::size_t i = 0; i < last.turn.size(); ++i) {
      sum += options_.preconditioner[i] * dot(last.turn[i], last.turn[i]);
    }
    return sum > 0 ? last.product / sum : 1;
  }

  const PointsFunction& function_;
  const PointDescent& options_;
  std::vector<Vec3>& x_;
  std::vector<Vec3> gradient_;
  double value_ = 0;
  std::deque<Pair> pairs_;  // the latest last
};

}  // namespace

void descend(const PointsFunction& function, const PointDescent& options, std::vector<Vec3>& x) {
  Lbfgs(function, options, x).run();
}

}  // namespace geolloyd

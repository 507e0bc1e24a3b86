#include "tools/evaluation/vertex_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr std::size_t first = 500;
constexpr std::size_t least = 4;

[[noreturn]] void give_up(double distance, std::size_t vertices, std::size_t most) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", distance);
  throw InvalidInput("tolerance: the largest distance is " + std::string(text.data()) + " with " +
                     std::to_string(vertices) + " vertices, and more than " + std::to_string(most) +
                     " are not tried; give a larger tolerance");
}

}  // namespace

VertexSearch::VertexSearch(double tolerance, std::size_t most)
    : tolerance_(tolerance), most_(std::max(least, most)) {
  if (!std::isfinite(tolerance) || !(tolerance > 0)) {
    throw InvalidInput("tolerance: give a distance above 0");
  }
}

std::optional<std::size_t> VertexSearch::next() const {
  if (trials_.empty()) return std::clamp(first, least, most_);
  // Distance falls with the square of edges, so with the number of vertices.
  const double distance = trials_.back().distance;
  const double wanted = static_cast<double>(tried_) * distance / tolerance_;
  constexpr double hopeless = 10;
  if (enough_ == 0 && (tried_ == most_ || wanted > hopeless * static_cast<double>(most_))) {
    give_up(distance, tried_, most_);
  }
  if (has_close_bounds()) return next_probe();
  // Far from the bounds the middle serves better.
  const auto low = static_cast<double>(too_few_);
  const double high = enough_ > 0 ? static_cast<double>(enough_) : 8 * static_cast<double>(tried_);
  const double guess =
      std::clamp(wanted, low * std::pow(high / low, 0.2), low * std::pow(high / low, 0.8));
  return std::clamp(static_cast<std::size_t>(std::lround(guess)), too_few_ + 1,
                    enough_ > 0 ? enough_ - 1 : most_);
}

bool VertexSearch::has_close_bounds() const {
  constexpr double close = 1.05;
  return enough_ > 0 && (static_cast<double>(enough_) <= close * static_cast<double>(too_few_) ||
                         enough_ == too_few_ + 1);
}

// Fewer than those that suffice, where bounds are already close. The share is less after each one
// that was too far.
std::optional<std::size_t> VertexSearch::next_probe() const {
  constexpr std::size_t most_probes = 5;
  constexpr std::array shares = {0.9, 0.8, 0.7};
  if (probes_ == most_probes || vain_probes_ == shares.size()) return std::nullopt;
  const auto wanted =
      static_cast<std::size_t>(shares.at(vain_probes_) * static_cast<double>(enough_));
  if (wanted < least) return std::nullopt;
  return wanted;
}

bool VertexSearch::add(const ToleranceTrial& trial) {
  tried_ = *next();
  trials_.push_back(trial);
  const bool is_within = trial.distance <= tolerance_;
  // A remesh may have more vertices than it was asked for.
  const bool is_best = fewest_ == 0 || (is_within && trial.vertices < fewest_);
  if (is_within && is_best) fewest_ = trial.vertices;
  if (has_close_bounds()) {
    ++probes_;
    vain_probes_ = is_within ? 0 : vain_probes_ + 1;
    if (is_within) enough_ = tried_;
  } else {
    (is_within ? enough_ : too_few_) = tried_;
  }
  return is_best;
}

}  // namespace geolloyd

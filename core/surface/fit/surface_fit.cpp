#include "core/surface/fit/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mesh/mesh_quality.h"
#include "core/surface/fit/fit_functional.h"
#include "core/surface/fit/fit_guards.h"
#include "core/surface/fit/lbfgs.h"
#include "core/surface/fit/sample_projection.h"

namespace geolloyd {
namespace {

constexpr double least_reluctance = 0.02;

class Fitter {
 public:
  Fitter(const SurfaceInput& input, std::span<const RegionId> labels, std::size_t held,
         std::span<const Metric> metric, const Mesh& remesh, Executor& executor)
      : held_(held),
        metric_(metric),
        samples_(input.fine, labels, remesh.vertex_count()),
        remesh_(input.frame, remesh, executor),
        guards_(remesh_, metric),
        projection_(samples_, remesh_, executor),
        functional_(remesh_, samples_, projection_, metric, !input.fine.inverse_sizing.empty(),
                    held, executor),
        boost_(remesh.triangle_count(), 1) {}

  // Where closer and more regular do not go together, closer counts more.
  FitResult run() {
    FitResult result;
    result.before = begin_round();
    for (const double price : {0.006, 0.00075}) {
      result.after = fit(price, result.before);
      if (result.after.sum_of_squares < result.before.sum_of_squares) break;
      remesh_.positions = remesh_.start;
      result.after = begin_round();
    }
    for (std::size_t v = 0; v < remesh_.vertex_count(); ++v) {
      result.moved += remesh_.positions[v] != remesh_.start[v] ? 1 : 0;
    }
    return result;
  }

  [[nodiscard]] Vec3 move_of(std::size_t v) const { return remesh_.move_of(v); }

 private:
  // `price` of a triangle's strain.
  FitError fit(double price, const FitError& before) {
    functional_.set_price(price);
    boost_.assign(boost_.size(), 1);
    descend_in_rounds();
    put_back(before.largest);
    return begin_round();
  }

  // Where a round ends higher than it began, as feet are elsewhere then, it is taken back, and the
  // next one moves more reluctantly.
  void descend_in_rounds() {
    constexpr int rounds = 8;
    constexpr int most_taken_back = 4;
    constexpr double highest = 1.0005;
    double reluctance = least_reluctance;
    for (int round = 0, taken_back = 0; round < rounds;) {
      const std::vector<Vec3> before = remesh_.positions;
      const double value = functional_.value();
      update_boost();
      move(reluctance);
      begin_round();
      if (functional_.value() <= highest * value) {
        reluctance = std::max(least_reluctance, reluctance / 2);
        ++round;
        continue;
      }
      remesh_.positions = before;
      begin_round();
      reluctance *= 8;
      if (++taken_back > most_taken_back) return;
    }
  }

  void move(double reluctance) {
    constexpr double longest_step = 0.15;
    constexpr int iterations = 12;
    functional_.set_prices(boost_, reluctance);
    const PointsFunction function = [&](const std::vector<Vec3>& x, std::vector<Vec3>& gradient) {
      return functional_.evaluate(x, gradient);
    };
    std::vector<Vec3> x = remesh_.positions;
    descend(function, {functional_.preconditioner(), longest_step * functional_.side(), iterations},
            x);
    remesh_.positions = std::move(x);
  }

  // Small angles count more from round to round.
  void update_boost() {
    constexpr double cosine_37 = 0.7986355100472928;
    constexpr double cosine_33 = 0.838670567945424;
    constexpr double most_of_free = 300;
    constexpr double most_at_curves = 6;
    for (TriangleId t = 0; t < boost_.size(); ++t) {
      const double cosine =
          cosine_of_smallest_angle(corners_of(remesh_, remesh_.triangles[t], metric_));
      const auto& corners = remesh_.triangles[t];
      const bool is_free =
          std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return v >= held_; });
      const double most = is_free ? most_of_free : most_at_curves;
      if (cosine > cosine_37) {
        boost_[t] = std::min(most, boost_[t] * (cosine > cosine_33 ? 6 : 3));
      } else {
        boost_[t] = std::max(1.0, 0.8 * boost_[t]);
      }
    }
  }

  FitError begin_round() {
    const FitError error = projection_.project();
    functional_.begin_round();
    return error;
  }

  // What is bad goes back to where it was at first, until nothing is: the corners of triangles that
  // are folded or have small angles, and of those with samples farther than any was.
  void put_back(double largest) {
    for (bool any = true; any;) {
      projection_.project();
      std::vector<std::uint8_t> goes_back = guards_.corners_of_bad_triangles();
      mark_far(largest, goes_back);
      any = false;
      for (std::size_t v = 0; v < goes_back.size(); ++v) {
        if (goes_back[v] == 0 || remesh_.positions[v] == remesh_.start[v]) continue;
        remesh_.positions[v] = remesh_.start[v];
        any = true;
      }
    }
  }

  void mark_far(double largest, std::vector<std::uint8_t>& marked) const {
    const std::span<const TriangleId> triangle = projection_.triangles();
    for (std::size_t i = 0; i < triangle.size(); ++i) {
      if (triangle[i] == no_id || projection_.distance(i) <= largest) continue;
      for (const VertexId v : remesh_.triangles[triangle[i]]) marked[v] = 1;
      marked[samples_[i].near] = 1;
    }
  }

  std::size_t held_;
  std::span<const Metric> metric_;
  SurfaceSamples samples_;
  MovingRemesh remesh_;
  FitGuards guards_;
  SampleProjection projection_;
  FitFunctional functional_;
  std::vector<double> boost_;  // per triangle
};

}  // namespace

FitResult fit_to_surface(const SurfaceInput& input, std::span<const RegionId> labels,
                         std::size_t held, std::span<const Metric> metric, Mesh& remesh,
                         Executor& executor) {
  if (remesh.triangles.empty()) return {};
  Fitter fitter(input, labels, held, metric, remesh, executor);
  const FitResult result = fitter.run();
  for (std::size_t v = 0; v < remesh.vertex_count(); ++v) {
    const Vec3 move = fitter.move_of(v);
    if (dot(move, move) > 0) remesh.positions[v] += move / input.frame.scale;
  }
  return result;
}

}  // namespace geolloyd

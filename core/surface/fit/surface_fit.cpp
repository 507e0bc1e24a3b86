#include "core/surface/fit/surface_fit.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/mesh_quality.h"
#include "core/surface/fit/asked_areas.h"
#include "core/surface/fit/fit_functional.h"
#include "core/surface/fit/fit_guards.h"
#include "core/surface/fit/sample_projection.h"

namespace geolloyd {
namespace {

// Fewer for each of many vertices, which have less of the shape between them.
std::size_t samples_per_vertex(std::size_t vertices) {
  constexpr std::size_t enough = 160'000;  // in all
  return std::clamp<std::size_t>(enough / vertices, 8, 16);
}

FitSetting setting_of(const MovingRemesh& remesh, bool is_graded, std::size_t held) {
  AskedAreas asked = find_asked_areas(remesh, is_graded);
  return {held, held, asked.side, std::move(asked.at_vertex), {}};
}

class Fitter {
 public:
  Fitter(const SurfaceInput& input, std::span<const RegionId> labels, std::size_t held,
         std::span<const Metric> metric, const Mesh& remesh, Executor& executor,
         const FitEffort& effort)
      : held_(held),
        metric_(metric),
        samples_(input.fine, labels, remesh.vertex_count(),
                 samples_per_vertex(remesh.vertex_count())),
        remesh_(input.frame, remesh, executor),
        projection_(samples_, remesh_, executor),
        functional_(remesh_, samples_, projection_, metric,
                    setting_of(remesh_, !input.fine.inverse_sizing.empty(), held), executor),
        guards_(remesh_, metric, functional_.setting().side),
        effort_(effort),
        executor_(executor),
        boost_(remesh.triangle_count()) {}

  // Where closer and more regular do not go together, closer counts more.
  FitResult run() {
    FitResult result;
    result.before = projection_.project();
    first_triangle_.assign(projection_.triangles().begin(), projection_.triangles().end());
    result.negligible = 1e-3 * functional_.setting().side;
    const FitError allowed = {
        std::max(result.before.mean_square, result.negligible * result.negligible),
        std::max(result.before.largest, result.negligible)};
    for (const double price : {0.0065, 0.00075}) {
      result.after = fit(price, allowed.largest);
      if (result.after.mean_square < allowed.mean_square) break;
      remesh_.positions = remesh_.start;
      result.after = projection_.project();
      if (!goes_on()) break;
    }
    for (std::size_t v = 0; v < remesh_.vertex_count(); ++v) {
      result.moved += remesh_.positions[v] != remesh_.start[v] ? 1 : 0;
    }
    result.far_at = projection_.largest_at_vertices();
    return result;
  }

  [[nodiscard]] Vec3 move_of(std::size_t v) const { return remesh_.move_of(v); }

 private:
  [[nodiscard]] bool goes_on() const { return !effort_.keep_going || effort_.keep_going(); }

  // From the start, where samples are projected. `price` of strain.
  FitError fit(double price, double largest_allowed) {
    functional_.set_price(price / static_cast<double>(boost_.size()));
    functional_.begin_round();
    boost_.assign(boost_.size(), 1);
    descend_in_rounds();
    return put_back(largest_allowed);
  }

  // Where a round ends higher than it began, as feet are elsewhere then, it is taken back, and the
  // next one moves more reluctantly.
  void descend_in_rounds() {
    const FitDescent descent = {
        .longest_step = 0.15, .iterations = 12, .keep_going = effort_.keep_going};
    constexpr int most_taken_back = 4;
    constexpr double highest = 1.0005;
    constexpr double least_reluctance = 0.02;
    double reluctance = least_reluctance;
    for (int round = 0, taken_back = 0; round < effort_.rounds && goes_on();) {
      const std::vector<Vec3> before = remesh_.positions;
      update_boost();
      functional_.set_boost(boost_, reluctance);
      const double value = functional_.value();
      remesh_.positions = functional_.descend(descent);
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

  void begin_round() {
    projection_.project();
    functional_.begin_round();
  }

  // Bad vertices go back to where they were at first, until none is bad: those that guards name,
  // those about samples farther than any was, and then those of triangles that pass through each
  // other, if none did at first. A sample whose first triangle is back is looked for there: it is
  // no farther than it was then.
  FitError put_back(double largest) {
    while (true) {
      const FitError error = projection_.project();
      std::vector<std::uint8_t> goes_back = guards_.bad_vertices();
      mark_far(largest, goes_back);
      const bool any = begin_at_first(largest);
      if (put_back_those(goes_back) || any) continue;
      guards_.add_crossing(goes_back, executor_);
      if (!put_back_those(goes_back)) return error;
    }
  }

  // Whether any had moved.
  bool put_back_those(std::span<const std::uint8_t> goes_back) {
    bool any = false;
    for (std::size_t v = 0; v < goes_back.size(); ++v) {
      if (goes_back[v] == 0 || remesh_.positions[v] == remesh_.start[v]) continue;
      remesh_.positions[v] = remesh_.start[v];
      any = true;
    }
    return any;
  }

  void mark_far(double largest, std::vector<std::uint8_t>& marked) const {
    const std::span<const TriangleId> triangle = projection_.triangles();
    for (std::size_t i = 0; i < triangle.size(); ++i) {
      if (triangle[i] == no_id || projection_.distance(i) <= largest) continue;
      for (const TriangleId t : {triangle[i], first_triangle_[i]}) {
        for (const VertexId v : remesh_.triangles[t]) marked[v] = 1;
      }
      marked[samples_[i].near] = 1;
    }
  }

  // Far samples whose first triangle is as it was. Whether there are any.
  bool begin_at_first(double largest) {
    bool any = false;
    for (std::size_t i = 0; i < first_triangle_.size(); ++i) {
      const TriangleId first = first_triangle_[i];
      if (first == no_id || projection_.triangles()[i] == first) continue;
      if (projection_.distance(i) <= largest) continue;
      const Triangle& corners = remesh_.triangles[first];
      const bool is_back = std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
        return remesh_.positions[v] == remesh_.start[v];
      });
      if (!is_back) continue;
      projection_.begin_at(i, first);
      any = true;
    }
    return any;
  }

  std::size_t held_;
  std::span<const Metric> metric_;
  SurfaceSamples samples_;
  MovingRemesh remesh_;
  SampleProjection projection_;
  FitFunctional functional_;
  FitGuards guards_;
  const FitEffort& effort_;
  Executor& executor_;
  std::vector<double> boost_;               // per triangle
  std::vector<TriangleId> first_triangle_;  // per sample: of the start
};

}  // namespace

FitResult fit_to_surface(const SurfaceInput& input, std::span<const RegionId> labels,
                         std::size_t held, std::span<const Metric> metric, Mesh& remesh,
                         Executor& executor, const FitEffort& effort) {
  if (remesh.triangles.empty()) return {};
  Fitter fitter(input, labels, held, metric, remesh, executor, effort);
  FitResult result = fitter.run();
  for (std::size_t v = 0; v < remesh.vertex_count(); ++v) {
    const Vec3 move = fitter.move_of(v);
    if (dot(move, move) > 0) remesh.positions[v] += move / input.frame.scale;
  }
  return result;
}

}  // namespace geolloyd

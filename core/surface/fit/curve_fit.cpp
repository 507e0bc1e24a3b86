#include "core/surface/fit/curve_fit.h"

#include <algorithm>
#include <cstdint>

#include "core/base/loops.h"
#include "core/surface/fit/asked_areas.h"
#include "core/surface/fit/curve_chain.h"
#include "core/surface/fit/fit_guards.h"
#include "core/surface/fit/moving_remesh.h"

namespace geolloyd {
namespace {

class CurveFitter {
 public:
  CurveFitter(const SurfaceInput& input, const FeatureCurves& curves,
              std::span<const RegionId> labels, std::span<const Metric> metric, const Mesh& remesh,
              Executor& executor)
      : executor_(executor),
        remesh_(input.frame, remesh, executor),
        guards_(remesh_, metric, find_asked_areas(remesh_, false).side) {
    for (const FeatureCurve& curve : curves.curves) {
      chains_.emplace_back(input.fine, curve, labels, remesh_.positions);
    }
    hold(curves.corners, labels);
  }

  std::vector<MovedCurveVertex> run() {
    parallel_for(executor_, chains_.size(), 1, [&](std::size_t c) { chains_[c].fit(); });
    take_positions();
    while (put_back_bad() || put_back_crossing()) take_positions();
    return moved();
  }

  [[nodiscard]] Vec3 move_of(VertexId v) const { return remesh_.move_of(v); }

 private:
  // Corners, and what more than one curve has.
  void hold(std::span<const VertexId> corners, std::span<const RegionId> labels) {
    std::vector<std::uint8_t> curves_at(remesh_.vertex_count(), 0);
    for (const VertexId v : corners) curves_at[labels[v]] = 2;
    for (const CurveChain& chain : chains_) {
      for (const VertexId v : chain.vertices()) {
        curves_at[v] = static_cast<std::uint8_t>(std::min(curves_at[v] + 1, 2));
      }
    }
    for (CurveChain& chain : chains_) {
      for (std::size_t i = 0; i < chain.vertices().size(); ++i) {
        if (curves_at[chain.vertices()[i]] > 1) chain.hold(i);
      }
    }
  }

  void take_positions() {
    for (const CurveChain& chain : chains_) {
      for (std::size_t i = 0; i < chain.vertices().size(); ++i) {
        remesh_.positions[chain.vertices()[i]] = chain.position(i);
      }
    }
  }

  bool put_back_bad() {
    std::vector<std::uint8_t> is_bad = guards_.bad_vertices();
    guards_.add_narrowed(is_bad);
    return put_back(is_bad);
  }

  bool put_back_crossing() {
    std::vector<std::uint8_t> crosses(remesh_.vertex_count(), 0);
    guards_.add_crossing(crosses, executor_);
    return put_back(crosses);
  }

  // Whether any had moved.
  bool put_back(std::span<const std::uint8_t> is_bad) {
    bool any = false;
    for (CurveChain& chain : chains_) {
      bool here = false;
      for (std::size_t i = 0; i < chain.vertices().size(); ++i) {
        if (is_bad[chain.vertices()[i]] != 0) here = chain.put_back(i) || here;
      }
      if (here) chain.put_back_far();
      any = any || here;
    }
    return any;
  }

  [[nodiscard]] std::vector<MovedCurveVertex> moved() const {
    std::vector<MovedCurveVertex> moved;
    for (const CurveChain& chain : chains_) {
      for (std::size_t i = 0; i < chain.vertices().size(); ++i) {
        const VertexId v = chain.vertices()[i];
        if (remesh_.positions[v] != remesh_.start[v]) moved.push_back({v, chain.point_near(i)});
      }
    }
    std::sort(moved.begin(), moved.end(),
              [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
    return moved;
  }

  Executor& executor_;
  MovingRemesh remesh_;
  FitGuards guards_;
  std::vector<CurveChain> chains_;
};

}  // namespace

std::vector<MovedCurveVertex> fit_to_curves(const SurfaceInput& input, const FeatureCurves& curves,
                                            std::span<const RegionId> labels,
                                            std::span<const Metric> metric, Mesh& remesh,
                                            Executor& executor) {
  if (curves.curves.empty()) return {};
  CurveFitter fitter(input, curves, labels, metric, remesh, executor);
  std::vector<MovedCurveVertex> moved = fitter.run();
  for (const auto& [v, on_curve] : moved) {
    remesh.positions[v] += fitter.move_of(v) / input.frame.scale;
  }
  return moved;
}

}  // namespace geolloyd

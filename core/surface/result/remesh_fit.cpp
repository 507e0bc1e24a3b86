#include "core/surface/result/remesh_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/heeding_executor.h"
#include "core/repair/crossings.h"
#include "core/surface/fit/curve_fit.h"
#include "core/surface/fit/surface_fit.h"
#include "core/surface/flips/glides.h"
#include "core/surface/result/site_places.h"

namespace geolloyd {
namespace {

class RemeshFit {
 public:
  RemeshFit(const RemeshSurface& surface, std::vector<RegionId>& labels, Remesh& remesh,
            Executor& executor, const std::function<bool()>& keep_going)
      : surface_(surface),
        labels_(labels),
        remesh_(remesh),
        executor_(executor),
        full_({.keep_going = keep_going}),
        glide_executor_(executor, [this] { give_up_if_told(); }) {}

  void run() {
    fit_curves();
    const FitResult fitted =
        surface_.may_glide ? fit_and_glide() : fit(labels_, full_, remesh_.mesh, executor_);
    const auto distance = [&](const FitError& error) {
      return std::sqrt(error.mean_square) / surface_.input.frame.scale;
    };
    remesh_.vertices_fitted += fitted.moved;
    remesh_.distance_before_fit = distance(fitted.before);
    remesh_.distance_after_fit = distance(fitted.moved > 0 ? fitted.after : fitted.before);
    place_fitted(surface_.mesh, surface_.input, remesh_.mesh.positions, labels_,
                 surface_.curves.vertices, remesh_.curve_vertices, remesh_.places, executor_);
  }

 private:
  void fit_curves() {
    const auto moved = fit_to_curves(surface_.input, surface_.curves, labels_, surface_.shape,
                                     remesh_.mesh, executor_);
    place_on_curves(surface_.mesh, surface_.input, moved, labels_, remesh_.places, executor_);
    remesh_.vertices_fitted = moved.size();
  }

  [[nodiscard]] FitResult fit(std::span<const RegionId> labels, const FitEffort& effort, Mesh& mesh,
                              Executor& executor) const {
    return fit_to_surface(surface_.input, labels, remesh_.curve_vertices, surface_.shape, mesh,
                          executor, effort);
  }

  void give_up_if_told() const {
    if (!full_.keep_going()) throw GivenUp();
  }

  // What glides must not exceed.
  struct Bounds {
    double mean_square = 0;
    double largest = 0;
    bool may_cross = false;  // some triangles pass through each other
  };
  [[nodiscard]] Bounds bounds_of(const FitResult& fitted) {
    constexpr double farther = 1.05;    // times: in the mean
    constexpr double farthest = 1.125;  // times: the farthest point
    constexpr double close = 4;         // times what is negligible: the root, on mechanical parts
    const double root =
        std::max(farther * std::sqrt(fitted.after.mean_square), close * fitted.negligible);
    return {root * root, std::max(farthest * fitted.before.largest, fitted.negligible),
            !find_crossings(remesh_.mesh, glide_executor_).empty()};
  }

  // Of many vertices the first fit is short, which saves time and changes little, and another one
  // is made in any case. After an interrupt the first one is the result.
  FitResult fit_and_glide() {
    constexpr std::size_t many = 10'000;
    constexpr int few_rounds = 3;
    const bool is_short = remesh_.mesh.vertex_count() >= many;
    FitEffort first = full_;
    if (is_short) first.rounds = few_rounds;
    FitResult fitted = fit(labels_, first, remesh_.mesh, executor_);
    try {
      give_up_if_told();
      glide(is_short, fitted);
    } catch (const GivenUp&) {  // all is as it was before what was given up
    }
    return fitted;
  }

  // Where a point is much farther than all were before any fit, or triangles pass through each
  // other and none did, glides are tried again without those about there. There are none if the
  // mean distance grows.
  void glide(bool fits_anew, FitResult& fitted) {
    constexpr int attempts = 2;
    const Bounds bounds = bounds_of(fitted);
    std::vector<std::uint8_t> barred(remesh_.mesh.vertex_count(), 0);
    Outcome outcome = Outcome::too_bad_somewhere;
    for (int i = 0; i < attempts && outcome == Outcome::too_bad_somewhere; ++i) {
      outcome = try_glides(bounds, barred, fitted);
    }
    if (fits_anew && outcome != Outcome::taken) fit_anew(fitted);
  }

  enum class Outcome { taken, too_bad_somewhere, none };

  Outcome try_glides(const Bounds& bounds, std::vector<std::uint8_t>& barred, FitResult& fitted) {
    Mesh gliding = remesh_.mesh;
    std::vector<RegionId> labels = labels_;
    const std::size_t glides =
        glide_irregular(surface_.input, labels, remesh_.curve_vertices, surface_.on_curves, barred,
                        gliding, glide_executor_);
    if (glides == 0) return Outcome::none;
    const FitResult anew = fit(labels, full_, gliding, glide_executor_);
    give_up_if_told();
    const auto crossings =
        bounds.may_cross ? std::vector<TrianglePair>() : find_crossings(gliding, glide_executor_);
    if (anew.after.largest > bounds.largest || !crossings.empty()) {
      for (std::size_t v = 0; v < barred.size(); ++v) {
        if (anew.far_at[v] > bounds.largest) barred[v] = 1;
      }
      mark_corners(gliding, crossings, barred);
      return Outcome::too_bad_somewhere;
    }
    if (anew.after.mean_square > bounds.mean_square) return Outcome::none;
    labels_ = std::move(labels);
    remesh_.glides = glides;
    take(std::move(gliding), anew, fitted);
    return Outcome::taken;
  }

  void fit_anew(FitResult& fitted) {
    Mesh mesh = remesh_.mesh;
    const FitResult anew = fit(labels_, full_, mesh, glide_executor_);
    take(std::move(mesh), anew, fitted);
  }

  void take(Mesh mesh, const FitResult& anew, FitResult& fitted) {
    remesh_.mesh = std::move(mesh);
    fitted.after = anew.after;
    fitted.moved = std::max(fitted.moved, anew.moved);
  }

  const RemeshSurface& surface_;
  std::vector<RegionId>& labels_;
  Remesh& remesh_;
  Executor& executor_;
  FitEffort full_;
  HeedingExecutor glide_executor_;  // of what is given up after an interrupt
};

}  // namespace

void fit_remesh(const RemeshSurface& surface, std::vector<RegionId>& labels, Remesh& remesh,
                Executor& executor, const std::function<bool()>& keep_going) {
  RemeshFit(surface, labels, remesh, executor, keep_going).run();
}

}  // namespace geolloyd

#include "core/surface/result/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "core/surface/result/fit_equations.h"
#include "core/surface/result/fit_guards.h"
#include "core/surface/result/sample_projection.h"

namespace geolloyd {
namespace {

class Fitter {
 public:
  Fitter(const SurfaceInput& input, std::span<const RegionId> labels, std::size_t held,
         std::span<const Metric> metric, const Mesh& remesh, Executor& executor)
      : held_(held),
        executor_(executor),
        samples_(input.fine, labels, remesh.vertex_count()),
        remesh_(input.frame, remesh, executor),
        guards_(remesh_, metric),
        projection_(samples_, remesh_, executor) {}

  // Freely sideways is closest; more and more reluctantly is more regular.
  FitResult run() {
    const double quality = guards_.mean_quality();
    FitResult result;
    result.before = projection_.project();
    find_reaches();
    if (!try_all({0.05, 0.3, 2.0}, quality - 0.0008, result)) {
      try_all({0.02, 0.05, 0.12, 0.3, 0.8, 2.0}, quality - 0.005, result);
    }
    for (std::size_t v = 0; v < remesh_.vertex_count(); ++v) {
      result.moved += remesh_.positions[v] != remesh_.start[v] ? 1 : 0;
    }
    return result;
  }

  [[nodiscard]] Vec3 move_of(std::size_t v) const { return remesh_.move_of(v); }

 private:
  // False where even the most reluctant moves make triangles less regular than that.
  bool try_all(std::initializer_list<double> reluctances, double least_quality, FitResult& result) {
    for (const double reluctance : reluctances) {
      if (descend(reluctance, least_quality, result)) return true;
    }
    return false;
  }

  // False where that makes triangles less regular; then all is as it was at the start. As it was,
  // too, where the first step is no descent.
  bool descend(double reluctance, double least_quality, FitResult& result) {
    constexpr int rounds = 3;
    result.after = result.before;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<Vec3> before = remesh_.positions;
      move(FitEquations(remesh_, samples_, projection_, reluctance, held_, executor_).solve());
      guards_.undo_bad_moves(before);
      if (guards_.mean_quality() < least_quality) {
        remesh_.positions = remesh_.start;
        projection_.project();
        return false;
      }
      const FitError error = project_within(result.before.largest, before);
      if (!(error.sum_of_squares < result.after.sum_of_squares) ||
          error.largest > result.before.largest) {
        remesh_.positions = before;
        break;
      }
      result.after = error;
    }
    return true;
  }

  // Undoes moves about samples that are farther than that.
  FitError project_within(double largest, const std::vector<Vec3>& before) {
    FitError error = projection_.project();
    constexpr int attempts = 5;
    for (int attempt = 0; attempt < attempts && error.largest > largest; ++attempt) {
      const std::span<const TriangleId> triangle = projection_.triangles();
      for (std::size_t i = 0; i < triangle.size(); ++i) {
        if (triangle[i] == no_id || projection_.distance(i) <= largest) continue;
        for (const VertexId v : remesh_.triangles[triangle[i]]) {
          remesh_.positions[v] = before[v];
        }
      }
      guards_.undo_bad_moves(before);
      error = projection_.project();
    }
    return error;
  }

  // The largest distance that any sample about a vertex had: the vertex itself need not be farther
  // from the surface.
  void find_reaches() {
    reach_.assign(remesh_.vertex_count(), 0);
    const std::span<const TriangleId> triangle = projection_.triangles();
    for (std::size_t i = 0; i < triangle.size(); ++i) {
      if (triangle[i] == no_id) continue;
      for (const VertexId v : remesh_.triangles[triangle[i]]) {
        reach_[v] = std::max(reach_[v], projection_.distance(i));
      }
    }
  }

  // By a quarter of an edge at most.
  void move(const std::vector<Vec3>& x) {
    std::vector<Vec3> moved = remesh_.positions;
    for (std::size_t v = 0; v < x.size(); ++v) {
      double shortest = std::numeric_limits<double>::infinity();
      for (const TriangleId t : remesh_.triangles_at[v]) {
        for (const VertexId u : remesh_.triangles[t]) {
          if (u == v) continue;
          shortest = std::min(shortest, norm(remesh_.positions[u] - remesh_.positions[v]));
        }
      }
      constexpr double share_of_reach = 0.7;
      const double length = norm(x[v]);
      const double most = shortest / 4;
      if (length > 0 && length < std::numeric_limits<double>::infinity()) {
        moved[v] += length > most ? Vec3(x[v] * (most / length)) : x[v];
        const Vec3 way = moved[v] - remesh_.start[v];
        const double up = dot(way, remesh_.vertex_normal[v]);
        const double reach = share_of_reach * reach_[v];
        if (std::abs(up) > reach) {
          moved[v] -= (up > 0 ? up - reach : up + reach) * remesh_.vertex_normal[v];
        }
      }
    }
    remesh_.positions = std::move(moved);
  }

  std::size_t held_;
  Executor& executor_;
  SurfaceSamples samples_;
  MovingRemesh remesh_;
  FitGuards guards_;
  SampleProjection projection_;
  std::vector<double> reach_;  // per vertex
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

#include "core/surface/surface_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/bucketing.h"
#include "core/mesh/closest_on_triangle.h"

namespace geolloyd {
namespace {

using Matrix3 = Eigen::Matrix3d;

// A point of the surface that stands for some area, near a vertex of the remesh.
struct Sample {
  Vec3 point;
  double weight;
  RegionId near;
};

// Centroids of triangles, where there are many. Else with their corners: the rule is exact for
// polynomials of degree 2.
std::vector<Sample> draw_samples(const FineMesh& fine, std::span<const RegionId> labels,
                                 std::size_t vertices) {
  constexpr std::size_t per_vertex = 16;
  const std::size_t stride =
      std::max<std::size_t>(1, fine.triangle_count() / (per_vertex * vertices));
  const bool has_corners = fine.triangle_count() < per_vertex * vertices;
  const double share = has_corners ? 0.75 : static_cast<double>(stride);
  std::vector<Sample> samples;
  for (std::size_t t = 0; t < fine.triangle_count(); t += stride) {
    const auto& [a, b, c] = fine.triangles[t];
    const std::vector<Vec3>& p = fine.positions;
    samples.push_back({(p[a] + p[b] + p[c]) / 3, share * fine.area[t], labels[a]});
  }
  if (!has_corners) return samples;
  for (VertexId v = 0; v < fine.vertex_count(); ++v) {
    double area = 0;
    for (const TriangleId t : fine.triangles_at(v)) area += fine.area[t];
    samples.push_back({fine.positions[v], area / 12, labels[v]});
  }
  return samples;
}

// Where on the remesh a sample is projected to.
struct Foot {
  TriangleId triangle = no_id;
  std::array<double, 3> weights = {0, 0, 0};
  Vec3 away = Vec3::Zero();  // to the sample
};

// What the samples of a triangle ask of its corners' moves along its normal: the symmetric matrix
// of sums of weight * share * share, and the sums of weight * share * height.
struct Pull {
  std::array<std::array<double, 3>, 3> matrix{};
  std::array<double, 3> height{};

  void add(const Sample& sample, const Foot& foot, const Vec3& normal) {
    const double above = dot(foot.away, normal);
    for (std::size_t i = 0; i < 3; ++i) {
      const double weighted = sample.weight * foot.weights[i];
      height[i] += weighted * above;
      for (std::size_t j = 0; j < 3; ++j) matrix[i][j] += weighted * foot.weights[j];
    }
  }
};

class Fitter {
 public:
  Fitter(const SurfaceInput& input, std::span<const RegionId> labels,
         std::span<const std::uint8_t> stays,
         std::span<const std::array<VertexId, 2>> feature_edges, const Mesh& remesh,
         Executor& executor)
      : triangles_(remesh.triangles),
        samples_(draw_samples(input.fine, labels, remesh.vertex_count())),
        executor_(executor) {
    for (const Vec3& p : remesh.positions) positions_.push_back(input.frame.to_unit(p));
    at_ = bucket_sort<TriangleId>(executor, positions_.size(), triangles_.size(),
                                  [&](std::size_t t, auto&& put) {
                                    for (const VertexId v : triangles_[t])
                                      put(v, static_cast<TriangleId>(t));
                                  });
    find_freedoms(stays, feature_edges);
    largest_cosine_ = std::min(turned_by_two_degrees(largest_cosine_of_all()), 1.0);
  }

  FitResult run() {
    start_ = positions_;
    FitResult result;
    result.before = project();
    result.after = result.before;
    const int rounds = getenv("ROUNDS") ? atoi(getenv("ROUNDS")) : 3;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<Vec3> before = positions_;
      move(solve());
      undo_bad_moves(before);
      const FitError error = project();
      if (!(error.sum_of_squares < result.after.sum_of_squares) ||
          error.largest > std::max(result.after.largest, result.before.largest)) {
        positions_ = before;
        break;
      }
      result.after = error;
    }
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      result.moved += positions_[v] != start_[v] ? 1 : 0;
    }
    return result;
  }

  [[nodiscard]] Vec3 move_of(std::size_t v) const { return positions_[v] - start_[v]; }

 private:
  [[nodiscard]] Vec3 normal_of(TriangleId t) const {
    const auto& [a, b, c] = triangles_[t];
    return normalized(cross(positions_[b] - positions_[a], positions_[c] - positions_[a]));
  }

  FitError project() {
    feet_.resize(samples_.size());
    parallel_for(executor_, samples_.size(), 256,
                 [&](std::size_t i) { feet_[i] = foot_of(samples_[i]); });
    FitError error;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (feet_[i].triangle == no_id) continue;
      const double square = dot(feet_[i].away, feet_[i].away);
      error.sum_of_squares += samples_[i].weight * square;
      error.largest = std::max(error.largest, square);
    }
    error.largest = std::sqrt(error.largest);
    return error;
  }

  [[nodiscard]] Foot foot_of(const Sample& sample) const {
    Foot best;
    double least = std::numeric_limits<double>::infinity();
    for (const TriangleId t : at_[sample.near]) {
      const auto& [a, b, c] = triangles_[t];
      const Vec3& s = sample.point;
      const auto [v, w] = weights_closest_to_origin(
          {positions_[a] - s, positions_[b] - s, positions_[c] - s});
      const double u = 1 - v - w;
      const Vec3 away = s - (u * positions_[a] + v * positions_[b] + w * positions_[c]);
      if (dot(away, away) >= least) continue;
      least = dot(away, away);
      best = {t, {u, v, w}, away};
    }
    return best;
  }

  // Conjugate gradients on the normal equations, preconditioned by their blocks on the diagonal.
  std::vector<Vec3> solve() {
    gather();
    const std::size_t count = positions_.size();
    std::vector<Vec3> x(count, Vec3::Zero());
    std::vector<Vec3> residual(count, Vec3::Zero());
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        residual[triangles_[t][i]] += pull_[t].height[i] * normal_[t];
      }
    }
    for (std::size_t v = 0; v < count; ++v) residual[v] -= reluctance_[v] * sideways(v, move_of(v));
    restrict(residual);
    std::vector<Vec3> z = precondition(residual);
    std::vector<Vec3> direction = z;
    double product = sum_of_dots(residual, z);
    constexpr int iterations = 30;
    for (int i = 0; i < iterations && product > 0; ++i) {
      std::vector<Vec3> image = times(direction);
      restrict(image);
      const double step = product / sum_of_dots(direction, image);
      for (std::size_t v = 0; v < count; ++v) {
        x[v] += step * direction[v];
        residual[v] -= step * image[v];
      }
      z = precondition(residual);
      const double next = sum_of_dots(residual, z);
      for (std::size_t v = 0; v < count; ++v) direction[v] = z[v] + (next / product) * direction[v];
      product = next;
    }
    return x;
  }

  void gather() {
    normal_.resize(triangles_.size());
    for (TriangleId t = 0; t < triangles_.size(); ++t) normal_[t] = normal_of(t);
    pull_.assign(triangles_.size(), {});
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const TriangleId t = feet_[i].triangle;
      if (t != no_id) pull_[t].add(samples_[i], feet_[i], normal_[t]);
    }
    // Where normals about a vertex leave a direction open, it does not move that way.
    constexpr double damping = 0.02;
    block_.assign(positions_.size(), Matrix3::Zero());
    damping_.assign(positions_.size(), least_damping);
    reluctance_.assign(positions_.size(), 0);
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId v = triangles_[t][i];
        block_[v] += pull_[t].matrix[i][i] * normal_[t] * normal_[t].transpose();
        damping_[v] += damping * pull_[t].matrix[i][i];
      }
    }
    const double reluctance = getenv("REL") ? atof(getenv("REL")) : 0.2;
    for (std::size_t v = 0; v < block_.size(); ++v) {
      reluctance_[v] = freedom_[v] == Freedom::along ? reluctance / damping * damping_[v] : 0;
      block_[v] += (damping_[v] + reluctance_[v]) * Matrix3::Identity() - reluctance_[v] * direction_[v] * direction_[v].transpose();
    }
  }

  // How a vertex may move: not at all, freely but reluctant to leave its normal, or across a
  // direction.
  enum class Freedom : std::uint8_t { none, along, across };

  void find_freedoms(std::span<const std::uint8_t> stays,
                     std::span<const std::array<VertexId, 2>> feature_edges) {
    freedom_.assign(positions_.size(), Freedom::along);
    direction_.assign(positions_.size(), Vec3::Zero());
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      const Vec3 doubled = cross(positions_[b] - positions_[a], positions_[c] - positions_[a]);
      for (const VertexId v : triangles_[t]) direction_[v] += doubled;
    }
    std::vector<std::vector<VertexId>> along_feature(positions_.size());
    for (const auto& [a, b] : feature_edges) {
      along_feature[a].push_back(b);
      along_feature[b].push_back(a);
    }
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      const std::vector<VertexId>& others = along_feature[v];
      if (others.size() == 2) {
        freedom_[v] = Freedom::across;
        direction_[v] = positions_[others[1]] - positions_[others[0]];
      }
      if (stays[v] != 0 || others.size() == 1 || others.size() > 2) freedom_[v] = Freedom::none;
      direction_[v] = normalized(direction_[v]);
    }
  }

  [[nodiscard]] Vec3 sideways(std::size_t v, const Vec3& x) const {
    return x - dot(x, direction_[v]) * direction_[v];
  }

  void restrict(std::vector<Vec3>& x) const {
    for (std::size_t v = 0; v < x.size(); ++v) {
      const Vec3 along = dot(x[v], direction_[v]) * direction_[v];
      if (freedom_[v] == Freedom::none) {
        x[v] = Vec3::Zero();
      } else {
        if (freedom_[v] == Freedom::across) x[v] -= along;
      }
    }
  }

  [[nodiscard]] std::vector<Vec3> times(const std::vector<Vec3>& x) const {
    std::vector<Vec3> y(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) y[v] = damping_[v] * x[v] + reluctance_[v] * sideways(v, x[v]);
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      const Triangle& corners = triangles_[t];
      std::array<double, 3> height{};
      for (std::size_t i = 0; i < 3; ++i) height[i] = dot(normal_[t], x[corners[i]]);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::array<double, 3>& row = pull_[t].matrix[i];
        y[corners[i]] +=
            (row[0] * height[0] + row[1] * height[1] + row[2] * height[2]) * normal_[t];
      }
    }
    return y;
  }

  // By Cramer's rule. Vec3 and Matrix3 of Eigen would choose the order of operations themselves.
  [[nodiscard]] std::vector<Vec3> precondition(const std::vector<Vec3>& x) const {
    std::vector<Vec3> y(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) {
      const Vec3 a = block_[v].col(0);
      const Vec3 b = block_[v].col(1);
      const Vec3 c = block_[v].col(2);
      const double volume = dot(a, cross(b, c));
      y[v] = Vec3(dot(x[v], cross(b, c)), dot(a, cross(x[v], c)), dot(a, cross(b, x[v]))) / volume;
    }
    restrict(y);
    return y;
  }

  static double sum_of_dots(const std::vector<Vec3>& x, const std::vector<Vec3>& y) {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v) sum += dot(x[v], y[v]);
    return sum;
  }

  // By a quarter of an edge at most.
  void move(const std::vector<Vec3>& x) {
    std::vector<Vec3> moved = positions_;
    for (std::size_t v = 0; v < x.size(); ++v) {
      double shortest = std::numeric_limits<double>::infinity();
      for (const TriangleId t : at_[v]) {
        for (const VertexId u : triangles_[t]) {
          if (u != v) shortest = std::min(shortest, norm(positions_[u] - positions_[v]));
        }
      }
      const double length = norm(x[v]);
      const double most = shortest / 4;
      if (length > 0 && length < std::numeric_limits<double>::infinity()) {
        moved[v] += length > most ? Vec3(x[v] * (most / length)) : x[v];
      }
    }
    positions_ = std::move(moved);
  }

  void undo_bad_moves(const std::vector<Vec3>& before) {
    std::vector<TriangleId> bad;
    do {
      bad.clear();
      for (TriangleId t = 0; t < triangles_.size(); ++t) {
        if (is_bad(t)) bad.push_back(t);
      }
      std::size_t undone = 0;
      for (const TriangleId t : bad) {
        for (const VertexId v : triangles_[t]) {
          if (positions_[v] == before[v]) continue;
          positions_[v] = before[v];
          ++undone;
        }
      }
      if (undone == 0) return;
    } while (!bad.empty());
  }

  [[nodiscard]] bool is_bad(TriangleId t) const {
    constexpr double least_turn_cosine = 0.8660254037844386;  // of 30 degrees
    const auto& [a, b, c] = triangles_[t];
    const Vec3 old = cross(start_[b] - start_[a], start_[c] - start_[a]);
    return largest_cosine(t) > largest_cosine_ ||
           dot(normalized(old), normal_of(t)) < least_turn_cosine;
  }

  // Of the smallest angle.
  [[nodiscard]] double largest_cosine(TriangleId t) const {
    const auto& [a, b, c] = triangles_[t];
    const Vec3 ab = normalized(positions_[b] - positions_[a]);
    const Vec3 bc = normalized(positions_[c] - positions_[b]);
    const Vec3 ca = normalized(positions_[a] - positions_[c]);
    return -std::min({dot(ab, bc), dot(bc, ca), dot(ca, ab)});
  }
  [[nodiscard]] double largest_cosine_of_all() const {
    double largest = -1;
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      largest = std::max(largest, largest_cosine(t));
    }
    return largest;
  }
  // The cosine of an angle that is 2 degrees smaller.
  static double turned_by_two_degrees(double cosine) {
    constexpr double cosine_of_two = 0.9993908270190958;
    constexpr double sine_of_two = 0.03489949670250097;
    if (cosine >= cosine_of_two) return 1;
    return cosine * cosine_of_two + std::sqrt(1 - cosine * cosine) * sine_of_two;
  }

  static constexpr double least_damping = 1e-30;

  const std::vector<Triangle>& triangles_;
  std::vector<Sample> samples_;
  Executor& executor_;
  std::vector<Vec3> positions_;
  std::vector<Vec3> start_;
  Bucketed<TriangleId> at_;  // triangles at a vertex
  double largest_cosine_ = 1;
  std::vector<Freedom> freedom_;  // per vertex
  std::vector<Vec3> direction_;   // per vertex: of its freedom
  std::vector<Foot> feet_;     // per sample
  std::vector<Vec3> normal_;   // per triangle
  std::vector<Pull> pull_;     // per triangle
  std::vector<Matrix3> block_;  // per vertex
  std::vector<double> damping_;
  std::vector<double> reluctance_;
};

}  // namespace

FitResult fit_to_surface(const SurfaceInput& input, std::span<const RegionId> labels,
                         std::span<const std::uint8_t> stays,
                         std::span<const std::array<VertexId, 2>> feature_edges, Mesh& remesh,
                         Executor& executor) {
  if (remesh.triangles.empty()) return {};
  Fitter fitter(input, labels, stays, feature_edges, remesh, executor);
  const FitResult result = fitter.run();
  for (std::size_t v = 0; v < remesh.vertex_count(); ++v) {
    const Vec3 move = fitter.move_of(v);
    if (dot(move, move) > 0) remesh.positions[v] += move / input.frame.scale;
  }
  return result;
}

}  // namespace geolloyd

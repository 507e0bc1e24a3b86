#include "core/surface/result/surface_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/bucketing.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/mesh/mesh_quality.h"

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
// polynomials of degree 2. Samples are not kept, for there are many.
class Samples {
 public:
  Samples(const FineMesh& fine, std::span<const RegionId> labels, std::size_t vertices)
      : fine_(fine),
        labels_(labels),
        has_corners_(fine.triangle_count() < per_vertex * vertices),
        stride_(std::max<std::size_t>(1, fine.triangle_count() / (per_vertex * vertices))),
        centroids_((fine.triangle_count() + stride_ - 1) / stride_) {}

  [[nodiscard]] std::size_t size() const {
    return centroids_ + (has_corners_ ? fine_.vertex_count() : 0);
  }
  [[nodiscard]] Sample operator[](std::size_t i) const {
    const std::vector<Vec3>& p = fine_.positions;
    if (i < centroids_) {
      const auto t = static_cast<TriangleId>(i * stride_);
      const auto& [a, b, c] = fine_.triangles[t];
      const double share = has_corners_ ? 0.75 : static_cast<double>(stride_);
      return {(p[a] + p[b] + p[c]) / 3, share * fine_.area(t), labels_[a]};
    }
    const auto v = static_cast<VertexId>(i - centroids_);
    double area = 0;
    for (const TriangleId t : fine_.triangles_at(v)) area += fine_.area(t);
    return {p[v], area / 12, labels_[v]};
  }

 private:
  static constexpr std::size_t per_vertex = 16;

  const FineMesh& fine_;
  std::span<const RegionId> labels_;
  bool has_corners_;
  std::size_t stride_;
  std::size_t centroids_;
};

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
  Fitter(const SurfaceInput& input, std::span<const RegionId> labels, std::size_t held,
         std::span<const Metric> metric, const Mesh& remesh, Executor& executor)
      : held_(held),
        metric_(metric),
        samples_(input.fine, labels, remesh.vertex_count()),
        executor_(executor) {
    mesh_.triangles = remesh.triangles;
    for (const Vec3& p : remesh.positions) mesh_.positions.push_back(input.frame.to_unit(p));
    at_ = bucket_sort<TriangleId>(executor, mesh_.positions.size(), mesh_.triangles.size(),
                                  [&](std::size_t t, auto&& put) {
                                    for (const VertexId v : mesh_.triangles[t])
                                      put(v, static_cast<TriangleId>(t));
                                  });
    find_normals_at_vertices();
    largest_cosine_ = std::min(turned_by_two_degrees(largest_cosine_of_all()), 1.0);
  }

  // Freely sideways is closest; more and more reluctantly is more regular.
  FitResult run() {
    start_ = mesh_.positions;
    const double quality = mean_quality();
    FitResult result;
    result.before = project();
    find_reaches();
    if (!try_all({0.05, 0.3, 2.0}, quality - 0.0008, result)) {
      try_all({0.02, 0.05, 0.12, 0.3, 0.8, 2.0}, quality - 0.005, result);
    }
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      result.moved += mesh_.positions[v] != start_[v] ? 1 : 0;
    }
    return result;
  }

  [[nodiscard]] Vec3 move_of(std::size_t v) const { return mesh_.positions[v] - start_[v]; }

 private:
  // False where even the most reluctant moves make triangles less regular than that.
  bool try_all(std::initializer_list<double> reluctances, double least_quality, FitResult& result) {
    for (const double reluctance : reluctances) {
      reluctance_ = reluctance;
      if (descend(least_quality, result)) return true;
    }
    return false;
  }

  // False where that makes triangles less regular; then all is as it was at the start. As it was,
  // too, where the first step is no descent.
  bool descend(double least_quality, FitResult& result) {
    constexpr int rounds = 3;
    result.after = result.before;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<Vec3> before = mesh_.positions;
      move(solve());
      undo_bad_moves(before);
      if (mean_quality() < least_quality) {
        mesh_.positions = start_;
        project();
        return false;
      }
      const FitError error = project_within(result.before.largest, before);
      if (!(error.sum_of_squares < result.after.sum_of_squares) ||
          error.largest > result.before.largest) {
        mesh_.positions = before;
        break;
      }
      result.after = error;
    }
    return true;
  }

  // Undoes moves about samples that are farther than that.
  FitError project_within(double largest, const std::vector<Vec3>& before) {
    FitError error = project();
    constexpr int attempts = 5;
    for (int attempt = 0; attempt < attempts && error.largest > largest; ++attempt) {
      for (std::size_t i = 0; i < foot_triangle_.size(); ++i) {
        if (foot_triangle_[i] == no_id || std::sqrt(square_distance_[i]) <= largest) continue;
        for (const VertexId v : mesh_.triangles[foot_triangle_[i]]) {
          mesh_.positions[v] = before[v];
        }
      }
      undo_bad_moves(before);
      error = project();
    }
    return error;
  }

  [[nodiscard]] double mean_quality() const {
    double sum = 0;
    for (const Triangle& t : mesh_.triangles) {
      sum += triangle_quality(corners_of(mesh_, t, metric_));
    }
    return sum / static_cast<double>(mesh_.triangles.size());
  }

  [[nodiscard]] Vec3 normal_of(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return normalized(
        cross(mesh_.positions[b] - mesh_.positions[a], mesh_.positions[c] - mesh_.positions[a]));
  }

  FitError project() {
    foot_triangle_.resize(samples_.size());
    square_distance_.resize(samples_.size());
    parallel_for(executor_, samples_.size(), 256, [&](std::size_t i) {
      const Foot foot = foot_of(samples_[i]);
      foot_triangle_[i] = foot.triangle;
      square_distance_[i] = dot(foot.away, foot.away);
    });
    FitError error;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (foot_triangle_[i] == no_id) continue;
      error.sum_of_squares += samples_[i].weight * square_distance_[i];
      error.largest = std::max(error.largest, square_distance_[i]);
    }
    error.largest = std::sqrt(error.largest);
    return error;
  }

  [[nodiscard]] Foot foot_of(const Sample& sample) const {
    Foot best;
    double least = std::numeric_limits<double>::infinity();
    for (const TriangleId t : at_[sample.near]) {
      const Foot foot = foot_on(t, sample.point);
      if (dot(foot.away, foot.away) >= least) continue;
      least = dot(foot.away, foot.away);
      best = foot;
    }
    return best;
  }
  [[nodiscard]] Foot foot_on(TriangleId t, const Vec3& point) const {
    const auto& [ia, ib, ic] = mesh_.triangles[t];
    const Vec3& a = mesh_.positions[ia];
    const Vec3& b = mesh_.positions[ib];
    const Vec3& c = mesh_.positions[ic];
    const auto [v, w] = weights_closest_to_origin({a - point, b - point, c - point});
    const double u = 1 - v - w;
    return {t, {u, v, w}, point - (u * a + v * b + w * c)};
  }

  // Conjugate gradients on the normal equations, preconditioned by their blocks on the diagonal.
  std::vector<Vec3> solve() {
    gather();
    const std::size_t count = mesh_.positions.size();
    std::vector<Vec3> x(count, Vec3::Zero());
    std::vector<Vec3> residual(count, Vec3::Zero());
    for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        residual[mesh_.triangles[t][i]] += pull_[t].height[i] * normal_[t];
      }
    }
    for (std::size_t v = 0; v < count; ++v) residual[v] -= stiffness_[v] * sideways(v, move_of(v));
    hold(residual);
    std::vector<Vec3> z = precondition(residual);
    std::vector<Vec3> direction = z;
    double product = sum_of_dots(residual, z);
    constexpr int iterations = 30;
    for (int i = 0; i < iterations && product > 0; ++i) {
      std::vector<Vec3> image = times(direction);
      hold(image);
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
    normal_.resize(mesh_.triangles.size());
    for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) normal_[t] = normal_of(t);
    pull_.assign(mesh_.triangles.size(), {});
    const auto on_triangle = bucket_sort<std::uint32_t>(
        executor_, mesh_.triangles.size(), samples_.size(), [&](std::size_t i, auto&& put) {
          if (foot_triangle_[i] != no_id) put(foot_triangle_[i], static_cast<std::uint32_t>(i));
        });
    parallel_for(executor_, mesh_.triangles.size(), 64, [&](std::size_t t) {
      for (const std::uint32_t i : on_triangle[t]) {
        const Sample sample = samples_[i];
        pull_[t].add(sample, foot_on(static_cast<TriangleId>(t), sample.point), normal_[t]);
      }
    });
    // Where normals about a vertex leave a direction open, it does not move that way.
    constexpr double damping = 0.02;
    block_.assign(mesh_.positions.size(), Matrix3::Zero());
    damping_.assign(mesh_.positions.size(), least_damping);
    stiffness_.assign(mesh_.positions.size(), 0);
    for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId v = mesh_.triangles[t][i];
        block_[v] += pull_[t].matrix[i][i] * normal_[t] * normal_[t].transpose();
        damping_[v] += damping * pull_[t].matrix[i][i];
      }
    }
    for (std::size_t v = 0; v < block_.size(); ++v) {
      stiffness_[v] = reluctance_ / damping * damping_[v];
      block_[v] += (damping_[v] + stiffness_[v]) * Matrix3::Identity();
      block_[v] -= stiffness_[v] * vertex_normal_[v] * vertex_normal_[v].transpose();
    }
  }

  void find_normals_at_vertices() {
    vertex_normal_.assign(mesh_.positions.size(), Vec3::Zero());
    for (const Triangle& t : mesh_.triangles) {
      const std::vector<Vec3>& p = mesh_.positions;
      const Vec3 doubled = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
      for (const VertexId v : t) vertex_normal_[v] += doubled;
    }
    for (Vec3& normal : vertex_normal_) normal = normalized(normal);
  }

  [[nodiscard]] Vec3 sideways(std::size_t v, const Vec3& x) const {
    return x - dot(x, vertex_normal_[v]) * vertex_normal_[v];
  }

  void hold(std::vector<Vec3>& x) const { std::fill_n(x.begin(), held_, Vec3::Zero()); }

  [[nodiscard]] std::vector<Vec3> times(const std::vector<Vec3>& x) const {
    std::vector<Vec3> y(x.size());
    for (std::size_t v = 0; v < x.size(); ++v)
      y[v] = damping_[v] * x[v] + stiffness_[v] * sideways(v, x[v]);
    for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& corners = mesh_.triangles[t];
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
    return y;
  }

  static double sum_of_dots(const std::vector<Vec3>& x, const std::vector<Vec3>& y) {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v) sum += dot(x[v], y[v]);
    return sum;
  }

  // The largest distance that any sample about a vertex had: the vertex itself need not be farther
  // from the surface.
  void find_reaches() {
    reach_.assign(mesh_.positions.size(), 0);
    for (std::size_t i = 0; i < foot_triangle_.size(); ++i) {
      if (foot_triangle_[i] == no_id) continue;
      for (const VertexId v : mesh_.triangles[foot_triangle_[i]]) {
        reach_[v] = std::max(reach_[v], std::sqrt(square_distance_[i]));
      }
    }
  }

  // By a quarter of an edge at most.
  void move(const std::vector<Vec3>& x) {
    std::vector<Vec3> moved = mesh_.positions;
    for (std::size_t v = 0; v < x.size(); ++v) {
      double shortest = std::numeric_limits<double>::infinity();
      for (const TriangleId t : at_[v]) {
        for (const VertexId u : mesh_.triangles[t]) {
          if (u != v) shortest = std::min(shortest, norm(mesh_.positions[u] - mesh_.positions[v]));
        }
      }
      constexpr double share_of_reach = 0.7;
      const double length = norm(x[v]);
      const double most = shortest / 4;
      if (length > 0 && length < std::numeric_limits<double>::infinity()) {
        moved[v] += length > most ? Vec3(x[v] * (most / length)) : x[v];
        const Vec3 way = moved[v] - start_[v];
        const double up = dot(way, vertex_normal_[v]);
        const double reach = share_of_reach * reach_[v];
        if (std::abs(up) > reach) {
          moved[v] -= (up > 0 ? up - reach : up + reach) * vertex_normal_[v];
        }
      }
    }
    mesh_.positions = std::move(moved);
  }

  void undo_bad_moves(const std::vector<Vec3>& before) {
    std::vector<TriangleId> bad;
    do {
      bad.clear();
      for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
        if (is_bad(t)) bad.push_back(t);
      }
      std::size_t undone = 0;
      for (const TriangleId t : bad) {
        for (const VertexId v : mesh_.triangles[t]) {
          if (mesh_.positions[v] == before[v]) continue;
          mesh_.positions[v] = before[v];
          ++undone;
        }
      }
      if (undone == 0) return;
    } while (!bad.empty());
  }

  [[nodiscard]] bool is_bad(TriangleId t) const {
    constexpr double least_turn_cosine = 0.8660254037844386;  // of 30 degrees
    const auto& [a, b, c] = mesh_.triangles[t];
    const Vec3 old = cross(start_[b] - start_[a], start_[c] - start_[a]);
    return largest_cosine(t) > largest_cosine_ ||
           dot(normalized(old), normal_of(t)) < least_turn_cosine;
  }

  // Of the smallest angle.
  [[nodiscard]] double largest_cosine(TriangleId t) const {
    return cosine_of_smallest_angle(corners_of(mesh_, mesh_.triangles[t], metric_));
  }
  [[nodiscard]] double largest_cosine_of_all() const {
    double largest = -1;
    for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
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

  std::size_t held_;
  std::span<const Metric> metric_;  // per vertex; empty: none
  Samples samples_;
  Executor& executor_;
  Mesh mesh_;  // the remesh, unit frame
  std::vector<Vec3> start_;
  Bucketed<TriangleId> at_;  // triangles at a vertex
  double largest_cosine_ = 1;
  std::vector<Vec3> vertex_normal_;        // per vertex: its normal at the start
  std::vector<TriangleId> foot_triangle_;  // per sample
  std::vector<double> square_distance_;    // per sample
  std::vector<Vec3> normal_;               // per triangle
  std::vector<Pull> pull_;                 // per triangle
  std::vector<Matrix3> block_;             // per vertex
  std::vector<double> damping_;
  double reluctance_ = 0;          // to move sideways, over that to move along the normal
  std::vector<double> stiffness_;  // per vertex, sideways
  std::vector<double> reach_;      // per vertex
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

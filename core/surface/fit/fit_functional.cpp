#include "core/surface/fit/fit_functional.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/loops.h"
#include "core/surface/fit/lbfgs.h"

namespace geolloyd {
namespace {

constexpr std::size_t some_triangles = 64;

}  // namespace

FitFunctional::FitFunctional(const MovingRemesh& remesh, const SampleSet& samples,
                             const SampleProjection& projection, std::span<const Metric> metric,
                             FitSetting setting, Executor& executor)
    : remesh_(remesh),
      samples_(samples),
      projection_(projection),
      metric_(metric),
      setting_(std::move(setting)),
      executor_(executor),
      share_(remesh.triangle_count()),
      boost_(remesh.triangle_count(), 1),
      slope_(remesh.triangle_count()) {
  for (const auto& [a, b, c] : remesh.triangles) {
    area_.push_back((setting_.area[a] + setting_.area[b] + setting_.area[c]) / 3);
  }
}

void FitFunctional::begin_round() {
  from_ = remesh_.positions;
  find_strains();
  find_pulls();
  find_squares();
  find_planes();
}

// Seen along the mean normal of the corners on no curve, for a curve's lies between faces.
void FitFunctional::find_strains() {
  const std::vector<Vec3> normals = normals_at_vertices(remesh_);
  root_.clear();
  for (TriangleId t = 0; t < share_.size(); ++t) {
    share_[t] = {};
    share_[t].normal = remesh_.normal_of(t);
    Vec3 seen_along = Vec3::Zero();
    if (metric_.empty()) {
      for (const VertexId v : remesh_.triangles[t]) {
        if (v >= setting_.on_curves) seen_along += normals[v];
      }
    } else {
      const auto& [a, b, c] = remesh_.triangles[t];
      root_.emplace_back((1.0 / 3) * (metric_[a] + metric_[b] + metric_[c]));
      const std::array<Vec3, 3> p = corners(t, from_);
      seen_along = cross(root_[t](p[1] - p[0]), root_[t](p[2] - p[0]));
    }
    seen_along = normalized(seen_along);
    if (dot(seen_along, seen_along) == 0) seen_along = share_[t].normal;
    share_[t].strain = TriangleStrain(seen_along, area_[t]);
  }
}

void FitFunctional::find_pulls() {
  const std::span<const TriangleId> triangle = projection_.triangles();
  double weights = 0;
  double squares = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (triangle[i] == no_id) continue;
    const double weight = samples_[i].weight;
    weights += weight;
    squares += weight * projection_.square_distance(i);
  }
  mean_square_ = weights > 0 ? squares / weights : 0;
  if (setting_.whole) {
    weights = setting_.whole->weight;
    mean_square_ = setting_.whole->mean_square;
  }
  per_square_ = weights > 0 ? 1 / (setting_.side * setting_.side * weights) : 0;
  const auto on_triangle = bucket_sort<std::uint32_t>(
      executor_, share_.size(), samples_.size(), [&](std::size_t i, auto&& put) {
        if (triangle[i] != no_id) put(triangle[i], static_cast<std::uint32_t>(i));
      });
  parallel_for(executor_, share_.size(), some_triangles, [&](std::size_t t) {
    for (const std::uint32_t i : on_triangle[t]) {
      add_sample(i, static_cast<TriangleId>(t), share_[t]);
    }
  });
}

void FitFunctional::add_sample(std::size_t i, TriangleId t, Share& share) const {
  constexpr double above = 0.9;  // of the distance: along the normal
  const Sample sample = samples_[i];
  const Foot foot = projection_.foot_on(t, sample.point);
  const double distance = norm(foot.away);
  const double height = dot(foot.away, share.normal);
  const double weight = sample.weight * weight_of(distance * distance);
  if (distance <= 1e-7 * setting_.side || std::abs(height) >= above * distance) {
    share.pull.add(weight, foot.barycentric, height);
    return;
  }
  Oblique& oblique = share.oblique.emplace_back();
  oblique.direction = foot.away / distance;
  oblique.pull.add(weight, foot.barycentric, distance);
}

double FitFunctional::weight_of(double square_distance) const {
  constexpr double most = 100;
  if (!(mean_square_ > 0)) return 1;
  return std::min(most, std::sqrt(1 + square_distance / (6 * mean_square_)));
}

void FitFunctional::find_squares() {
  const std::span<const TriangleId> triangle = projection_.triangles();
  squares_ = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (triangle[i] == no_id) continue;
    const double square = projection_.square_distance(i);
    squares_ += samples_[i].weight * weight_of(square) * square;
  }
}

// Else strain that counts much would make a plane uneven between samples.
void FitFunctional::find_planes() {
  plane_.assign(remesh_.vertex_count(), Vec3::Zero());
  parallel_for(executor_, plane_.size(), some_triangles, [&](std::size_t v) {
    if (v < setting_.held || remesh_.triangles_at[v].empty()) return;
    const Vec3& normal = share_[remesh_.triangles_at[v][0]].normal;
    if (is_plane(v, normal)) plane_[v] = normal;
  });
}

bool FitFunctional::is_plane(std::size_t v, const Vec3& normal) const {
  constexpr double least_cosine = 1 - 1e-12;
  constexpr double highest = 1e-6;  // of a side: samples, in the mean
  return std::all_of(remesh_.triangles_at[v].begin(), remesh_.triangles_at[v].end(),
                     [&](TriangleId t) {
                       const Share& share = share_[t];
                       if (!share.oblique.empty() || dot(normal, share.normal) < least_cosine)
                         return false;
                       for (std::size_t k = 0; k < 3; ++k) {
                         const std::array<double, 3>& row = share.pull.matrix[k];
                         const double weight = row[0] + row[1] + row[2];
                         if (std::abs(share.pull.height[k]) > highest * setting_.side * weight)
                           return false;
                       }
                       return true;
                     });
}

double FitFunctional::value() const {
  double strain = 0;
  for (std::size_t t = 0; t < share_.size(); ++t) {
    Slope slope;
    add_strain(t, from_, slope);
    strain += slope.value;
  }
  return distances() + strain;
}

void FitFunctional::set_boost(std::span<const double> boost, double reluctance) {
  constexpr double stiffness_of_strain = 20;  // times the side^-2: of its second derivatives
  boost_.assign(boost.begin(), boost.end());
  std::vector<double> pull(remesh_.vertex_count(), 0);
  std::vector<double> strain(remesh_.vertex_count(), 0);
  for (std::size_t t = 0; t < share_.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = remesh_.triangles[t][k];
      pull[v] += 2 * per_square_ * share_[t].pull.matrix[k][k];
      for (const Oblique& oblique : share_[t].oblique) {
        pull[v] += 2 * per_square_ * oblique.pull.matrix[k][k];
      }
      strain[v] += price_ * boost_[t] / 6 * stiffness_of_strain / (setting_.side * setting_.side);
    }
  }
  resistance_.resize(pull.size());
  preconditioner_.resize(pull.size());
  for (std::size_t v = 0; v < pull.size(); ++v) {
    resistance_[v] = reluctance * pull[v];
    const double stiffness = pull[v] + strain[v] + 2 * resistance_[v];
    preconditioner_[v] = stiffness > 0 ? 1 / stiffness : 0;
  }
}

std::vector<Vec3> FitFunctional::descend(const FitDescent& descent) const {
  const PointsFunction function = [&](const std::vector<Vec3>& x, std::vector<Vec3>& gradient) {
    return evaluate(x, gradient);
  };
  std::vector<Vec3> x = remesh_.positions;
  geolloyd::descend(function,
                    {preconditioner_, descent.longest_step * setting_.side, descent.iterations,
                     descent.least_gain, descent.keep_going},
                    x);
  return x;
}

double FitFunctional::evaluate(const std::vector<Vec3>& positions,
                               std::vector<Vec3>& gradient) const {
  parallel_for(executor_, share_.size(), some_triangles,
               [&](std::size_t t) { slope_[t] = slope_of(t, positions); });
  double value = 0;
  for (const Slope& slope : slope_) value += slope.value;
  for (std::size_t v = setting_.held; v < positions.size(); ++v) {
    const Vec3 move = positions[v] - from_[v];
    value += resistance_[v] * dot(move, move);
  }
  parallel_for(executor_, positions.size(), some_triangles, [&](std::size_t v) {
    gradient[v] = Vec3::Zero();
    if (v < setting_.held) return;
    gradient[v] = 2 * resistance_[v] * (positions[v] - from_[v]);
    for (const TriangleId t : remesh_.triangles_at[v]) {
      const Triangle& corner = remesh_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (corner[k] == v) gradient[v] += slope_[t].gradient[k];
      }
    }
    gradient[v] -= dot(plane_[v], gradient[v]) * plane_[v];
  });
  return value;
}

std::array<Vec3, 3> FitFunctional::corners(std::size_t t, const std::vector<Vec3>& at) const {
  const auto& [a, b, c] = remesh_.triangles[t];
  return {at[a], at[b], at[c]};
}

FitFunctional::Slope FitFunctional::slope_of(std::size_t t, const std::vector<Vec3>& at) const {
  Slope slope;
  const std::array<Vec3, 3> before = corners(t, from_);
  std::array<Vec3, 3> move = corners(t, at);
  for (std::size_t k = 0; k < 3; ++k) move[k] -= before[k];
  add_pull(share_[t].pull, share_[t].normal, move, slope);
  for (const Oblique& oblique : share_[t].oblique) {
    add_pull(oblique.pull, oblique.direction, move, slope);
  }
  add_strain(t, at, slope);
  return slope;
}

void FitFunctional::add_pull(const Pull& pull, const Vec3& direction,
                             const std::array<Vec3, 3>& move, Slope& slope) const {
  std::array<double, 3> up{};
  for (std::size_t k = 0; k < 3; ++k) up[k] = dot(direction, move[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<double, 3>& row = pull.matrix[k];
    const double image = row[0] * up[0] + row[1] * up[1] + row[2] * up[2];
    slope.value += per_square_ * up[k] * (image - 2 * pull.height[k]);
    slope.gradient[k] += (2 * per_square_ * (image - pull.height[k])) * direction;
  }
}

void FitFunctional::add_strain(std::size_t t, const std::vector<Vec3>& at, Slope& slope) const {
  const double weight = price_ * boost_[t];
  std::array<Vec3, 3> p = corners(t, at);
  if (root_.empty()) {
    slope.value += weight * share_[t].strain.evaluate(p, weight, &slope.gradient);
    return;
  }
  for (Vec3& corner : p) corner = root_[t](corner);
  std::array<Vec3, 3> mapped = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  slope.value += weight * share_[t].strain.evaluate(p, weight, &mapped);
  for (std::size_t k = 0; k < 3; ++k) slope.gradient[k] += root_[t].transposed(mapped[k]);
}

}  // namespace geolloyd

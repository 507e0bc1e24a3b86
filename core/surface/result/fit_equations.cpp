#include "core/surface/result/fit_equations.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/base/bucketing.h"
#include "core/base/loops.h"

namespace geolloyd {
namespace {

using Matrix3 = Eigen::Matrix3d;

constexpr double least_damping = 1e-30;

double sum_of_dots(const std::vector<Vec3>& x, const std::vector<Vec3>& y) {
  double sum = 0;
  for (std::size_t v = 0; v < x.size(); ++v) sum += dot(x[v], y[v]);
  return sum;
}

}  // namespace

FitEquations::FitEquations(const MovingRemesh& remesh, const SurfaceSamples& samples,
                           const SampleProjection& projection, double reluctance, std::size_t held,
                           Executor& executor)
    : remesh_(remesh),
      samples_(samples),
      projection_(projection),
      held_(held),
      executor_(executor) {
  gather_samples();
  find_blocks(reluctance);
}

void FitEquations::gather_samples() {
  normal_.resize(remesh_.triangle_count());
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) normal_[t] = remesh_.normal_of(t);
  pull_.assign(remesh_.triangle_count(), {});
  const std::span<const TriangleId> triangle = projection_.triangles();
  const auto on_triangle = bucket_sort<std::uint32_t>(
      executor_, remesh_.triangle_count(), samples_.size(), [&](std::size_t i, auto&& put) {
        if (triangle[i] != no_id) put(triangle[i], static_cast<std::uint32_t>(i));
      });
  parallel_for(executor_, remesh_.triangle_count(), 64, [&](std::size_t t) {
    for (const std::uint32_t i : on_triangle[t]) {
      const Sample sample = samples_[i];
      pull_[t].add(sample, projection_.foot_on(static_cast<TriangleId>(t), sample.point),
                   normal_[t]);
    }
  });
}

void FitEquations::find_blocks(double reluctance) {
  // Where normals about a vertex leave a direction open, it does not move that way.
  constexpr double damping = 0.02;
  block_.assign(remesh_.vertex_count(), Matrix3::Zero());
  damping_.assign(remesh_.vertex_count(), least_damping);
  stiffness_.assign(remesh_.vertex_count(), 0);
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = remesh_.triangles[t][i];
      block_[v] += pull_[t].matrix[i][i] * normal_[t] * normal_[t].transpose();
      damping_[v] += damping * pull_[t].matrix[i][i];
    }
  }
  for (std::size_t v = 0; v < block_.size(); ++v) {
    stiffness_[v] = reluctance / damping * damping_[v];
    block_[v] += (damping_[v] + stiffness_[v]) * Matrix3::Identity();
    block_[v] -= stiffness_[v] * remesh_.vertex_normal[v] * remesh_.vertex_normal[v].transpose();
  }
}

void FitEquations::hold(std::vector<Vec3>& x) const {
  std::fill_n(x.begin(), held_, Vec3::Zero());
}

std::vector<Vec3> FitEquations::times(const std::vector<Vec3>& x) const {
  std::vector<Vec3> y(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    y[v] = damping_[v] * x[v] + stiffness_[v] * remesh_.sideways(v, x[v]);
  }
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    const Triangle& corners = remesh_.triangles[t];
    std::array<double, 3> height{};
    for (std::size_t i = 0; i < 3; ++i) height[i] = dot(normal_[t], x[corners[i]]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<double, 3>& row = pull_[t].matrix[i];
      y[corners[i]] += (row[0] * height[0] + row[1] * height[1] + row[2] * height[2]) * normal_[t];
    }
  }
  return y;
}

// By Cramer's rule. Vec3 and Matrix3 of Eigen would choose the order of operations themselves.
std::vector<Vec3> FitEquations::precondition(const std::vector<Vec3>& x) const {
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

std::vector<Vec3> FitEquations::solve() const {
  const std::size_t count = remesh_.vertex_count();
  std::vector<Vec3> x(count, Vec3::Zero());
  std::vector<Vec3> residual(count, Vec3::Zero());
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      residual[remesh_.triangles[t][i]] += pull_[t].height[i] * normal_[t];
    }
  }
  for (std::size_t v = 0; v < count; ++v) {
    residual[v] -= stiffness_[v] * remesh_.sideways(v, remesh_.move_of(v));
  }
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

}  // namespace geolloyd

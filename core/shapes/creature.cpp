#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/creature_blocks.h"
#include "core/shapes/shape_tools.h"
#include "core/shapes/shapes.h"

// The animal is drawn in blocks. Smoothed, their occupancy is a field whose iso-surface is the
// skin. The blocks' own surface, drawn taut on the skin, becomes a coarse cage of even triangles;
// the mesh is that cage refined and put back on the skin. So its topology is that of the blocks,
// and every vertex costs the same few evaluations. Last, the random seed bends the whole.

namespace geolloyd {
namespace {

using creature_blocks::full_length;
using creature_blocks::half_width;
using creature_blocks::height;
using creature_blocks::is_solid;
using creature_blocks::QuadMesh;

// Cubic B-spline field of the blocks, blurred once more so that no step between blocks shows: 1
// deep inside, 0 far outside.
class Field {
 public:
  Field() : value_(std::size_t{nx} * ny * nz) {
    for (int z = 0; z < nz; ++z) {
      for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
          value_[index(x, y, z)] = is_solid(x - margin, y - margin - half_width, z - margin);
        }
      }
    }
    for (const std::size_t stride : {index(1, 0, 0), index(0, 1, 0), index(0, 0, 1)}) blur(stride);
  }

  /// So many Newton steps along the gradient, from a point near the skin. The skin lies a little
  /// outside the blocks, lest legs two blocks thick waste away.
  [[nodiscard]] Vec3 pull_to_skin(Vec3 p, int steps) const {
    constexpr double skin = 0.3;
    constexpr double longest_step = 0.5;
    for (int step = 0; step < steps; ++step) {
      const auto [value, gradient] = at(p);
      const double slope = norm(gradient);
      if (slope < 1e-9) break;
      const double way = std::clamp((skin - value) / slope, -longest_step, longest_step);
      p += gradient * (way / slope);
    }
    return p;
  }

 private:
  struct Sample {
    double value = 0;
    Vec3 gradient = Vec3::Zero();
  };

  // The four blocks that reach a coordinate, with the spline's values and slopes there.
  struct Taps {
    int first;
    std::array<double, 4> weight{};
    std::array<double, 4> slope{};

    Taps(double coordinate, int count) {
      const double u = coordinate - 0.5 + margin;
      first = std::clamp(static_cast<int>(std::floor(u)) - 1, 0, count - 4);
      const double t = u - (first + 1);
      const double s = 1 - t;
      weight = {s * s * s / 6, (4 - 3 * t * t * (2 - t)) / 6, (4 - 3 * s * s * (2 - s)) / 6,
                t * t * t / 6};
      slope = {-s * s / 2, t * (3 * t - 4) / 2, -s * (3 * s - 4) / 2, t * t / 2};
    }
  };

  [[nodiscard]] Sample at(const Vec3& p) const {
    const Taps x(p.x(), nx);
    const Taps y(p.y() + half_width, ny);
    const Taps z(p.z(), nz);
    const double* corner = &value_[index(x.first, y.first, z.first)];
    Sample sample;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        const double* row = corner + (k * ny + j) * nx;
        double value = 0;
        double slope = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          value += x.weight[i] * row[i];
          slope += x.slope[i] * row[i];
        }
        sample.value += value * y.weight[j] * z.weight[k];
        sample.gradient.x() += slope * y.weight[j] * z.weight[k];
        sample.gradient.y() += value * y.slope[j] * z.weight[k];
        sample.gradient.z() += value * y.weight[j] * z.slope[k];
      }
    }
    return sample;
  }

  // Weights 1 2 1 along one axis. The margin is wide enough for nothing to reach the ends.
  void blur(std::size_t stride) {
    const std::vector<double> sharp = value_;
    for (std::size_t i = stride; i + stride < value_.size(); ++i) {
      value_[i] = (sharp[i - stride] + 2 * sharp[i] + sharp[i + stride]) / 4;
    }
  }

  static std::size_t index(int x, int y, int z) {
    const int i = (z * ny + y) * nx + x;
    return static_cast<std::size_t>(i);
  }

  static constexpr int margin = 3;
  static constexpr int nx = full_length + 2 * margin;
  static constexpr int ny = 2 * half_width + 2 * margin;
  static constexpr int nz = height + 2 * margin;
  std::vector<double> value_;
};

// Each vertex to the middle of its neighbours and back to the skin, over and over.
void draw_taut(QuadMesh& surface, const Field& field) {
  std::vector<int> neighbours(surface.positions.size(), 0);
  for (const auto& quad : surface.quads) {
    for (const VertexId v : quad) neighbours[v] += 2;
  }
  for (Vec3& p : surface.positions) p = field.pull_to_skin(p, 10);
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec3> sum(surface.positions.size(), Vec3::Zero());
    for (const auto& quad : surface.quads) {
      for (std::size_t i = 0; i < 4; ++i) {
        sum[quad[i]] += surface.positions[quad[(i + 1) % 4]] + surface.positions[quad[(i + 3) % 4]];
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) {
      const Vec3 halfway = (surface.positions[v] + sum[v] / neighbours[v]) / 2;
      surface.positions[v] = field.pull_to_skin(halfway, 3);
    }
  }
}

Mesh coarse_cage(const Field& field) {
  QuadMesh surface = creature_blocks::surface();
  draw_taut(surface, field);
  Mesh cage;
  cage.positions = std::move(surface.positions);
  for (const auto& [a, b, c, d] : surface.quads) add_quad(cage, a, b, c, d);
  return cage;
}

// Bends of the finished skin, each smooth and gentle enough to keep it from folding over.
class Posture {
 public:
  explicit Posture(std::uint64_t random_seed)
      : stride_(either_way(random_seed, 0, 0.6, 1.6)),
        head_turn_(either_way(random_seed, 1, 0.1, 0.35)),
        tail_swing_(either_way(random_seed, 2, 1.5, 4.0)),
        spine_bend_(either_way(random_seed, 3, 0.3, 1.0)) {}

  [[nodiscard]] Vec3 apply(const Vec3& p) const { return bend(turn_head(walk(p))); }

 private:
  // Between `low` and `high`, or as much below 0.
  static double either_way(std::uint64_t random_seed, std::uint64_t n, double low, double high) {
    const double size = low + (high - low) * random_unit(random_seed, 2 * n);
    return random_unit(random_seed, 2 * n + 1) < 0.5 ? -size : size;
  }

  // 0 up to `from`, 1 from `to` on, smooth between.
  static double rise(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }

  // Legs across from each other swing together, as in a trot.
  [[nodiscard]] Vec3 walk(const Vec3& p) const {
    const double front = 2 * rise(p.x(), 7, 15) - 1;
    const double left = 2 * rise(p.y(), -1, 1) - 1;
    return p + Vec3(stride_ * front * left * rise(-p.z(), -8, 0), 0, 0);
  }

  // About the upright axis through the neck, by an angle that grows along the neck. The tangent of
  // half of it gives sine and cosine without the mathematical library, whose last bits differ
  // between machines.
  [[nodiscard]] Vec3 turn_head(const Vec3& p) const {
    const double neck = 18;
    const double t = head_turn_ * rise(p.x() + p.z(), 24, 36);
    const double cosine = (1 - t * t) / (1 + t * t);
    const double sine = 2 * t / (1 + t * t);
    const double x = p.x() - neck;
    return {neck + cosine * x - sine * p.y(), sine * x + cosine * p.y(), p.z()};
  }

  // The tail rises backwards, so z - x tells how far along it a point is.
  [[nodiscard]] Vec3 bend(const Vec3& p) const {
    const double along = (p.x() - 10) / 10;
    const double tail = rise(p.z() - p.x(), 8, 24);
    return p + Vec3(0, tail_swing_ * tail + spine_bend_ * along * along, 0);
  }

  double stride_;
  double head_turn_;
  double tail_swing_;
  double spine_bend_;
};

}  // namespace

Mesh creature(std::size_t triangles, std::uint64_t random_seed) {
  const Field field;
  const Mesh cage = coarse_cage(field);
  Mesh mesh = refine(cage, smallest_frequency(triangles, cage.triangle_count()));
  const Posture posture(random_seed);
  for (Vec3& p : mesh.positions) {
    p = rounded_to_float(posture.apply(field.pull_to_skin(p, 4)) / full_length);
  }
  return mesh;
}

}  // namespace geolloyd

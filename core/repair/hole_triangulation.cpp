#include "core/repair/hole_triangulation.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "core/mesh/mesh_measure.h"
#include "core/repair/mesh_under_repair.h"

namespace geolloyd {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest_bend = 1.8660254037844386;  // 1 - cos 150 degrees
// Corners that are left for dynamic programming. Where some triangles are blocked, cutting off
// corners soon finds no way, so there are more.
constexpr std::size_t most_for_programming = 48;
constexpr std::size_t most_where_some_are_blocked = 192;

/// 1 - cosine of the angle between two normals; nothing bends against what has no normal.
double bend_between(const Vec3& n, const Vec3& m) {
  const double lengths = norm(n) * norm(m);
  return lengths > 0 ? 1 - dot(n, m) / lengths : 0;
}

struct Cost {
  double bend = 0;
  double area = 0;

  friend bool operator<(const Cost& a, const Cost& b) {
    return std::tie(a.bend, a.area) < std::tie(b.bend, b.area);
  }
};

// A part of the outline that remains: corners by their positions in it, and the normal beyond the
// edge from each to the next one.
struct Rest {
  std::vector<std::uint32_t> corners;
  std::vector<Vec3> normals;
};

class HoleTriangulation {
 public:
  HoleTriangulation(const HoleOutline& outline, const HoleLimits& limits)
      : outline_(outline),
        limits_(limits),
        most_(limits.is_blocked ? most_where_some_are_blocked : most_for_programming) {}

  std::vector<Triangle> run() {
    Rest rest;
    rest.normals = outline_.normals;
    for (std::uint32_t i = 0; i < outline_.corners.size(); ++i) rest.corners.push_back(i);
    if (rest.corners.size() > most_) rest = cut_off_corners();
    if (rest.corners.size() < 3 || rest.corners.size() > most_ || !program(rest)) {
      return {};
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] const Vec3& at(std::uint32_t i) const { return outline_.corners[i]; }
  [[nodiscard]] Vec3 normal(const Triangle& t) const {
    return cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
  }
  [[nodiscard]] bool is_usable(const Triangle& t) const {
    return flatness(at(t[0]), at(t[1]), at(t[2])) >= sliver_flatness;
  }

  [[nodiscard]] bool is_blocked(const Triangle& t) const {
    return limits_.is_blocked && limits_.is_blocked(t);
  }

  // The corner whose neighbours are nearest to each other, again and again; of equals the smallest.
  Rest cut_off_corners() {
    const std::size_t count = outline_.corners.size();
    std::vector<std::uint32_t> next(count);
    std::vector<std::uint32_t> previous(count);
    std::vector<std::uint32_t> version(count, 0);
    std::vector<Vec3> normals = outline_.normals;
    using Candidate = std::tuple<double, std::uint32_t, std::uint32_t>;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
    const auto offer = [&](std::uint32_t i) {
      const Triangle t = {previous[i], i, next[i]};
      ++version[i];
      if (!is_usable(t) || limits_.is_forbidden(t[0], t[2])) return;
      const Vec3 n = normal(t);
      if (bend_between(n, normals[t[0]]) >= largest_bend ||
          bend_between(n, normals[i]) >= largest_bend || is_blocked(t)) {
        return;
      }
      open.emplace(norm(at(t[2]) - at(t[0])), i, version[i]);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
      next[i] = i + 1 < count ? i + 1 : 0;
      previous[i] = i > 0 ? i - 1 : static_cast<std::uint32_t>(count - 1);
    }
    for (std::uint32_t i = 0; i < count; ++i) offer(i);
    std::vector<std::uint8_t> is_cut(count, 0);
    std::size_t left = count;
    while (left > most_ && !open.empty()) {
      const auto [length, i, of_version] = open.top();
      open.pop();
      if (is_cut[i] != 0 || version[i] != of_version) continue;
      const Triangle t = {previous[i], i, next[i]};
      found_.push_back(t);
      is_cut[i] = 1;
      --left;
      next[t[0]] = t[2];
      previous[t[2]] = t[0];
      normals[t[0]] = normal(t);
      offer(t[0]);
      offer(t[2]);
    }
    Rest rest;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_cut[i] != 0) continue;
      rest.corners.push_back(i);
      rest.normals.push_back(normals[i]);
    }
    return rest;
  }

  // Dynamic programming: the best triangles between the corners i to k, for all i < k.
  bool program(const Rest& rest) {
    const std::size_t count = rest.corners.size();
    std::vector<Cost> cost(count * count, {infinite, infinite});
    std::vector<std::size_t> middle(count * count, 0);
    for (std::size_t i = 0; i + 1 < count; ++i) cost[i * count + i + 1] = {0, 0};
    const auto triangle = [&](std::size_t i, std::size_t m, std::size_t k) {
      return Triangle{rest.corners[i], rest.corners[m], rest.corners[k]};
    };
    const auto normal_at = [&](std::size_t i, std::size_t k) {
      return i + 1 == k ? rest.normals[i] : normal(triangle(i, middle[i * count + k], k));
    };
    std::vector<std::uint8_t> is_open(count * count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = i + 2; k < count; ++k) {
        const bool is_whole = i == 0 && k + 1 == count;
        is_open[i * count + k] =
            is_whole || !limits_.is_forbidden(rest.corners[i], rest.corners[k]) ? 1 : 0;
      }
    }
    for (std::size_t width = 2; width < count; ++width) {
      for (std::size_t i = 0; i + width < count; ++i) {
        const std::size_t k = i + width;
        if (is_open[i * count + k] == 0) continue;
        Cost& best = cost[i * count + k];
        for (std::size_t m = i + 1; m < k; ++m) {
          const Cost& left = cost[i * count + m];
          const Cost& right = cost[m * count + k];
          const Triangle t = triangle(i, m, k);
          if (left.bend == infinite || right.bend == infinite || !is_usable(t)) continue;
          const Vec3 n = normal(t);
          double bend = std::max({left.bend, right.bend, bend_between(n, normal_at(i, m)),
                                  bend_between(n, normal_at(m, k))});
          if (width + 1 == count) bend = std::max(bend, bend_between(n, rest.normals.back()));
          const Cost sum = {bend, left.area + right.area + norm(n) / 2};
          if (bend < largest_bend && sum < best && !is_blocked(t)) {
            best = sum;
            middle[i * count + k] = m;
          }
        }
      }
    }
    if (cost[count - 1].bend == infinite) return false;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, count - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (i + 1 == k) continue;
      const std::size_t m = middle[i * count + k];
      found_.push_back(triangle(i, m, k));
      open.emplace_back(i, m);
      open.emplace_back(m, k);
    }
    return true;
  }

  const HoleOutline& outline_;
  const HoleLimits& limits_;
  std::size_t most_;  // corners for dynamic programming
  std::vector<Triangle> found_;
};

}  // namespace

std::vector<Triangle> triangulate_hole(const HoleOutline& outline, const HoleLimits& limits) {
  return HoleTriangulation(outline, limits).run();
}

}  // namespace geolloyd

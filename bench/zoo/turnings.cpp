#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bench/zoo/solids.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd::zoo {
namespace {

Vec3 around_axis(double radius, double turn, double height) {
  const double angle = 2 * std::numbers::pi * turn;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

// Rows of as many vertices as there are sides; a point on the axis is one vertex.
class Turner {
 public:
  explicit Turner(const Turning& turning) : turning_(turning) {
    for (const Point& p : turning.profile) add_row(p);
    const std::size_t rows = turning.profile.size();
    for (std::size_t k = 0; k + (turning.is_ring ? 0 : 1) < rows; ++k) join(k, (k + 1) % rows);
    solid_.parts = {{turning.is_ring ? 0 : 2, 0}};
    for (std::size_t k = 0; k < rows; ++k) add_rim(k);
  }

  Solid take() { return std::move(solid_); }

 private:
  // Where the profile turns by more than 40 degrees.
  void add_rim(std::size_t row) {
    const Polygon& profile = turning_.profile;
    if (is_on_axis(row)) return;
    const Point& a = profile[(row + profile.size() - 1) % profile.size()];
    const Point& b = profile[row];
    const Point& c = profile[(row + 1) % profile.size()];
    const double turn = std::atan2(c.y - b.y, c.x - b.x) - std::atan2(b.y - a.y, b.x - a.x);
    if (std::cos(turn) > sharp_cosine) return;
    const auto begin = solid_.mesh.positions.begin() + first_[row];
    solid_.rims.emplace_back(begin, begin + turning_.sides);
  }

  [[nodiscard]] bool is_on_axis(std::size_t row) const { return turning_.profile[row].x == 0; }
  // Whose middle is not needed.
  [[nodiscard]] bool is_fan_from_corner(std::size_t axis, std::size_t row) const {
    return turning_.from_corner && is_on_axis(axis) &&
           turning_.profile[axis].y == turning_.profile[row].y;
  }

  void add_row(const Point& p) {
    first_.push_back(static_cast<VertexId>(solid_.mesh.vertex_count()));
    const std::size_t row = first_.size() - 1;
    const std::size_t last = turning_.profile.size() - 1;
    if (p.x == 0 && is_fan_from_corner(row, row == 0 ? 1 : last - 1)) return;
    const std::uint32_t count = p.x == 0 ? 1 : turning_.sides;
    for (std::uint32_t i = 0; i < count; ++i) {
      solid_.mesh.positions.push_back(
          around_axis(p.x, static_cast<double>(i) / turning_.sides, p.y));
    }
  }

  [[nodiscard]] VertexId at(std::size_t row, std::uint32_t i) const {
    return first_[row] + (is_on_axis(row) ? 0 : i % turning_.sides);
  }

  void join(std::size_t below, std::size_t above) {
    add_volume(turning_.profile[below], turning_.profile[above]);
    if (is_fan_from_corner(below, above) || is_fan_from_corner(above, below)) {
      const bool is_bottom = is_on_axis(below);
      const std::size_t row = is_bottom ? above : below;
      for (std::uint32_t i = 1; i + 1 < turning_.sides; ++i) {
        const std::uint32_t b = is_bottom ? i + 1 : i;
        const std::uint32_t c = is_bottom ? i : i + 1;
        solid_.mesh.triangles.push_back({at(row, 0), at(row, b), at(row, c)});
      }
      return;
    }
    for (std::uint32_t i = 0; i < turning_.sides; ++i) {
      const VertexId a = at(below, i);
      const VertexId b = at(below, i + 1);
      const VertexId c = at(above, i + 1);
      const VertexId d = at(above, i);
      if (a != b) solid_.mesh.triangles.push_back({a, b, c});
      if (c != d) solid_.mesh.triangles.push_back({a, c, d});
    }
  }

  // Of a frustum of a regular pyramid.
  void add_volume(const Point& a, const Point& b) {
    const double corner = 2 * std::numbers::pi / turning_.sides;
    const double factor = 0.5 * turning_.sides * std::sin(corner);
    solid_.volume += factor * (b.y - a.y) * (a.x * a.x + a.x * b.x + b.x * b.x) / 3;
  }

  const Turning& turning_;
  Solid solid_;
  std::vector<VertexId> first_;  // per row
};

// Rows of a helix, each a step above the last; one turn later a row is that of the next turn.
class Threader {
 public:
  Threader(const Polygon& profile, double pitch, std::uint32_t turns, std::uint32_t sides)
      : profile_(profile),
        pitch_(pitch),
        sides_(sides),
        rows_(static_cast<std::uint32_t>(profile.size()) * turns) {
    first_column_ = static_cast<std::uint32_t>(profile.size());
    add_vertices();
    for (std::uint32_t j = 0; j < rows_; ++j) {
      for (std::uint32_t i = 0; i < sides_; ++i) {
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
    add_end(0, true);
    add_end(rows_, false);
    solid_.volume = enclosed_volume(solid_.mesh);
    solid_.parts = {{2, 0}};
  }

  Solid take() { return std::move(solid_); }

 private:
  void add(VertexId a, VertexId b, VertexId c) { solid_.mesh.triangles.push_back({a, b, c}); }

  // The column at angle 0 goes on for a turn.
  void add_vertices() {
    for (std::uint32_t i = 0; i < sides_; ++i) {
      const std::uint32_t above = i == 0 ? first_column_ : 0;
      first_.push_back(static_cast<VertexId>(solid_.mesh.vertex_count()));
      for (std::uint32_t j = 0; j <= rows_ + above; ++j) {
        const Point& p = profile_[j % profile_.size()];
        const double turn = static_cast<double>(i) / sides_;
        const std::size_t turns = j / profile_.size();
        solid_.mesh.positions.push_back(
            around_axis(p.x, turn, p.y + pitch_ * (static_cast<double>(turns) + turn)));
      }
    }
  }

  [[nodiscard]] VertexId at(std::uint32_t i, std::uint32_t j) const {
    return i == sides_ ? first_[0] + j + first_column_ : first_[i] + j;
  }

  // A fan from the axis over the helix, and down the step.
  void add_end(std::uint32_t row, bool is_bottom) {
    const double height = pitch_ * (row / static_cast<double>(profile_.size()) + 0.5);
    const auto middle = static_cast<VertexId>(solid_.mesh.vertex_count());
    solid_.mesh.positions.emplace_back(0, 0, height);
    const auto fan = [&](VertexId from, VertexId to) {
      add(middle, is_bottom ? to : from, is_bottom ? from : to);
    };
    for (std::uint32_t i = 0; i < sides_; ++i) fan(at(i, row), at(i + 1, row));
    for (std::uint32_t j = row + first_column_; j > row; --j) fan(at(0, j), at(0, j - 1));
  }

  const Polygon& profile_;
  double pitch_;
  std::uint32_t sides_;
  std::uint32_t rows_;
  std::uint32_t first_column_ = 0;  // rows of a turn
  Solid solid_;
  std::vector<VertexId> first_;  // per column
};

}  // namespace

Solid turned(const Turning& turning) {
  return Turner(turning).take();
}

Solid threaded(const Polygon& profile, double pitch, std::uint32_t turns, std::uint32_t sides) {
  return Threader(profile, pitch, turns, sides).take();
}

Solid swept(const std::function<Stand(double share)>& curve, std::uint32_t steps,
            const Polygon& profile, bool is_closed) {
  Solid solid;
  const auto corners = static_cast<VertexId>(profile.size());
  for (std::uint32_t k = 0; k < steps + (is_closed ? 0 : 1); ++k) {
    const Stand stand = curve(static_cast<double>(k) / steps);
    for (const Point& p : profile) {
      solid.mesh.positions.emplace_back(stand.middle + p.x * stand.x + p.y * stand.y);
    }
  }
  const auto count = static_cast<VertexId>(solid.mesh.vertex_count());
  const auto add = [&](VertexId a, VertexId b, VertexId c) {
    solid.mesh.triangles.push_back({a % count, b % count, c % count});
  };
  for (VertexId k = 0; k < steps; ++k) {
    for (VertexId i = 0; i < corners; ++i) {
      const VertexId a = k * corners + i;
      const VertexId b = k * corners + (i + 1) % corners;
      add(a, b, b + corners);
      add(a, b + corners, a + corners);
    }
  }
  for (VertexId i = 1; !is_closed && i + 1 < corners; ++i) {
    add(0, i + 1, i);
    add(count - corners, count - corners + i, count - corners + i + 1);
  }
  solid.volume = enclosed_volume(solid.mesh);
  solid.parts = {{is_closed ? 0 : 2, 0}};
  return solid;
}

Solid together(const std::vector<Solid>& solids) {
  Solid all;
  for (const Solid& one : solids) {
    const auto first = static_cast<VertexId>(all.mesh.vertex_count());
    const auto& positions = one.mesh.positions;
    all.mesh.positions.insert(all.mesh.positions.end(), positions.begin(), positions.end());
    for (const auto& [a, b, c] : one.mesh.triangles) {
      all.mesh.triangles.push_back({a + first, b + first, c + first});
    }
    all.volume += one.volume;
    all.parts.insert(all.parts.end(), one.parts.begin(), one.parts.end());
    all.rims.insert(all.rims.end(), one.rims.begin(), one.rims.end());
  }
  std::sort(all.parts.begin(), all.parts.end());
  return all;
}

Solid moved(Solid solid, const Vec3& by) {
  for (Vec3& p : solid.mesh.positions) p += by;
  for (auto& rim : solid.rims) {
    for (Vec3& p : rim) p += by;
  }
  return solid;
}

Solid with_hollow(Solid hull, const Solid& hollow) {
  Solid inner = hollow;
  for (Triangle& t : inner.mesh.triangles) std::swap(t[1], t[2]);
  inner.volume = -inner.volume;
  return together({std::move(hull), std::move(inner)});
}

}  // namespace geolloyd::zoo

#include "core/formats/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/properties/properties.h"

namespace geolloyd {
namespace {

using Point = std::array<double, 2>;

// Twice the signed area of a triangle.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Cuts the ears off a polygon whose corners are counter-clockwise.
class EarClipping {
 public:
  explicit EarClipping(std::vector<Point> corners)
      : corner_(std::move(corners)), before_(corner_.size()), after_(corner_.size()) {
    for (std::size_t i = 0; i < corner_.size(); ++i) {
      after_[i] = i + 1 < corner_.size() ? i + 1 : 0;
      before_[after_[i]] = i;
    }
  }

  // Triangles of corners; nothing where there is no ear, or looking for ears takes too long.
  std::optional<std::vector<std::array<std::size_t, 3>>> run() {
    std::vector<std::array<std::size_t, 3>> triangles;
    std::size_t left = corner_.size();
    std::size_t since_last_ear = 0;
    std::size_t attempts = 4 * left;
    triangles.reserve(left - 2);
    for (std::size_t i = 0; left > 2;) {
      // In a second round corners in a straight line will do.
      if (attempts-- == 0 || since_last_ear == 2 * left) return std::nullopt;
      const bool may_be_straight = since_last_ear >= left;
      ++since_last_ear;
      if (!is_ear(i, may_be_straight)) {
        i = after_[i];
        continue;
      }
      triangles.push_back({before_[i], i, after_[i]});
      after_[before_[i]] = after_[i];
      before_[after_[i]] = before_[i];
      --left;
      since_last_ear = 0;
      i = before_[i];  // mostly the next ear: a spiral is unwound from its end
    }
    return triangles;
  }

 private:
  [[nodiscard]] bool is_ear(std::size_t i, bool may_be_straight) const {
    const Point& a = corner_[before_[i]];
    const Point& b = corner_[i];
    const Point& c = corner_[after_[i]];
    const double area = turn(a, b, c);
    if (!(may_be_straight ? area >= 0 : area > 0)) return false;
    for (std::size_t j = after_[after_[i]]; j != before_[i]; j = after_[j]) {
      const Point& p = corner_[j];
      if (p == a || p == b || p == c) continue;  // as where a slit leads to a hole
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::vector<Point> corner_;
  std::vector<std::size_t> before_;
  std::vector<std::size_t> after_;
};

class FannedPolygon {
 public:
  FannedPolygon(Mesh& mesh, const PolygonFan& fan) : mesh_(mesh), fan_(fan) {}

  void triangulate() {
    constexpr std::uint32_t most_triangles_of_a_polygon = 1022;
    if (fan_.count > most_triangles_of_a_polygon || !find_normal() || is_fan_right() ||
        !is_flat()) {
      return;
    }
    const std::vector<VertexId> corners = corner_ids();
    const auto ears = EarClipping(project(corners)).run();
    if (!ears) return;
    for (std::size_t i = 0; i < ears->size(); ++i) {
      const auto& [a, b, c] = (*ears)[i];
      mesh_.triangles[fan_.first + i] = {corners[a], corners[b], corners[c]};
    }
  }

 private:
  [[nodiscard]] const Triangle& triangle(std::size_t i) const {
    return mesh_.triangles[fan_.first + i];
  }
  [[nodiscard]] const Vec3& origin() const { return mesh_.positions[triangle(0)[0]]; }

  [[nodiscard]] Vec3 normal_of(std::size_t i) const {
    const auto& [a, b, c] = triangle(i);
    return cross(mesh_.positions[b] - origin(), mesh_.positions[c] - origin());
  }

  // Of any length; false where there is none.
  bool find_normal() {
    for (std::size_t i = 0; i < fan_.count; ++i) normal_ += normal_of(i);
    const double largest =
        std::max({std::abs(normal_.x()), std::abs(normal_.y()), std::abs(normal_.z())});
    if (!(largest > 0) || !std::isfinite(largest)) return false;
    normal_ /= largest;
    return true;
  }

  [[nodiscard]] bool is_fan_right() const {
    for (std::size_t i = 0; i < fan_.count; ++i) {
      if (dot(normal_of(i), normal_) < 0) return false;
    }
    return true;
  }

  // No corner is farther from the plane than a hundredth of the polygon's extent.
  [[nodiscard]] bool is_flat() const {
    double extent = 0;
    double height = 0;
    for (const VertexId v : corner_ids()) {
      const Vec3 away = mesh_.positions[v] - origin();
      const double up = dot(away, normal_);
      extent = std::max(extent, dot(away, away));
      height = std::max(height, up * up);
    }
    return height <= 1e-4 * extent * dot(normal_, normal_);
  }

  [[nodiscard]] std::vector<VertexId> corner_ids() const {
    std::vector<VertexId> corners = {triangle(0)[0], triangle(0)[1]};
    for (std::size_t i = 0; i < fan_.count; ++i) corners.push_back(triangle(i)[2]);
    return corners;
  }

  // Along the axis that the normal is nearest to, so that the corners are counter-clockwise.
  [[nodiscard]] std::vector<Point> project(const std::vector<VertexId>& corners) const {
    Eigen::Index axis = 0;
    for (Eigen::Index i = 1; i < 3; ++i) {
      if (std::abs(normal_[i]) > std::abs(normal_[axis])) axis = i;
    }
    Eigen::Index u = (axis + 1) % 3;
    Eigen::Index v = (axis + 2) % 3;
    if (normal_[axis] < 0) std::swap(u, v);
    std::vector<Point> points;
    points.reserve(corners.size());
    for (const VertexId corner : corners) {
      points.push_back({mesh_.positions[corner][u], mesh_.positions[corner][v]});
    }
    return points;
  }

  Mesh& mesh_;
  const PolygonFan& fan_;
  Vec3 normal_ = Vec3::Zero();
};

// The face of each triangle, in order: fans come where polygons were.
template <class Visit>
void for_each_triangle(const std::vector<PolygonFan>& fans, std::size_t triangle_count,
                       Visit&& visit) {
  std::size_t face = 0;
  std::size_t triangle = 0;
  const auto visit_triangles_to = [&](std::size_t end) {
    for (; triangle < end; ++triangle) visit(face++);
  };
  for (const PolygonFan& fan : fans) {
    visit_triangles_to(fan.first);
    for (; triangle < fan.first + fan.count; ++triangle) visit(face);
    ++face;
  }
  visit_triangles_to(triangle_count);
}

}  // namespace

void triangulate_concave(Mesh& mesh, const std::vector<PolygonFan>& fans) {
  for (const PolygonFan& fan : fans) FannedPolygon(mesh, fan).triangulate();
}

void spread_over_triangles(const std::vector<PolygonFan>& fans, std::size_t triangle_count,
                           std::size_t most_bytes, Properties& properties) {
  std::vector<Property>& columns = properties.of_triangles;
  if (fans.empty() || columns.empty()) return;
  if (columns.size() * sizeof(double) > most_bytes / triangle_count) {
    properties.left_out.push_back(list_names(columns) +
                                  " of faces: they would outgrow the file, as polygons of so many "
                                  "corners become so many triangles");
    columns.clear();
    return;
  }
  for (Property& column : columns) {
    std::visit(
        [&](auto& of_face) {
          std::remove_cvref_t<decltype(of_face)> of_triangle;
          of_triangle.reserve(triangle_count);
          for_each_triangle(fans, triangle_count,
                            [&](std::size_t face) { of_triangle.push_back(of_face[face]); });
          of_face = std::move(of_triangle);
        },
        column.values);
  }
}

}  // namespace geolloyd

#include "core/graph/arc_length.h"

#include <algorithm>
#include <cmath>

namespace geolloyd {
namespace {

double combine(double x, double y, double z, Norm norm_kind) {
  switch (norm_kind) {
    case Norm::manhattan:
      return std::abs(x) + std::abs(y) + std::abs(z);
    case Norm::linf:
      return std::max({std::abs(x), std::abs(y), std::abs(z)});
    case Norm::geodesic:
      break;
  }
  return norm({x, y, z});
}

// True where the straight line from (along_a, above) to (along_b, -below) crosses the edge, which
// lies from 0 to `length` on the axis. Multiplied out, so that no height is too small.
bool crosses_edge(double along_a, double above, double along_b, double below, double length) {
  const double height = above + below;
  if (height == 0) {
    return std::max(along_a, along_b) >= 0 && std::min(along_a, along_b) <= length;
  }
  const double crossing = along_a * below + along_b * above;
  return crossing >= 0 && crossing <= length * height;
}

}  // namespace

double measure(const Vec3& d, Norm norm_kind) {
  return combine(d.x(), d.y(), d.z(), norm_kind);
}

double measure(const Vec3& d, const TangentSpace& space, Norm norm_kind) {
  return combine(space.tangent_magnitude * dot(space.tangent, d),
                 space.bitangent_magnitude * dot(space.bitangent, d), 0, norm_kind);
}

double unfolded_distance(const Vec3& a, const Vec3& b, const Vec3& e0, const Vec3& e1) {
  const double length = norm(e1 - e0);
  const double around = std::min(norm(a - e0) + norm(b - e0), norm(a - e1) + norm(b - e1));
  if (length == 0) return around;

  const Vec3 axis = (e1 - e0) / length;
  const double along_a = dot(a - e0, axis);
  const double along_b = dot(b - e0, axis);
  const double above = norm(cross(a - e0, axis));
  const double below = norm(cross(b - e0, axis));
  if (!crosses_edge(along_a, above, along_b, below, length)) return around;
  const double step = along_a - along_b;
  const double rise = above + below;
  return std::sqrt(step * step + rise * rise);
}

}  // namespace geolloyd

#include "core/surface/result/subresolution_holes.h"

#include <algorithm>
#include <limits>

namespace geolloyd {
namespace {

class SubresolutionHoleOpener {
 public:
  SubresolutionHoleOpener(const DividedSurface& surface, const SurfaceSites& sites,
                          const std::vector<Triangle>& triangles)
      : surface_(surface),
        sites_(sites),
        triangles_(triangles),
        is_on_curve_(sites.size(), 0),
        is_taken_out_(triangles.size(), 0) {
    std::fill_n(is_on_curve_.begin(), sites.on_curves, std::uint8_t{1});
  }

  bool open(const std::vector<VertexId>& loop) {
    const std::size_t t = nearest_triangle(loop.front());
    if (t == triangles_.size()) return false;
    is_taken_out_[t] = 1;
    for (const RegionId r : triangles_[t]) is_on_curve_[r] = 1;
    return true;
  }

  [[nodiscard]] std::vector<Triangle> triangles_left() const {
    std::vector<Triangle> left;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (is_taken_out_[t] == 0) left.push_back(triangles_[t]);
    }
    return left;
  }

 private:
  [[nodiscard]] std::size_t nearest_triangle(VertexId hole) const {
    std::size_t nearest = triangles_.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      if (is_on_curve_[a] != 0 || is_on_curve_[b] != 0 || is_on_curve_[c] != 0) continue;
      if (sites_.patch[a] != surface_.patches.of_vertex[hole]) continue;
      const std::vector<Vec3>& p = sites_.positions;
      const Vec3 away = (p[a] + p[b] + p[c]) / 3 - surface_.input.fine.positions[hole];
      if (dot(away, away) < least) {
        least = dot(away, away);
        nearest = t;
      }
    }
    return nearest;
  }

  const DividedSurface& surface_;
  const SurfaceSites& sites_;
  const std::vector<Triangle>& triangles_;
  std::vector<std::uint8_t> is_on_curve_;  // per site
  std::vector<std::uint8_t> is_taken_out_;
};

}  // namespace

bool open_subresolution_holes(const DividedSurface& surface, const SurfaceSites& sites,
                              std::vector<Triangle>& triangles) {
  SubresolutionHoleOpener opener(surface, sites, triangles);
  for (const std::vector<VertexId>& loop : surface.curves.subresolution_holes) {
    if (!opener.open(loop)) return false;
  }
  triangles = opener.triangles_left();
  return true;
}

}  // namespace geolloyd

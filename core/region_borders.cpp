#include "core/region_borders.h"

#include <algorithm>
#include <numbers>

namespace geolloyd {
namespace {

class Borders {
 public:
  Borders(const Mesh& mesh, const RegionSurface& surface)
      : mesh_(mesh), surface_(surface), length_(surface.region_count, 0) {}

  std::vector<double> run() {
    for (const Triangle& t : surface_.triangles) cross_triangle(t);
    for (const OddEdge& edge : surface_.odd_edges) {
      if (edge.triangles == 1) follow_boundary(edge.ends[0], edge.ends[1]);
    }
    return std::move(length_);
  }

 private:
  [[nodiscard]] RegionId region(PointId p) const { return surface_.region[p]; }

  // Where an edge between two regions is as far from one seed as from the other.
  [[nodiscard]] Vec3 cut(PointId a, PointId b) const {
    const Vec3 from = surface_.position(mesh_, a);
    const Vec3 way = surface_.position(mesh_, b) - from;
    const double length = norm(way);
    if (!(length > 0)) return from;
    const double share = 0.5 + 0.5 * (surface_.distance[b] - surface_.distance[a]) / length;
    return from + std::clamp(share, 0.0, 1.0) * way;
  }

  void add(RegionId r, double length) {
    if (r != no_id) length_[r] += length;
  }

  void cross_triangle(const Triangle& t) {
    const std::array<RegionId, 3> r = {region(t[0]), region(t[1]), region(t[2])};
    if (r[0] == r[1] && r[1] == r[2]) return;
    if (r[0] != r[1] && r[1] != r[2] && r[2] != r[0]) {
      const std::array<Vec3, 3> cuts = {cut(t[0], t[1]), cut(t[1], t[2]), cut(t[2], t[0])};
      const Vec3 middle = (cuts[0] + cuts[1] + cuts[2]) / 3;
      for (std::size_t c = 0; c < 3; ++c) {
        add(r[c], norm(cuts[c] - middle));
        add(r[(c + 1) % 3], norm(cuts[c] - middle));
      }
      return;
    }
    for (std::size_t c = 0; c < 3; ++c) {  // the corner that is alone
      const PointId left = t[(c + 1) % 3];
      const PointId right = t[(c + 2) % 3];
      if (region(left) != region(right)) continue;
      const double length = norm(cut(t[c], left) - cut(t[c], right));
      add(r[c], length);
      add(region(left), length);
    }
  }

  void follow_boundary(PointId a, PointId b) {
    if (region(a) == region(b)) {
      add(region(a), norm(surface_.position(mesh_, a) - surface_.position(mesh_, b)));
    } else {
      const Vec3 middle = cut(a, b);
      add(region(a), norm(surface_.position(mesh_, a) - middle));
      add(region(b), norm(surface_.position(mesh_, b) - middle));
    }
  }

  const Mesh& mesh_;
  const RegionSurface& surface_;
  std::vector<double> length_;
};

}  // namespace

std::vector<double> border_lengths(const Mesh& mesh, const RegionSurface& surface) {
  return Borders(mesh, surface).run();
}

double isoperimetric_ratio(double area, double perimeter) {
  return perimeter > 0 ? 4 * std::numbers::pi * area / (perimeter * perimeter) : 0;
}

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <span>

#include "core/surface/cells/triangle_measure.h"

namespace geolloyd {

/// A few different sites.
class FewSites {
 public:
  void add(RegionId r) {
    if (r == no_id || has(r)) return;
    site_[size_++] = r;
  }
  [[nodiscard]] bool has(RegionId r) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (site_[i] == r) return true;
    }
    return false;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] RegionId operator[](std::size_t i) const { return site_[i]; }

 private:
  RegionId site_[6] = {};
  std::size_t size_ = 0;
};

/// A point of a triangle a, b, c: a + u (b - a) + v (c - a).
struct InTriangle {
  double u;
  double v;
};

/// A triangle with the labels of its corners, which are not all the same. Corners and sites are as
/// its measure maps them.
template <class Measure>
struct CutTriangle {
  Measure measure;
  std::span<const Vec3> sites;
  Vec3 corner[3];
  double mass;
  RegionId at[3] = {};
  FewSites others;  ///< labels of the vertices beyond its edges that are no corner's

  CutTriangle(const FineMesh& mesh, TriangleId t, std::span<const RegionId> labels,
              std::span<const Vec3> all_sites)
      : measure(mesh, t), sites(all_sites), mass(mesh.mass(t)) {
    const Triangle& corners = mesh.triangles[t];
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = measure(mesh.positions[corners[c]]);
      at[c] = labels[corners[c]];
    }
    for (const VertexId v : mesh.across_open[t]) {
      if (v == no_id) continue;
      const RegionId r = labels[v];
      if (r != at[0] && r != at[1] && r != at[2]) others.add(r);
    }
  }

  [[nodiscard]] decltype(auto) site(RegionId r) const { return measure(sites[r]); }
  [[nodiscard]] Vec3 point(const InTriangle& p) const {
    return corner[0] + p.u * (corner[1] - corner[0]) + p.v * (corner[2] - corner[0]);
  }
  /// Whether no other site is nearer to one of these points than the point's owner.
  template <std::size_t count>
  [[nodiscard]] bool others_own_none(const Vec3 (&point)[count],
                                     const RegionId (&owner)[count]) const {
    for (std::size_t o = 0; o < others.size(); ++o) {
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 away = point[i] - site(owner[i]);
        const Vec3 other = point[i] - site(others[o]);
        if (!(dot(away, away) <= dot(other, other))) return false;
      }
    }
    return true;
  }
};

}  // namespace geolloyd

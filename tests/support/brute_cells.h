#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/surface/cells/moments.h"
#include "core/surface/substrate/fine_mesh.h"

/// Cells of sites by their definition: each triangle is clipped in space by the bisector plane of
/// each pair of sites, without any of the means of core/surface. For few triangles and sites.
namespace geolloyd::brute {

/// The part of a flat polygon that is no farther from `site` than from `other`.
inline std::vector<Vec3> nearer_part(const std::vector<Vec3>& polygon, const Vec3& site,
                                     const Vec3& other) {
  const Vec3 normal = other - site;
  const Vec3 middle = (site + other) / 2;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& p = polygon[i];
    const Vec3& q = polygon[(i + 1) % polygon.size()];
    const double at_p = dot(p - middle, normal);
    const double at_q = dot(q - middle, normal);
    if (at_p <= 0) kept.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  return kept;
}

/// Area, and integrals of x and |x|^2, by the midpoints of edges: exact for squares.
inline PieceMoments moments_of_polygon(const std::vector<Vec3>& polygon) {
  PieceMoments sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec3& a = polygon[0];
    const Vec3& b = polygon[i - 1];
    const Vec3& c = polygon[i];
    const double area = norm(cross(b - a, c - a)) / 2;
    sum.area += area;
    for (const Vec3& m : {Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)}) {
      sum.first += m * (area / 3);
      sum.second += dot(m, m) * (area / 3);
    }
  }
  return sum;
}

/// Integral of |x - site|^2.
inline double energy(const PieceMoments& m, const Vec3& site) {
  return m.second - 2 * dot(site, m.first) + dot(site, site) * m.area;
}

/// Everywhere on a triangle.
inline bool are_equally_far(const std::vector<Vec3>& triangle, const Vec3& a, const Vec3& b) {
  return std::all_of(triangle.begin(), triangle.end(),
                     [&](const Vec3& p) { return dot(p - a, p - a) == dot(p - b, p - b); });
}

/// The part of a triangle that is nearest to `sites[candidates[i]]`, for each i. Sites that are
/// equally far everywhere have the same part.
inline std::vector<std::vector<Vec3>> pieces_of(const std::vector<Vec3>& triangle,
                                                std::span<const Vec3> sites,
                                                std::span<const RegionId> candidates) {
  std::vector<std::vector<Vec3>> pieces;
  for (const RegionId r : candidates) {
    std::vector<Vec3> piece = triangle;
    for (const RegionId other : candidates) {
      if (piece.empty() || are_equally_far(triangle, sites[r], sites[other])) continue;
      piece = nearer_part(piece, sites[r], sites[other]);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Of each site's cell among all sites.
inline std::vector<PieceMoments> cells_of(const FineMesh& mesh, std::span<const Vec3> sites) {
  std::vector<RegionId> all;
  for (RegionId r = 0; r < sites.size(); ++r) all.push_back(r);
  std::vector<PieceMoments> cells(sites.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto pieces =
        pieces_of({mesh.positions[a], mesh.positions[b], mesh.positions[c]}, sites, all);
    for (const RegionId r : all) {
      const PieceMoments piece = moments_of_polygon(pieces[r]);
      cells[r].area += piece.area;
      cells[r].first += piece.first;
      cells[r].second += piece.second;
    }
  }
  return cells;
}

}  // namespace geolloyd::brute

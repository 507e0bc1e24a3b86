#pragma once

#include <cstddef>
#include <span>

#include "core/surface/cells/cell_cuts.h"

namespace geolloyd {

/// The site that has of a triangle what other sites do not cut off: that of two corners or more,
/// else that of the first corner with a label, or none.
inline RegionId main_site(const FineMesh& mesh, TriangleId t, std::span<const RegionId> labels) {
  const auto& [a, b, c] = mesh.triangles[t];
  if (labels[b] == labels[c] && labels[b] != no_id) return labels[b];
  if (labels[a] != no_id) return labels[a];
  return labels[b] != no_id ? labels[b] : labels[c];
}

/// Calls emit(site, moments) for each piece that a site other than the main one has in a triangle.
///
/// A triangle whose corners have one label lies wholly in that site's cell, because Euclidean cells
/// are convex. Other triangles are cut by the bisector planes of the candidates: the labels of its
/// corners, and of the vertices beyond its edges. The main site has the rest, so that shares sum to
/// the moments of the triangle exactly.
template <class Measure = EvenMeasure, class Emit>
void for_each_piece(const FineMesh& mesh, const MomentUnit& unit, TriangleId t,
                    std::span<const RegionId> labels, std::span<const Vec3> sites, Emit&& emit) {
  const auto& [a, b, c] = mesh.triangles[t];
  if (labels[a] == labels[b] && labels[b] == labels[c]) return;
  const CutTriangle<Measure> triangle(mesh, t, labels, sites);
  const auto& at = triangle.at;
  if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) {
    const std::size_t odd = at[1] == at[2] ? 0 : at[0] == at[2] ? 1 : 2;
    if (cut_corner_off(triangle, odd, unit, emit)) return;
  } else if (cut_about_point(triangle, unit, emit)) {
    return;
  }
  cut_in_pieces(triangle, main_site(mesh, t, labels), unit, emit);
}

}  // namespace geolloyd

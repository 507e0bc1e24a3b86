#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// The label that a vertex takes in a sweep (surface_engine.h).
struct NearestLabel {
  RegionId label;
  bool is_inner = true;  ///< no neighbour has a label that differs from the vertex's, but for none
  RegionId rival = no_id;  ///< the only other label, if the neighbours have one other
  double square_own = 0;   ///< the square of the distance to the own site; without one, infinite
  double square_rival = 0;
};

inline NearestLabel nearest_label(const FineMesh& mesh, std::span<const RegionId> labels,
                                  std::span<const Vec3> sites, VertexId v) {
  const auto square_distance = [&](RegionId r) {
    return mesh.square_at(v, mesh.positions[v] - sites[r]);
  };
  const RegionId own = labels[v];
  NearestLabel best{own};
  RegionId last = no_id;
  double least = 0;
  for (const VertexId u : mesh.neighbours(v)) {
    const RegionId r = labels[u];
    if (r == own || r == last || r == no_id) continue;
    last = r;
    const double distance = square_distance(r);
    if (best.is_inner) {
      best.is_inner = false;
      best.square_own =
          own == no_id ? std::numeric_limits<double>::infinity() : square_distance(own);
      least = best.square_own;
      best.rival = r;
      best.square_rival = distance;
    } else if (r != best.rival) {
      best.rival = no_id;
    }
    if (distance < least || (distance == least && r < best.label)) {
      least = distance;
      best.label = r;
    }
  }
  return best;
}

}  // namespace geolloyd

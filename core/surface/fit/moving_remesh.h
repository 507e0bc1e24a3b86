#pragma once

#include <vector>

#include "core/mesh/connectivity.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// A remesh in the unit frame, whose vertices are being moved.
struct MovingRemesh : Mesh {
  std::vector<Vec3> start;            ///< per vertex: where it was at first
  Bucketed<TriangleId> triangles_at;  ///< per vertex, ascending

  MovingRemesh() = default;
  MovingRemesh(const SurfaceFrame& frame, const Mesh& remesh, Executor& executor);

  [[nodiscard]] Vec3 move_of(std::size_t v) const { return positions[v] - start[v]; }
  [[nodiscard]] Vec3 normal_of(TriangleId t) const {
    const auto& [a, b, c] = triangles[t];
    return normalized(cross(positions[b] - positions[a], positions[c] - positions[a]));
  }
};

/// Per vertex, weighted by area.
std::vector<Vec3> normals_at_vertices(const Mesh& mesh);

}  // namespace geolloyd

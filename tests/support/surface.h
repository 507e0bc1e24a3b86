#pragma once

#include <algorithm>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// Beside each other; the ids of `more` follow those of `mesh`.
inline void add_mesh(Mesh& mesh, const Mesh& more, const Vec3& shift, double scale = 1) {
  const auto first = static_cast<VertexId>(mesh.vertex_count());
  for (const Vec3& p : more.positions) mesh.positions.emplace_back(p * scale + shift);
  for (const auto& [a, b, c] : more.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
}

/// No edge is split without `longest_edge`; where it is given, ten million vertices are enough.
inline SurfaceInput surface_input_of(const Mesh& mesh, double longest_edge = 0,
                                     Executor& executor = sequential()) {
  const std::vector<TriangleId> duplicates = find_edges(mesh).duplicates;
  SurfaceInputOptions options;
  options.duplicates = duplicates;
  options.longest_edge = longest_edge;
  options.vertex_limit = 10'000'000;
  return make_surface_input(mesh, options, executor);
}

inline Mesh mesh_of(const FineMesh& fine) {
  return {fine.positions, fine.triangles};
}

/// In a cube about the origin.
inline Vec3 random_point(std::uint64_t random_seed, std::uint64_t n, double half_width = 1) {
  const auto draw = [&](std::uint64_t i) {
    return half_width * (2 * random_unit(random_seed, 3 * n + i) - 1);
  };
  return {draw(0), draw(1), draw(2)};
}

/// Sites with labels to begin with: each site is at a vertex that has its label, others have none.
struct SitedMesh {
  std::vector<Vec3> sites;
  std::vector<RegionId> labels;
  std::vector<std::uint8_t> is_fixed;  ///< none
};

inline SitedMesh put_sites(const FineMesh& mesh, const std::vector<VertexId>& at) {
  SitedMesh sited{{},
                  std::vector<RegionId>(mesh.vertex_count(), no_id),
                  std::vector<std::uint8_t>(mesh.vertex_count(), 0)};
  for (const VertexId v : at) {
    sited.labels[v] = static_cast<RegionId>(sited.sites.size());
    sited.sites.push_back(mesh.positions[v]);
  }
  return sited;
}

/// Evenly in the order of the vertices, so that parts with many of them have sites.
inline SitedMesh spread_sites(const FineMesh& mesh, std::size_t count) {
  std::vector<VertexId> at;
  for (std::size_t i = 0; i < count; ++i) {
    at.push_back(static_cast<VertexId>((2 * i + 1) * mesh.vertex_count() / (2 * count)));
  }
  return put_sites(mesh, at);
}

}  // namespace geolloyd

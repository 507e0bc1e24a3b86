#include "core/repair/mesh_under_repair.h"

#include "core/mesh/mesh_measure.h"
#include "core/seams/stitching.h"

namespace geolloyd {

bool is_sliver(const Mesh& mesh, const Triangle& t) {
  return flatness(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]) <
         sliver_flatness;
}

void remove_triangles(MeshUnderRepair& state, const std::vector<std::uint8_t>& is_removed) {
  std::vector<Triangle>& triangles = state.mesh.triangles;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (is_removed[t] != 0) continue;
    triangles[kept] = triangles[t];
    state.triangle_origin[kept++] = state.triangle_origin[t];
  }
  triangles.resize(kept);
  state.triangle_origin.resize(kept);
}

void remove_unused_vertices(MeshUnderRepair& state) {
  const std::vector<std::uint8_t> is_used = referenced_vertices(state.mesh);
  std::vector<VertexId> name(state.mesh.vertex_count(), no_id);
  VertexId kept = 0;
  for (VertexId v = 0; v < name.size(); ++v) {
    if (is_used[v] == 0) continue;
    state.mesh.positions[kept] = state.mesh.positions[v];
    state.vertex_origin[kept] = state.vertex_origin[v];
    name[v] = kept++;
  }
  state.mesh.positions.resize(kept);
  state.vertex_origin.resize(kept);
  rename_vertices(state.mesh, name);
}

}  // namespace geolloyd

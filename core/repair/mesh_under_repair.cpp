#include "core/repair/mesh_under_repair.h"

#include <algorithm>
#include <numeric>

#include "core/base/disjoint_sets.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {

bool is_sliver(const Mesh& mesh, const Triangle& t) {
  return flatness(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]) <
         sliver_flatness;
}

std::vector<VertexId> places_of(const Mesh& mesh) {
  const std::vector<Vec3>& p = mesh.positions;
  std::vector<VertexId> order(p.size());
  std::iota(order.begin(), order.end(), VertexId{0});
  std::sort(order.begin(), order.end(), [&](VertexId a, VertexId b) {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[a][axis] != p[b][axis]) return p[a][axis] < p[b][axis];
    }
    return a < b;
  });
  std::vector<VertexId> place(p.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && p[order[i]] == p[order[i - 1]];
    place[order[i]] = is_same ? place[order[i - 1]] : order[i];
  }
  return place;
}

std::vector<VertexId> components_of(const Mesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  std::vector<VertexId> component(mesh.vertex_count());
  for (VertexId v = 0; v < component.size(); ++v) component[v] = sets.find(v);
  return component;
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

void rename_vertices(Mesh& mesh, const std::vector<VertexId>& name) {
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = name[v];
  }
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

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/graph/components.h"
#include "core/lloyd/reference_engine.h"
#include "core/mesh/mesh_topology.h"
#include "core/regions/dual_places.h"
#include "core/regions/dual_repair.h"
#include "core/seeds/seeds.h"
#include "tests/support/topology.h"

namespace geolloyd {

/// A mesh with its graph, and what becomes of seeds on it.
struct Ground {
  Ground(Mesh a_mesh, GraphKind kind)
      : mesh(std::move(a_mesh)),
        edges(find_edges(mesh)),
        mesh_graph(make_mesh_graph(mesh, edges, {kind, Norm::geodesic, {}})),
        engine(make_reference_engine(mesh_graph.graph)) {}

  [[nodiscard]] std::vector<NodeId> choose(std::size_t count, std::uint64_t random_seed = 1) const {
    return choose_seeds(mesh_graph.graph, connected_components(mesh_graph.graph),
                        SeedInit::random_area, count, random_seed);
  }

  DualisedSeeds dualise(const std::vector<NodeId>& seeds) {
    return geolloyd::dualise({mesh, edges, mesh_graph}, partition_of(*engine, seeds), seeds);
  }

  DualisedSeeds repair(const std::vector<NodeId>& seeds, bool keeps_going = true) {
    return repair_dual({mesh, edges, mesh_graph}, *engine, dualise(seeds),
                       [keeps_going] { return keeps_going; });
  }

  [[nodiscard]] Mesh remesh(const DualisedSeeds& dualised) const {
    std::vector<Vec3> sites;
    for (const NodeId s : dualised.seeds) sites.push_back(mesh_graph.position[s]);
    return {place_dual(mesh, dualised.surface, dualised.dual, sites), dualised.dual.triangles};
  }

  Mesh mesh;
  MeshEdges edges;
  MeshGraph mesh_graph;
  std::unique_ptr<Engine> engine;
};

/// All vertices in use, and the surface over again. Orientation is kept where there is one.
inline void expect_same_topology(const Mesh& remesh, const Mesh& mesh) {
  const MeshTopology topology = topology_of(remesh);
  const MeshTopology wanted = topology_of(mesh);
  EXPECT_EQ(topology.parts, wanted.parts);
  EXPECT_EQ(topology.non_manifold_edges, wanted.non_manifold_edges);
  EXPECT_EQ(topology.non_manifold_vertices, wanted.non_manifold_vertices);
  if (wanted.inconsistent_edges == 0) {
    EXPECT_EQ(topology.inconsistent_edges, 0U);
  }
  std::vector<bool> is_used(remesh.vertex_count(), false);
  for (const Triangle& t : remesh.triangles) {
    for (const VertexId v : t) is_used[v] = true;
  }
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0);
}

inline Mesh side_by_side(const Mesh& a, const Mesh& b) {
  Mesh both = a;
  const auto shift = static_cast<VertexId>(a.vertex_count());
  for (const Vec3& p : b.positions) both.positions.push_back(p + Vec3(4, 0, 0));
  for (const Triangle& t : b.triangles) {
    both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return both;
}

}  // namespace geolloyd

#include "core/seeds/seed_places.h"

#include <limits>
#include <unordered_set>

#include "core/mesh/mesh_measure.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// Nodes that are taken one after the other.
class FreeNodes {
 public:
  FreeNodes(const Mesh& mesh, const MeshGraph& mesh_graph) : mesh_(mesh), mesh_graph_(mesh_graph) {}

  // The node nearest to a place, or the first free one of `most` around it; no_id if there is none.
  NodeId take_near(const SeedPlace& place, std::size_t most) {
    NodeId seed = nearest_free(place);
    if (seed == no_id) seed = first_free_around(nodes_of(place.triangle).front(), most);
    if (seed != no_id) taken_.insert(seed);
    return seed;
  }

 private:
  [[nodiscard]] std::vector<NodeId> nodes_of(TriangleId t) const {
    std::vector<NodeId> nodes;
    if (has_vertices(mesh_graph_.kind)) {
      for (const VertexId v : mesh_.triangles[t]) nodes.push_back(mesh_graph_.node_of[v]);
    }
    if (has_triangles(mesh_graph_.kind)) {
      nodes.push_back(mesh_graph_.node_of[mesh_graph_.first_triangle_id + t]);
    }
    return nodes;
  }

  [[nodiscard]] NodeId nearest_free(const SeedPlace& place) const {
    NodeId nearest = no_id;
    double least = 0;
    for (const NodeId node : nodes_of(place.triangle)) {
      if (taken_.contains(node)) continue;
      const double distance = (mesh_graph_.position[node] - place.position).squaredNorm();
      if (nearest == no_id || distance < least) {
        nearest = node;
        least = distance;
      }
    }
    return nearest;
  }

  [[nodiscard]] NodeId first_free_around(NodeId start, std::size_t most) const {
    std::vector<NodeId> found{start};
    std::unordered_set<NodeId> met{start};
    for (std::size_t i = 0; i < found.size() && i < most; ++i) {
      if (!taken_.contains(found[i])) return found[i];
      for (const NodeId v : mesh_graph_.graph.neighbours(found[i])) {
        if (met.insert(v).second) found.push_back(v);
      }
    }
    return no_id;
  }

  const Mesh& mesh_;
  const MeshGraph& mesh_graph_;
  std::unordered_set<NodeId> taken_;
};

}  // namespace

std::vector<NodeId> seeds_at_triangles(const Mesh& mesh, const MeshGraph& mesh_graph,
                                       std::span<const std::uint32_t> triangles) {
  std::vector<NodeId> seeds;
  seeds.reserve(triangles.size());
  FreeNodes free(mesh, mesh_graph);
  for (const TriangleId t : triangles) {
    if (has_triangles(mesh_graph.kind)) {
      seeds.push_back(mesh_graph.node_of[mesh_graph.first_triangle_id + t]);
      continue;
    }
    const NodeId seed =
        free.take_near({t, barycentre(mesh, t)}, std::numeric_limits<std::size_t>::max());
    if (seed == no_id) {
      throw InvalidInput("a component of the mesh has fewer vertices than seeds: ask for fewer");
    }
    seeds.push_back(seed);
  }
  return seeds;
}

std::vector<NodeId> seeds_near(const Mesh& mesh, const MeshGraph& mesh_graph,
                               std::span<const SeedPlace> places) {
  constexpr std::size_t most_looked_at = 100;
  std::vector<NodeId> seeds;
  seeds.reserve(places.size());
  FreeNodes free(mesh, mesh_graph);
  for (const SeedPlace& place : places) {
    const NodeId seed = free.take_near(place, most_looked_at);
    if (seed != no_id) seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace geolloyd

#include "core/seeds/seed_places.h"

#include <unordered_set>

#include "core/mesh/mesh_measure.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

class VertexSeeds {
 public:
  VertexSeeds(const Mesh& mesh, const MeshGraph& mesh_graph)
      : mesh_(mesh), mesh_graph_(mesh_graph) {}

  NodeId take_near(std::uint32_t triangle) {
    NodeId seed = nearest_free_corner(triangle);
    if (seed == no_id) seed = first_free_around(node_of_corner(triangle, 0));
    if (seed == no_id) {
      throw InvalidInput("a component of the mesh has fewer vertices than seeds: ask for fewer");
    }
    taken_.insert(seed);
    return seed;
  }

 private:
  [[nodiscard]] NodeId node_of_corner(std::uint32_t triangle, std::size_t corner) const {
    return mesh_graph_.node_of[mesh_.triangles[triangle][corner]];
  }

  [[nodiscard]] NodeId nearest_free_corner(std::uint32_t triangle) const {
    const Vec3 place = barycentre(mesh_, triangle);
    NodeId nearest = no_id;
    double least = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const NodeId node = node_of_corner(triangle, corner);
      if (taken_.contains(node)) continue;
      const double distance = (mesh_graph_.position[node] - place).squaredNorm();
      if (nearest == no_id || distance < least) {
        nearest = node;
        least = distance;
      }
    }
    return nearest;
  }

  [[nodiscard]] NodeId first_free_around(NodeId start) const {
    std::vector<NodeId> found{start};
    std::unordered_set<NodeId> met{start};
    for (std::size_t i = 0; i < found.size(); ++i) {
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
  VertexSeeds vertices(mesh, mesh_graph);
  for (const std::uint32_t t : triangles) {
    seeds.push_back(has_triangles(mesh_graph.kind)
                        ? mesh_graph.node_of[mesh_graph.first_triangle_id + t]
                        : vertices.take_near(t));
  }
  return seeds;
}

}  // namespace geolloyd

#include "tools/evaluation/ground_truth.h"

#include <cmath>
#include <numbers>

#include "core/base/executor.h"
#include "core/base/hexagonal_energy.h"
#include "core/base/loops.h"
#include "tools/evaluation/distances/point_queries.h"

namespace geolloyd {
namespace {

std::vector<RegionId> nearest_seeds(Executor& executor, const MeshGraph& mesh_graph,
                                    const Partition& partition, std::span<const Vec3> seeds) {
  const NearestSite nearest(seeds, executor.threads());
  std::vector<RegionId> region(mesh_graph.position.size(), no_id);
  parallel_for(executor, region.size(), small_items, [&](std::size_t v) {
    const RegionId guess = region_of(partition.key[v]);
    if (guess != no_id) region[v] = nearest.find(mesh_graph.position[v], guess);
  });
  return region;
}

double share(double part, double whole) {
  return whole > 0 ? part / whole : 1;
}

// Sums over all nodes, in their order. Masses in ticks.
void add_nodes(GroundTruth& truth, const MeshGraph& mesh_graph, const Partition& partition,
               std::span<const Vec3> seeds) {
  const Graph& graph = mesh_graph.graph;
  std::vector<double> mass(seeds.size(), 0);
  std::vector<Vec3> moment(seeds.size(), Vec3::Zero());  // about the seed
  double whole = 0;
  double common_mass = 0;
  std::size_t common_nodes = 0;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    const RegionId r = truth.region[v];
    if (r == no_id) {
      ++truth.unreached_nodes;
      continue;
    }
    const RegionId other = region_of(partition.key[v]);
    const double m = graph.mass[v];
    const Vec3 away = mesh_graph.position[v] - seeds[r];
    const Vec3 other_away = mesh_graph.position[v] - seeds[other];
    truth.energy += m * dot(away, away);
    truth.graph_energy += m * dot(other_away, other_away);
    mass[r] += m;
    moment[r] += m * away;
    whole += m;
    common_mass += r == other ? m : 0;
    common_nodes += r == other ? 1 : 0;
  }
  const auto nodes = static_cast<double>(graph.node_count() - truth.unreached_nodes);
  truth.node_agreement = share(static_cast<double>(common_nodes), nodes);
  truth.area_agreement = share(common_mass, whole);
  truth.energy *= graph.tick_mass;
  truth.graph_energy *= graph.tick_mass;

  // Where vertices and triangles are nodes, each has all the area as mass.
  const bool twice = has_vertices(mesh_graph.kind) && has_triangles(mesh_graph.kind);
  const double area_of_tick = twice ? graph.tick_mass / 2 : graph.tick_mass;
  truth.hexagonal = hexagonal_energy(whole * graph.tick_mass, whole * area_of_tick, seeds.size());
  for (std::size_t r = 0; r < seeds.size(); ++r) {
    truth.area.push_back(mass[r] * area_of_tick);
    truth.centroid.push_back(mass[r] > 0 ? Vec3(seeds[r] + moment[r] / mass[r]) : seeds[r]);
  }
}

double mean_triangle_side(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& p = mesh.positions[a];
    const Vec3& q = mesh.positions[b];
    const Vec3& r = mesh.positions[c];
    sum += norm(q - p) + norm(r - q) + norm(p - r);
  }
  return sum / (3 * static_cast<double>(mesh.triangle_count()));
}

void measure_distances(GroundTruth& truth, Executor& executor, const Mesh& mesh,
                       std::span<const Vec3> seeds) {
  const ClosestPoint surface(mesh, executor.threads());
  truth.surface_centroid.resize(seeds.size());
  parallel_for(executor, seeds.size(), 16, [&](std::size_t r) {
    truth.surface_centroid[r] = surface.find(truth.centroid[r]).position;
  });
  const double side = mean_triangle_side(mesh);
  for (std::size_t r = 0; r < seeds.size(); ++r) {
    const double distance = norm(truth.surface_centroid[r] - seeds[r]);
    const double radius = std::sqrt(truth.area[r] / std::numbers::pi);
    truth.seed_distance.push_back(distance);
    truth.distance_in_edges.add(side > 0 ? distance / side : 0);
    truth.distance_in_radii.add(radius > 0 ? distance / radius : 0);
  }
}

}  // namespace

GroundTruth make_ground_truth(Executor& executor, const Mesh& mesh, const MeshGraph& mesh_graph,
                              const Partition& partition, std::span<const NodeId> seeds) {
  GroundTruth truth;
  const std::vector<Vec3> position = positions_of(mesh_graph, seeds);
  truth.region = nearest_seeds(executor, mesh_graph, partition, position);
  add_nodes(truth, mesh_graph, partition, position);
  measure_distances(truth, executor, mesh, position);
  return truth;
}

}  // namespace geolloyd

#include "tools/view/layers.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tools/render/labels.h"

namespace geolloyd {
namespace {

// What has regions.
std::string nodes_of(GraphKind kind) {
  if (!has_triangles(kind)) return "vertex";
  return has_vertices(kind) ? "both" : "triangle";
}

void add_triangles(Bundle& bundle, std::string name, const Mesh& mesh, std::string per = "") {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * mesh.triangle_count());
  for (const Triangle& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  bundle.arrays.push_back({std::move(name), std::move(corners), 3, std::move(per), false});
}

void add_colours(Bundle& bundle, std::string name, std::span<const Colour> colours,
                 std::string per = "") {
  std::vector<std::uint8_t> values;
  values.reserve(3 * colours.size());
  for (const Colour& c : colours) values.insert(values.end(), c.begin(), c.end());
  bundle.arrays.push_back({std::move(name), std::move(values), 3, std::move(per), false});
}

// What `of_node` has for the node of each input id, no_id where it has no node.
template <class OfNode>
std::vector<std::uint32_t> per_input_id(const MeshGraph& mesh_graph, OfNode&& of_node) {
  std::vector<std::uint32_t> values;
  values.reserve(mesh_graph.node_of.size());
  for (const NodeId node : mesh_graph.node_of) {
    values.push_back(node == no_id ? no_id : of_node(node));
  }
  return values;
}

void add_region_array(Bundle& bundle, std::string name, const MeshGraph& mesh_graph,
                      const Partition& partition, std::size_t regions) {
  bundle.add_ids(
      std::move(name),
      per_input_id(mesh_graph, [&](NodeId node) { return region_of(partition.key[node]); }),
      regions, nodes_of(mesh_graph.kind));
}

}  // namespace

void add_mesh(Bundle& bundle, const Mesh& mesh, const SurfaceColours& colours) {
  bundle.add_places("positions", mesh.positions, "vertex");
  add_triangles(bundle, "triangles", mesh, "triangle");
  if (!colours.of_vertices.empty()) add_colours(bundle, "colours", colours.of_vertices, "vertex");
  if (!colours.of_triangles.empty()) {
    add_colours(bundle, "colours", colours.of_triangles, "triangle");
  }
}

void add_regions(Bundle& bundle, const MeshGraph& mesh_graph, const Partition& partition,
                 std::span<const NodeId> seeds) {
  add_regions(bundle, mesh_graph, partition, seeds,
              colours_of_regions(mesh_graph.graph, partition, seeds.size()));
}

void add_regions(Bundle& bundle, const MeshGraph& mesh_graph, const Partition& partition,
                 std::span<const NodeId> seeds, std::span<const Colour> colours) {
  add_region_array(bundle, "region", mesh_graph, partition, seeds.size());
  bundle.add_places("seeds", positions_of(mesh_graph, seeds));
  std::vector<std::uint32_t> ids(seeds.size());
  std::transform(seeds.begin(), seeds.end(), ids.begin(),
                 [&](NodeId seed) { return mesh_graph.input_id[seed]; });
  bundle.arrays.push_back({"seed_id", std::move(ids), 1, "", false});
  add_colours(bundle, "palette", colours);
}

void add_region_figures(Bundle& bundle, std::span<const RegionSummary> regions) {
  std::vector<std::uint32_t> nodes;
  std::vector<float> areas;
  std::vector<float> energies;
  for (const RegionSummary& region : regions) {
    nodes.push_back(region.node_count);
    areas.push_back(static_cast<float>(region.area));
    energies.push_back(static_cast<float>(region.energy));
  }
  bundle.arrays.push_back({"region_nodes", std::move(nodes), 1, "", false});
  bundle.arrays.push_back({"region_area", std::move(areas), 1, "", false});
  bundle.arrays.push_back({"region_energy", std::move(energies), 1, "", false});
}

void add_trees(Bundle& bundle, const MeshGraph& mesh_graph, const Partition& partition) {
  const std::vector<std::uint32_t> parent = per_input_id(mesh_graph, [&](NodeId node) {
    const NodeId next = partition.parent[node];
    return next == no_id ? no_id : mesh_graph.input_id[next];
  });
  bundle.add_ids("parent", parent, parent.size(), nodes_of(mesh_graph.kind));
}

void add_field(Bundle& bundle, std::span<const TangentSpace> vertex_space) {
  double largest = 0;
  for (const TangentSpace& space : vertex_space) {
    largest = std::max({largest, space.tangent_magnitude, space.bitangent_magnitude});
  }
  if (!(largest > 0)) largest = 1;
  std::vector<float> values;
  values.reserve(6 * vertex_space.size());
  const auto add = [&](const Vec3& direction, double magnitude) {
    const Vec3 v = normalized(direction) * (magnitude / largest);
    for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(v[c]));
  };
  for (const TangentSpace& space : vertex_space) {
    add(space.tangent, space.tangent_magnitude);
    add(space.bitangent, space.bitangent_magnitude);
  }
  bundle.arrays.push_back({"field", std::move(values), 6, "vertex", false});
}

void add_truth(Bundle& bundle, const MeshGraph& mesh_graph, const GroundTruth& truth) {
  bundle.add_ids("truth_region",
                 per_input_id(mesh_graph, [&](NodeId node) { return truth.region[node]; }),
                 truth.surface_centroid.size(), nodes_of(mesh_graph.kind));
  bundle.add_places("truth_centroids", truth.surface_centroid);
}

void add_remesh(Bundle& bundle, const Mesh& remesh) {
  bundle.add_places("remesh_positions", remesh.positions);
  add_triangles(bundle, "remesh_triangles", remesh);
}

void add_frame(Bundle& bundle, const std::string& label, double energy, const MeshGraph& mesh_graph,
               const Partition& partition, std::span<const NodeId> seeds) {
  const std::string name = "frame_" + std::to_string(bundle.frames.size());
  add_region_array(bundle, name + "_region", mesh_graph, partition, seeds.size());
  bundle.add_places(name + "_seeds", positions_of(mesh_graph, seeds));
  bundle.frames.push_back({{"label", label},
                           {"energy", energy},
                           {"seeds", name + "_seeds"},
                           {"region", name + "_region"}});
}

}  // namespace geolloyd

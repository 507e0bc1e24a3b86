#include "tools/report/vtp_output.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "core/formats/mesh_io.h"
#include "geolloyd/errors.h"
#include "tools/files/output_folder.h"

namespace geolloyd {
namespace {

// Of `count` input ids from the first one on.
std::vector<Property> arrays_of(const MeshGraph& mesh_graph, const Partition& partition,
                                std::size_t first, std::size_t count) {
  std::vector<std::int32_t> region(count, -1);
  std::vector<double> distance(count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < count; ++i) {
    const NodeId node = mesh_graph.node_of[first + i];
    if (node == no_id) continue;
    const Key key = partition.key[node];
    region[i] = static_cast<std::int32_t>(region_of(key));
    distance[i] = distance_of(key) * mesh_graph.graph.tick_length;
  }
  return {{"region", std::move(region)}, {"distance", std::move(distance)}};
}

void append_own(std::vector<Property>& properties, const std::vector<Property>& own) {
  for (Property property : own) {
    while (std::any_of(properties.begin(), properties.end(),
                       [&](const Property& p) { return p.name == property.name; })) {
      property.name.insert(0, "input_");
    }
    properties.push_back(std::move(property));
  }
}

}  // namespace

void check_vtp_target(const std::filesystem::path& path,
                      std::span<const std::filesystem::path> others) {
  if (known_format(path) != MeshFormat::vtp) {
    throw InvalidInput("--vtp " + path.string() + ": give a name that ends with .vtp");
  }
  check_target(path, others);
}

void write_vtp(const std::filesystem::path& path, const PreparedInput& start,
               const Partition& partition) {
  const MeshGraph& mesh_graph = start.mesh_graph;
  const Mesh& mesh = start.input.mesh();
  const std::size_t vertices = has_vertices(mesh_graph.kind) ? mesh.vertex_count() : 0;
  Properties properties;
  if (vertices > 0) properties.of_vertices = arrays_of(mesh_graph, partition, 0, vertices);
  if (has_triangles(mesh_graph.kind)) {
    properties.of_triangles =
        arrays_of(mesh_graph, partition, mesh_graph.first_triangle_id, mesh.triangle_count());
  }
  append_own(properties.of_vertices, start.input.loaded.properties.of_vertices);
  append_own(properties.of_triangles, start.input.loaded.properties.of_triangles);
  FileWriter file(path);
  write(file, mesh, properties);
  file.commit();
}

}  // namespace geolloyd

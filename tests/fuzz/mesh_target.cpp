#include "tests/fuzz/mesh_target.h"

#include <cmath>

#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_quality.h"
#include "core/mesh/mesh_topology.h"
#include "core/properties/properties.h"
#include "tests/fuzz/target.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd::fuzz {
namespace {

void require_sound(const Mesh& mesh) {
  require(!mesh.triangles.empty(), "a mesh has triangles");
  for (const Vec3& p : mesh.positions) {
    for (const double coordinate : p) require(is_usable(coordinate), "coordinates are usable");
  }
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) require(v < mesh.vertex_count(), "indices are in range");
  }
}

// A coordinate takes a byte at least, and so does a corner, each of which beyond the second of its
// face makes a triangle; vectors that grow hold up to twice what is in them.
void require_warranted(const Mesh& mesh, std::size_t file_size) {
  const std::size_t bytes =
      mesh.positions.capacity() * sizeof(Vec3) + mesh.triangles.capacity() * sizeof(Triangle);
  require(bytes <= 32 * file_size, "memory is a small multiple of the file's size");
}

void require_facts(const Mesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  const MeshFacts facts = check_mesh(mesh, edges);
  require(std::isfinite(facts.area) && facts.area >= 0, "the area is a number");
  require(std::isfinite(facts.bounding_diagonal), "the diagonal is a number");
  const MeshTopology topology = find_topology(mesh, edges);
  require(topology.total().euler_characteristic == facts.euler_characteristic &&
              topology.parts.size() == facts.components &&
              topology.non_manifold_edges == facts.non_manifold_edges &&
              topology.inconsistent_edges == facts.inconsistent_edges,
          "two ways of counting agree");
  const MeshQuality quality = measure_quality(mesh, edges);
  require(quality.smallest_angle >= 0 && quality.smallest_angle <= 60 &&
              quality.mean_smallest_angle <= 60 + 1e-6,
          "the smallest angle of a triangle is at most 60 degrees");
  require(quality.smallest_quality >= 0 && quality.mean_quality <= 1 + 1e-6,
          "the quality of a triangle is at most 1");
}

void require_round_trip(const Mesh& mesh) {
  static const TemporaryFolder folder;
  for (const char* name : {"mesh.ply", "mesh.obj", "mesh.off", "mesh.msh", "mesh.mesh"}) {
    write(folder.path() / name, mesh);
    const Mesh same = read(folder.path() / name).mesh;
    require(same.positions == mesh.positions && same.triangles == mesh.triangles,
            "a mesh is read as it was written");
  }
}

// They fit the mesh, take memory that the file's size warrants, and come back when they are
// written.
void require_sound(const LoadedMesh& loaded, std::size_t file_size) {
  validate(loaded.properties, loaded.mesh);
  require(bytes_of(loaded.properties) <= 80 * file_size,
          "properties take a small multiple of the file's size");
  static const TemporaryFolder folder;
  if ((file_size + loaded.mesh.vertex_count()) % 8 != 1) return;
  write(folder.path() / "mesh.ply", loaded.mesh, loaded.properties);
  const Properties same = read(folder.path() / "mesh.ply", {true}).properties;
  require(list_names(same.of_vertices) == list_names(loaded.properties.of_vertices) &&
              list_names(same.of_triangles) == list_names(loaded.properties.of_triangles),
          "properties are read as they were written");
}

}  // namespace

int try_mesh_file(MeshFormat format, const std::uint8_t* data, std::size_t size) {
  // Beyond that a file makes more of itself only by having meshes in many places.
  const std::uint64_t most_bytes = 14 * size;
  const auto parse = [&](bool properties) {
    return parse_mesh(format, text_of(data, size), input_name, {properties, most_bytes});
  };
  const auto whole = if_accepted([&] { return parse(true); });
  const auto loaded = if_accepted([&] { return parse(false); });
  require(!whole || loaded, "a file is no worse if nobody asks for properties");
  if (whole) require_sound(*whole, size);
  if (!loaded) return 0;
  const Mesh& mesh = loaded->mesh;
  require_sound(mesh);
  require_warranted(mesh, size);
  require_facts(mesh);
  // Files take their time: one mesh in eight, told by something that is the same each time.
  if ((size + mesh.vertex_count()) % 8 == 0) require_round_trip(mesh);
  return 0;
}

}  // namespace geolloyd::fuzz

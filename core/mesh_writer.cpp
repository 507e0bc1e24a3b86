#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/file_writer.h"
#include "core/mesh_readers.h"

namespace geolloyd {
namespace {

// As three float32.
void write_position(FileWriter& out, const Vec3& position) {
  for (const double coordinate : position) {
    if (!(std::abs(coordinate) <= std::numeric_limits<float>::max())) {
      throw InvalidInput(out.path().string() +
                         ": a coordinate is too large for the 32 bits of this format; write OBJ or "
                         "OFF");
    }
    out.raw(static_cast<float>(coordinate));
  }
}

void write_ply(FileWriter& out, const Mesh& mesh) {
  out.text("ply\nformat binary_little_endian 1.0\nelement vertex ");
  out.number(mesh.vertex_count());
  out.text("\nproperty float x\nproperty float y\nproperty float z\nelement face ");
  out.number(mesh.triangle_count());
  out.text("\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Vec3& position : mesh.positions) write_position(out, position);
  for (const Triangle& triangle : mesh.triangles) {
    out.raw(std::uint8_t{3});
    for (const VertexId vertex : triangle) out.raw(vertex);
  }
}

void write_positions(FileWriter& out, const Mesh& mesh, std::string_view opening) {
  for (const Vec3& position : mesh.positions) {
    out.text(opening);
    out.number(position.x());
    out.text(" ");
    out.number(position.y());
    out.text(" ");
    out.number(position.z());
    out.text("\n");
  }
}

void write_triangles(FileWriter& out, const Mesh& mesh, std::string_view opening,
                     std::uint64_t first_vertex) {
  for (const Triangle& triangle : mesh.triangles) {
    out.text(opening);
    for (const VertexId vertex : triangle) {
      out.text(" ");
      out.number(first_vertex + vertex);
    }
    out.text("\n");
  }
}

void write_obj(FileWriter& out, const Mesh& mesh) {
  write_positions(out, mesh, "v ");
  write_triangles(out, mesh, "f", 1);
}

void write_off(FileWriter& out, const Mesh& mesh) {
  out.text("OFF\n");
  out.number(mesh.vertex_count());
  out.text(" ");
  out.number(mesh.triangle_count());
  out.text(" 0\n");
  write_positions(out, mesh, "");
  write_triangles(out, mesh, "3", 0);
}

void write_stl(FileWriter& out, const Mesh& mesh) {
  // Must not begin with "solid", the first word of an ascii STL.
  std::string title = "binary STL written by geolloyd";
  title.resize(80, ' ');
  out.text(title);
  out.raw(static_cast<std::uint32_t>(mesh.triangle_count()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& origin = mesh.positions[a];
    write_position(out, normalized(cross(mesh.positions[b] - origin, mesh.positions[c] - origin)));
    for (const VertexId vertex : {a, b, c}) write_position(out, mesh.positions[vertex]);
    out.raw(std::uint16_t{0});
  }
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) {
  const MeshFormat format = format_of(path);
  FileWriter out(path);
  switch (format) {
    case MeshFormat::ply:
      write_ply(out, mesh);
      break;
    case MeshFormat::obj:
      write_obj(out, mesh);
      break;
    case MeshFormat::off:
      write_off(out, mesh);
      break;
    case MeshFormat::stl:
      write_stl(out, mesh);
      break;
  }
  out.commit();
}

}  // namespace geolloyd

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "core/formats/mesh_readers.h"
#include "core/text/file_writer.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// As three float32.
void write_floats(FileWriter& out, const Vec3& position) {
  for (const double coordinate : position) out.raw(static_cast<float>(coordinate));
}

// Told by its bits: compilers may take a cast to float and back for nothing.
bool is_float(double x) {
  constexpr std::uint64_t beyond_float = (std::uint64_t{1} << 29) - 1;
  const double size = std::abs(x);
  return x == 0 ||
         ((std::bit_cast<std::uint64_t>(x) & beyond_float) == 0 &&
          size >= std::numeric_limits<float>::min() && size <= std::numeric_limits<float>::max());
}

bool are_floats(const std::vector<Vec3>& positions) {
  return std::all_of(positions.begin(), positions.end(), [](const Vec3& p) {
    return is_float(p.x()) && is_float(p.y()) && is_float(p.z());
  });
}

void write_label(FileWriter& out, const Label& label) {
  for (const std::uint8_t channel : label.colour) out.raw(channel);
  out.raw(label.region);
}

void write_ply_header(FileWriter& out, const Mesh& mesh, bool floats, bool vertex_labels,
                      bool triangle_labels) {
  const std::string real = floats ? "float" : "double";
  const std::string label =
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int region\n";
  out.text("ply\nformat binary_little_endian 1.0\ncomment written by geolloyd\nelement vertex ");
  out.number(mesh.vertex_count());
  out.text("\nproperty " + real + " x\nproperty " + real + " y\nproperty " + real + " z\n");
  if (vertex_labels) out.text(label);
  out.text("element face ");
  out.number(mesh.triangle_count());
  out.text("\nproperty list uchar uint vertex_indices\n");
  if (triangle_labels) out.text(label);
  out.text("end_header\n");
}

void write_ply(FileWriter& out, const Mesh& mesh, std::span<const Label> vertex_label,
               std::span<const Label> triangle_label) {
  const bool floats = are_floats(mesh.positions);
  write_ply_header(out, mesh, floats, !vertex_label.empty(), !triangle_label.empty());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (floats) {
      write_floats(out, p);
    } else {
      for (const double coordinate : p) out.raw(coordinate);
    }
    if (!vertex_label.empty()) write_label(out, vertex_label[v]);
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    out.raw(std::uint8_t{3});
    for (const VertexId vertex : mesh.triangles[t]) out.raw(vertex);
    if (!triangle_label.empty()) write_label(out, triangle_label[t]);
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
  for (const Vec3& p : mesh.positions) {
    if (p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()) continue;
    throw InvalidInput(out.path().string() +
                       ": a coordinate is too large for STL; write PLY, OBJ or OFF");
  }
  // Must not begin with "solid", the first word of an ascii STL.
  std::string title = "binary STL written by geolloyd";
  title.resize(80, ' ');
  out.text(title);
  out.raw(static_cast<std::uint32_t>(mesh.triangle_count()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& origin = mesh.positions[a];
    write_floats(out, normalized(cross(mesh.positions[b] - origin, mesh.positions[c] - origin)));
    for (const VertexId vertex : {a, b, c}) write_floats(out, mesh.positions[vertex]);
    out.raw(std::uint16_t{0});
  }
}

}  // namespace

void check_mesh_name(const std::filesystem::path& path) {
  (void)format_of(path);
}

void write_mesh(FileWriter& out, const Mesh& mesh) {
  switch (format_of(out.path())) {
    case MeshFormat::ply:
      return write_ply(out, mesh, {}, {});
    case MeshFormat::obj:
      return write_obj(out, mesh);
    case MeshFormat::off:
      return write_off(out, mesh);
    case MeshFormat::stl:
      return write_stl(out, mesh);
  }
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) {
  validate_contents(mesh);
  FileWriter out(path);
  write_mesh(out, mesh);
  out.commit();
}

void write_labelled_ply(FileWriter& out, const Mesh& mesh, std::span<const Label> vertex_label,
                        std::span<const Label> triangle_label) {
  write_ply(out, mesh, vertex_label, triangle_label);
}

}  // namespace geolloyd

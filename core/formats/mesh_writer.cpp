#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/held_properties.h"
#include "core/formats/mesh_writers.h"
#include "core/properties/properties.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

void write_values(FileWriter& out, const Numbers& numbers, std::size_t row) {
  for (const Property* property : numbers) {
    out.text(" ");
    std::visit([&](const auto& values) { out.number(values[row]); }, property->values);
  }
}

// Between 0 and 1.
void write_intensities(FileWriter& out, const Numbers& numbers, std::size_t row) {
  for (const Property* property : numbers) {
    out.text(" ");
    out.number(intensity_at(*property, row));
  }
}

// Bytes as whole numbers; the reader tells them from shares.
void write_off_colour(FileWriter& out, const Numbers& numbers, std::size_t row) {
  if (are_bytes(numbers)) return write_values(out, numbers, row);
  write_intensities(out, numbers, row);
}

void write_position(FileWriter& out, const Vec3& position) {
  out.number(position.x());
  out.text(" ");
  out.number(position.y());
  out.text(" ");
  out.number(position.z());
}

void write_rows(FileWriter& out, std::string_view keyword, const Numbers& numbers,
                std::size_t count) {
  if (numbers.empty()) return;
  for (std::size_t row = 0; row < count; ++row) {
    out.text(keyword);
    write_values(out, numbers, row);
    out.text("\n");
  }
}

// A vertex is its own texture coordinate and normal.
void write_obj(FileWriter& out, const Mesh& mesh, const HeldProperties& properties) {
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    out.text("v ");
    write_position(out, mesh.positions[v]);
    write_intensities(out, properties.colours, v);
    out.text("\n");
  }
  write_rows(out, "vt", properties.texture, mesh.vertex_count());
  write_rows(out, "vn", properties.normals, mesh.vertex_count());
  const bool has_texture = !properties.texture.empty();
  const bool has_normals = !properties.normals.empty();
  for (const Triangle& triangle : mesh.triangles) {
    out.text("f");
    for (const VertexId vertex : triangle) {
      const std::uint64_t id = std::uint64_t{vertex} + 1;
      out.text(" ");
      out.number(id);
      if (has_texture || has_normals) out.text("/");
      if (has_texture) out.number(id);
      if (has_normals) out.text("/");
      if (has_normals) out.number(id);
    }
    out.text("\n");
  }
}

void write_off(FileWriter& out, const Mesh& mesh, const HeldProperties& properties) {
  if (!properties.texture.empty()) out.text("ST");
  if (!properties.colours.empty()) out.text("C");
  if (!properties.normals.empty()) out.text("N");
  out.text("OFF\n");
  out.number(mesh.vertex_count());
  out.text(" ");
  out.number(mesh.triangle_count());
  out.text(" 0\n");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    write_position(out, mesh.positions[v]);
    write_values(out, properties.normals, v);
    write_off_colour(out, properties.colours, v);
    write_values(out, properties.texture, v);
    out.text("\n");
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    out.text("3");
    for (const VertexId vertex : mesh.triangles[t]) {
      out.text(" ");
      out.number(vertex);
    }
    write_off_colour(out, properties.triangle_colours, t);
    out.text("\n");
  }
}

void write_stl(FileWriter& out, const Mesh& mesh) {
  check_float_range(out, mesh, "STL");
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

void check_float_range(const FileWriter& out, const Mesh& mesh, const char* format) {
  for (const Vec3& p : mesh.positions) {
    if (p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()) continue;
    throw InvalidInput(out.path().string() + ": a coordinate is too large for " + format +
                       "; write PLY, OBJ or OFF");
  }
}

void keep_writable(const std::filesystem::path& path, Properties& properties) {
  keep_writable(format_to_write(path), properties);
}

void keep_writable(MeshFormat format, Properties& properties) {
  if (format == MeshFormat::ply || format == MeshFormat::vtp) return;
  const HeldProperties held(format, properties);
  const auto keep = [&](const std::vector<Property>& all, const char* what) {
    std::vector<Property> kept;
    std::vector<Property> lost;
    for (const Property& property : all) {
      (held.hold(property) ? kept : lost).push_back(property);
    }
    if (!lost.empty()) {
      properties.left_out.push_back(list_names(lost) + " of " + what + ": " +
                                    facts_of(format).name + " has no place for them; PLY has");
    }
    return kept;
  };
  std::vector<Property> of_vertices = keep(properties.of_vertices, "vertices");
  std::vector<Property> of_triangles = keep(properties.of_triangles, "triangles");
  properties.of_vertices = std::move(of_vertices);
  properties.of_triangles = std::move(of_triangles);
  if (properties.of_vertices.empty()) properties.corner_values.clear();
}

void write(FileWriter& out, const Mesh& mesh, const Properties& properties) {
  write(out, format_to_write(out.path()), mesh, properties);
}

void write(FileWriter& out, MeshFormat format, const Mesh& mesh, const Properties& properties) {
  if (!properties.corner_values.empty()) {  // each corner names a vertex that has its values
    const Mesh split{mesh.positions, properties.corner_values};
    return write(out, format, split, {properties.of_vertices, properties.of_triangles, {}});
  }
  switch (format) {
    case MeshFormat::ply:
      return write_labelled_ply(out, mesh, {}, {}, properties);
    case MeshFormat::obj:
      return write_obj(out, mesh, {format, properties});
    case MeshFormat::off:
      return write_off(out, mesh, {format, properties});
    case MeshFormat::stl:
      return write_stl(out, mesh);
    case MeshFormat::glb:
    case MeshFormat::gltf:
      return write_gltf(out, mesh, {format, properties}, format == MeshFormat::glb);
    case MeshFormat::gmsh:
      return write_gmsh(out, mesh, {format, properties});
    case MeshFormat::medit:
      return write_medit(out, mesh, {format, properties});
    case MeshFormat::vtp:
      return write_vtp(out, mesh, properties);
  }
}

void write(const std::filesystem::path& path, const Mesh& mesh, const Properties& properties) {
  validate_contents(mesh);
  validate(properties, mesh);
  FileWriter out(path);
  write(out, mesh, properties);
  out.commit();
}

}  // namespace geolloyd

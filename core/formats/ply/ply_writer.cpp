#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/mesh_writers.h"
#include "core/properties/properties.h"

namespace geolloyd {
namespace {

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

// Numbers of one type in memory, so many bytes apart.
struct Column {
  std::string name;
  std::string type;
  const std::byte* first = nullptr;
  std::size_t stride = 0;
  std::size_t size = 0;

  void write(FileWriter& out, std::size_t row) const {
    const char* const number = reinterpret_cast<const char*>(first + row * stride);
    if (size == 1) out.raw(load<std::uint8_t>(number, std::endian::native));
    if (size == 2) out.raw(load<std::uint16_t>(number, std::endian::native));
    if (size == 4) out.raw(load<std::uint32_t>(number, std::endian::native));
    if (size == 8) out.raw(load<std::uint64_t>(number, std::endian::native));
  }
};

// What a vertex or a triangle has behind its position or its corners.
class Row {
 public:
  Row(std::span<const Label> labels, std::span<const Property> properties) {
    add_labels(labels);
    for (const Property& property : properties) add(property);
  }

  [[nodiscard]] std::string header() const {
    std::string text;
    for (const Column& c : columns_) text += "property " + c.type + " " + c.name + "\n";
    return text;
  }

  void write(FileWriter& out, std::size_t row) const {
    for (const Column& column : columns_) column.write(out, row);
  }

 private:
  void add_labels(std::span<const Label> labels) {
    if (labels.empty()) return;
    const Label& first = labels.front();
    for (std::size_t c = 0; c < colour_names.size(); ++c) {
      add({colour_names[c], "uchar", at(first.colour[c]), sizeof(Label), 1});
    }
    add({"region", "int", at(first.region), sizeof(Label), sizeof(first.region)});
  }

  void add(const Property& property) {
    std::visit(
        [&](const auto& values) {
          if (values.empty()) return;
          add({property.name, type_name(property.values), at(values.front()), sizeof(values[0]),
               sizeof(values[0])});
        },
        property.values);
  }

  // Names that are taken get "input_" before them.
  void add(Column column) {
    while (std::any_of(columns_.begin(), columns_.end(),
                       [&](const Column& c) { return c.name == column.name; })) {
      column.name.insert(0, "input_");
    }
    columns_.push_back(std::move(column));
  }

  template <class Number>
  static const std::byte* at(const Number& number) {
    return reinterpret_cast<const std::byte*>(&number);
  }

  std::vector<Column> columns_;
};

// All up to the faces, and then as many as write_face(face) writes.
template <class WriteFace>
void write_ply(FileWriter& out, const Mesh& mesh, const Row& of_vertex, const Row& of_face,
               std::size_t faces, WriteFace&& write_face) {
  const bool floats = are_floats(mesh.positions);
  const std::string real = floats ? "float" : "double";
  out.text("ply\nformat binary_little_endian 1.0\ncomment written by geolloyd\nelement vertex ");
  out.number(mesh.vertex_count());
  out.text("\nproperty " + real + " x\nproperty " + real + " y\nproperty " + real + " z\n" +
           of_vertex.header() + "element face ");
  out.number(faces);
  out.text("\nproperty list uchar uint vertex_indices\n" + of_face.header() + "end_header\n");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (floats) {
      write_floats(out, p);
    } else {
      for (const double coordinate : p) out.raw(coordinate);
    }
    of_vertex.write(out, v);
  }
  for (std::size_t face = 0; face < faces; ++face) write_face(face);
}

}  // namespace

void write_labelled_ply(FileWriter& out, const Mesh& mesh, std::span<const Label> vertex_label,
                        std::span<const Label> triangle_label, const Properties& properties) {
  const Row of_triangle(triangle_label, properties.of_triangles);
  const std::span<const Triangle> corners = value_triangles(mesh, properties);
  write_ply(out, mesh, Row(vertex_label, properties.of_vertices), of_triangle,
            mesh.triangle_count(), [&](std::size_t t) {
              out.raw(std::uint8_t{3});
              for (const VertexId vertex : corners[t]) out.raw(vertex);
              of_triangle.write(out, t);
            });
}

void write_faces_ply(FileWriter& out, const Mesh& mesh, std::span<const Face> faces,
                     const Properties& properties) {
  const Row of_triangle({}, properties.of_triangles);
  write_ply(out, mesh, Row({}, properties.of_vertices), of_triangle, faces.size(),
            [&](std::size_t f) {
              const Face& face = faces[f];
              const std::size_t corners = face.is_quad() ? 4 : 3;
              out.raw(static_cast<std::uint8_t>(corners));
              for (std::size_t i = 0; i < corners; ++i) out.raw(face.corners[i]);
              of_triangle.write(out, face.triangle);
            });
}

}  // namespace geolloyd

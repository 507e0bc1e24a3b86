#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/mesh_writers.h"

namespace geolloyd {
namespace {

// As VTK names the types of properties, in the order of PropertyValues.
constexpr std::array<const char*, 8> type_names = {"Int8",  "UInt8",  "Int16",   "UInt16",
                                                   "Int32", "UInt32", "Float32", "Float64"};

std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += c >= ' ' && c <= '~' ? c : '?';
    }
  }
  return text;
}

// The arrays stand behind the XML, each after its size; the XML says where.
class VtpWriter {
 public:
  VtpWriter(FileWriter& out, const Mesh& mesh, const Properties& properties)
      : out_(out), mesh_(mesh), properties_(properties) {}

  void write() {
    out_.text(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"" +
        std::to_string(mesh_.vertex_count()) + "\" NumberOfPolys=\"" +
        std::to_string(mesh_.triangle_count()) + "\">\n");
    describe_properties("PointData", properties_.of_vertices);
    describe_properties("CellData", properties_.of_triangles);
    out_.text("<Points>\n");
    describe("Points", "Float64", 3, 24 * mesh_.vertex_count());
    out_.text("</Points>\n<Polys>\n");
    describe("connectivity", "Int64", 1, 24 * mesh_.triangle_count());
    describe("offsets", "Int64", 1, 8 * mesh_.triangle_count());
    out_.text("</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
    write_properties(properties_.of_vertices);
    write_properties(properties_.of_triangles);
    write_shape();
    out_.text("\n</AppendedData>\n</VTKFile>\n");
  }

 private:
  static std::uint64_t bytes_of_values(const Property& property) {
    return std::visit(
        [](const auto& values) { return std::uint64_t{values.size() * sizeof(values[0])}; },
        property.values);
  }

  void describe_properties(const std::string& section, const std::vector<Property>& properties) {
    out_.text("<" + section + ">\n");
    for (const Property& property : properties) {
      describe(escaped(property.name), type_names[property.values.index()], 1,
               bytes_of_values(property));
    }
    out_.text("</" + section + ">\n");
  }

  void describe(const std::string& name, const std::string& type, int components,
                std::uint64_t bytes) {
    out_.text("<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
              std::to_string(components) + R"(" format="appended" offset=")" +
              std::to_string(offset_) + "\"/>\n");
    offset_ += sizeof(std::uint64_t) + bytes;
  }

  void write_properties(const std::vector<Property>& properties) {
    for (const Property& property : properties) {
      out_.raw(bytes_of_values(property));
      std::visit(
          [&](const auto& values) {
            for (const auto value : values) out_.raw(value);
          },
          property.values);
    }
  }

  void write_shape() {
    out_.raw(std::uint64_t{24 * mesh_.vertex_count()});
    for (const Vec3& position : mesh_.positions) {
      for (const double coordinate : position) out_.raw(coordinate);
    }
    out_.raw(std::uint64_t{24 * mesh_.triangle_count()});
    for (const Triangle& triangle : mesh_.triangles) {
      for (const VertexId vertex : triangle) out_.raw(std::uint64_t{vertex});
    }
    out_.raw(std::uint64_t{8 * mesh_.triangle_count()});
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) out_.raw(std::uint64_t{3 * (t + 1)});
  }

  FileWriter& out_;
  const Mesh& mesh_;
  const Properties& properties_;
  std::uint64_t offset_ = 0;
};

}  // namespace

void write_vtp(FileWriter& out, const Mesh& mesh, const Properties& properties) {
  VtpWriter(out, mesh, properties).write();
}

}  // namespace geolloyd

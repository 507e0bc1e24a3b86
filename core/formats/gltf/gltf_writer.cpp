#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/base/bounding_box.h"
#include "core/formats/gltf/base64.h"
#include "core/formats/mesh_writers.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

using nlohmann::json;

constexpr int byte_type = 5121;
constexpr int index_type = 5125;
constexpr int float_type = 5126;

void append_float(std::string& bytes, double number) {
  const auto raw = std::bit_cast<std::uint32_t>(static_cast<float>(number));
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(raw >> shift & 255);
}

// The JSON and the buffer grow together.
class GltfWriter {
 public:
  GltfWriter(const Mesh& mesh, const HeldProperties& properties)
      : mesh_(mesh), properties_(properties) {}

  void build() {
    json attributes = {{"POSITION", add_positions()}};
    if (!properties_.normals.empty())
      attributes["NORMAL"] = add_floats(properties_.normals, "VEC3");
    if (!properties_.texture.empty()) {
      attributes["TEXCOORD_0"] = add_floats(properties_.texture, "VEC2");
    }
    if (!properties_.colours.empty()) attributes["COLOR_0"] = add_colours();
    json primitive = {{"attributes", attributes}, {"indices", add_indices()}, {"material", 0}};
    root_["asset"] = {{"generator", "geolloyd"}, {"version", "2.0"}};
    root_["scene"] = 0;
    root_["scenes"] = json::array({{{"nodes", json::array({0})}}});
    root_["nodes"] = json::array({{{"mesh", 0}}});
    root_["meshes"] = json::array({{{"primitives", json::array({primitive})}}});
    // Both sides of open surfaces are seen, and colours as they are.
    root_["materials"] =
        json::array({{{"doubleSided", true}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}}}}});
  }

  void write_binary(FileWriter& out) {
    pad(bytes_, '\0');
    root_["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    std::string text = root_.dump();
    pad(text, ' ');
    const std::uint64_t size = 12 + 8 + text.size() + 8 + bytes_.size();
    if (size > std::numeric_limits<std::uint32_t>::max()) {
      throw InvalidInput(out.path().string() + ": the mesh is too large for GLB; write PLY");
    }
    out.text("glTF");
    out.raw(std::uint32_t{2});
    out.raw(static_cast<std::uint32_t>(size));
    write_chunk(out, "JSON", text);
    write_chunk(out, std::string_view("BIN\0", 4), bytes_);
  }

  void write_text(FileWriter& out) {
    root_["buffers"] =
        json::array({{{"byteLength", bytes_.size()},
                      {"uri", "data:application/octet-stream;base64," + to_base64(bytes_)}}});
    out.text(root_.dump(1));
    out.text("\n");
  }

 private:
  static void pad(std::string& bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
  }

  static void write_chunk(FileWriter& out, std::string_view kind, std::string_view bytes) {
    out.raw(static_cast<std::uint32_t>(bytes.size()));
    out.text(kind);
    out.text(bytes);
  }

  // An accessor of what was appended since `begin`; returns its number.
  std::size_t add_accessor(std::size_t begin, json accessor, std::size_t stride = 0) {
    json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}};
    if (stride != 0) view["byteStride"] = stride;
    root_["bufferViews"].push_back(std::move(view));
    accessor["bufferView"] = root_["bufferViews"].size() - 1;
    root_["accessors"].push_back(std::move(accessor));
    return root_["accessors"].size() - 1;
  }

  [[nodiscard]] json accessor_of_vertices(int type, const char* width) const {
    return {{"componentType", type}, {"count", mesh_.vertex_count()}, {"type", width}};
  }

  std::size_t add_positions() {
    const std::size_t begin = bytes_.size();
    bytes_.reserve(12 * (mesh_.vertex_count() + mesh_.triangle_count()));
    for (const Vec3& p : mesh_.positions) {
      for (const double coordinate : p) append_float(bytes_, coordinate);
    }
    json accessor = accessor_of_vertices(float_type, "VEC3");
    const BoundingBox box = bounding_box(mesh_.positions);
    for (Eigen::Index axis = 0; axis < 3 && !mesh_.positions.empty(); ++axis) {
      accessor["min"].push_back(static_cast<float>(box.low[axis]));
      accessor["max"].push_back(static_cast<float>(box.high[axis]));
    }
    return add_accessor(begin, std::move(accessor));
  }

  std::size_t add_floats(const Numbers& numbers, const char* width) {
    const std::size_t begin = bytes_.size();
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      for (const Property* property : numbers) append_float(bytes_, value_at(*property, v));
    }
    return add_accessor(begin, accessor_of_vertices(float_type, width));
  }

  // Bytes where they are such, or else floats. A row begins at a multiple of four.
  std::size_t add_colours() {
    const Numbers& colours = properties_.colours;
    const bool as_bytes = are_bytes(colours);
    const std::size_t begin = bytes_.size();
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      for (const Property* part : colours) {
        if (as_bytes) bytes_ += static_cast<char>(static_cast<unsigned char>(value_at(*part, v)));
        if (!as_bytes) append_float(bytes_, intensity_at(*part, v));
      }
      if (as_bytes) pad(bytes_, '\0');
    }
    json accessor = accessor_of_vertices(as_bytes ? byte_type : float_type,
                                         colours.size() == 4 ? "VEC4" : "VEC3");
    if (as_bytes) accessor["normalized"] = true;
    return add_accessor(begin, std::move(accessor), as_bytes ? 4 : 0);
  }

  std::size_t add_indices() {
    const std::size_t begin = bytes_.size();
    for (const Triangle& triangle : mesh_.triangles) {
      for (const VertexId v : triangle) {
        for (int shift = 0; shift < 32; shift += 8) bytes_ += static_cast<char>(v >> shift & 255);
      }
    }
    return add_accessor(
        begin,
        {{"componentType", index_type}, {"count", 3 * mesh_.triangle_count()}, {"type", "SCALAR"}});
  }

  const Mesh& mesh_;
  const HeldProperties& properties_;
  json root_ = json::object();
  std::string bytes_;
};

}  // namespace

void write_gltf(FileWriter& out, const Mesh& mesh, const HeldProperties& properties,
                bool is_binary) {
  check_float_range(out, mesh, "glTF");
  GltfWriter writer(mesh, properties);
  writer.build();
  if (is_binary) return writer.write_binary(out);
  writer.write_text(out);
}

}  // namespace geolloyd

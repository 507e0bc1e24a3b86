#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/corner_properties.h"
#include "core/formats/gltf/gltf_accessor.h"
#include "core/formats/gltf/gltf_scene.h"
#include "core/formats/mesh_readers.h"
#include "core/formats/welder.h"
#include "core/properties/properties.h"

namespace geolloyd {
namespace {

using nlohmann::json;

// Shares that are all 255ths become bytes, as colours mostly are.
void make_bytes(std::vector<Property>& properties) {
  for (Property& property : properties) {
    auto* const values = std::get_if<std::vector<double>>(&property.values);
    if (values == nullptr || !is_colour_part(property.name)) continue;
    const bool are_bytes = std::all_of(values->begin(), values->end(), [](double x) {
      return x >= 0 && x <= 1 && std::abs(255 * x - std::floor(255 * x + 0.5)) < 1e-4;
    });
    if (!are_bytes) continue;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(values->size());
    for (const double x : *values) {
      bytes.push_back(static_cast<std::uint8_t>(std::floor(255 * x + 0.5)));
    }
    property.values = std::move(bytes);
  }
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, std::string_view name, const ReadOptions& options,
             const std::filesystem::path* folder)
      : document_(bytes, name, folder), options_(options) {}

  ParsedMesh read() {
    loaded_.format = document_.is_binary() ? "glTF, binary" : "glTF";
    for (const GltfInstance& instance : find_gltf_instances(document_)) add(instance);
    Properties& properties = loaded_.properties;
    if (options_.properties) {
      const std::size_t count = loaded_.mesh.vertex_count();
      for (CornerProperties* of : {&colours_, &alpha_, &normals_, &texture_}) {
        of->finish(count, properties);
      }
      make_bytes(properties.of_vertices);
      if (has_targets_)
        properties.left_out.emplace_back("morph targets: the shape is that at rest");
    }
    return std::move(loaded_);
  }

 private:
  // Where the vertices of an accessor are, for all primitives of an instance that share it.
  using VertexIds = std::vector<VertexId>;

  void add(const GltfInstance& instance) {
    const std::string what = part_name("meshes", instance.mesh);
    const json& mesh = document_.at("meshes", instance.mesh);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) {
      document_.fail(what, "has no primitives");
    }
    std::map<std::string, VertexIds> known;
    for (const json& primitive : *primitives) add_primitive(primitive, what, instance, known);
  }

  void add_primitive(const json& primitive, const std::string& what, const GltfInstance& instance,
                     std::map<std::string, VertexIds>& known) {
    const bool has_attributes = primitive.is_object() && primitive.contains("attributes") &&
                                primitive["attributes"].is_object();
    if (!has_attributes) document_.fail(what, "a primitive has no attributes");
    const std::uint64_t mode = document_.number(primitive, "mode", what, triangles_mode);
    const json& attributes = primitive["attributes"];
    const bool is_surface = mode >= triangles_mode && mode <= fan_mode;
    if (!is_surface || !attributes.contains("POSITION")) return;
    has_targets_ = has_targets_ || primitive.contains("targets");
    auto vertices = known.find(attributes.dump());
    if (vertices == known.end()) {
      vertices = known.emplace(attributes.dump(), add_vertices(attributes, what, instance)).first;
    }
    add_triangles(primitive, mode, what, vertices->second, is_mirrored(instance));
  }

  static bool is_mirrored(const GltfInstance& instance) {
    return instance.to_world.topLeftCorner<3, 3>().determinant() < 0;
  }

  VertexIds add_vertices(const json& attributes, const std::string& what,
                         const GltfInstance& instance) {
    const GltfAccessor accessor(document_, document_.number(attributes, "POSITION", what));
    if (accessor.width() != 3) document_.fail(accessor.what(), "positions have to be VEC3");
    take_memory(accessor.count() * (sizeof(Vec3) + sizeof(VertexId)));
    const std::vector<double> values = accessor.values();
    VertexIds ids;
    ids.reserve(accessor.count());
    for (std::size_t i = 0; i < values.size(); i += 3) {
      const Eigen::Vector4d local(values[i], values[i + 1], values[i + 2], 1);
      const Eigen::Vector4d world = instance.to_world * local;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (!is_usable(world[axis])) document_.fail(accessor.what(), bad_coordinate(world[axis]));
      }
      ids.push_back(add_vertex({world[0], world[1], world[2]}));
    }
    if (options_.properties) add_properties(attributes, what, instance, ids);
    return ids;
  }

  VertexId add_vertex(const Vec3& position) {
    if (options_.weld) return welder_.id_of(position);
    loaded_.mesh.positions.push_back(position);
    return static_cast<VertexId>(loaded_.mesh.vertex_count() - 1);
  }

  void add_properties(const json& attributes, const std::string& what, const GltfInstance& instance,
                      const VertexIds& ids) {
    const Eigen::Matrix3d linear = instance.to_world.topLeftCorner<3, 3>();
    const Eigen::Matrix3d cofactors = cofactors_of(linear);
    add_rows(attributes, "NORMAL", what, ids, 3, normals_, [&](const double* row) {
      const Eigen::Vector3d normal = cofactors * Eigen::Vector3d(row[0], row[1], row[2]);
      const Vec3 unit = normalized({normal[0], normal[1], normal[2]});
      return std::array<double, 3>{unit.x(), unit.y(), unit.z()};
    });
    add_rows(attributes, "TEXCOORD_0", what, ids, 2, texture_, [](const double* row) {
      return std::array<double, 3>{row[0], row[1], 0};
    });
    add_rows(attributes, "COLOR_0", what, ids, 3, colours_, [](const double* row) {
      return std::array<double, 3>{row[0], row[1], row[2]};
    });
    add_rows(attributes, "COLOR_0", what, ids, 4, alpha_, [](const double* row) {
      return std::array<double, 3>{row[3], 0, 0};
    });
  }

  // What normals are multiplied by: the inverse, transposed, times the determinant.
  static Eigen::Matrix3d cofactors_of(const Eigen::Matrix3d& m) {
    Eigen::Matrix3d cofactors;
    cofactors.col(0) = m.col(1).cross(m.col(2));
    cofactors.col(1) = m.col(2).cross(m.col(0));
    cofactors.col(2) = m.col(0).cross(m.col(1));
    return m.determinant() < 0 ? -cofactors : cofactors;
  }

  // A row for each vertex, or none for any.
  template <class ToRow>
  void add_rows(const json& attributes, const char* key, const std::string& what,
                const VertexIds& ids, std::size_t least_width, CornerProperties& properties,
                ToRow&& to_row) {
    const auto without = [&] {
      for (std::size_t i = 0; i < ids.size(); ++i) properties.add_corner_without();
    };
    if (!attributes.contains(key)) return without();
    const GltfAccessor accessor(document_, document_.number(attributes, key, what));
    if (accessor.count() != ids.size()) {
      document_.fail(accessor.what(), "has another count than the positions beside it");
    }
    if (accessor.width() < least_width) return without();
    take_memory(ids.size() * 2 * sizeof(std::array<double, 3>));
    const std::vector<double> values = accessor.values();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto row = static_cast<std::uint32_t>(properties.row_count());
      properties.add_row(to_row(values.data() + i * accessor.width()));
      properties.add_corner(ids[i], row, 1);
    }
  }

  void add_triangles(const json& primitive, std::uint64_t mode, const std::string& what,
                     const VertexIds& vertices, bool is_mirrored) {
    std::vector<std::uint32_t> corners;
    std::string corners_name = what;
    if (primitive.contains("indices")) {
      const GltfAccessor accessor(document_, document_.number(primitive, "indices", what));
      take_memory(accessor.count() * sizeof(Triangle));
      corners = accessor.indices();
      corners_name = accessor.what();
    } else {
      take_memory(vertices.size() * sizeof(Triangle));
      for (std::uint32_t i = 0; i < vertices.size(); ++i) corners.push_back(i);
    }
    for (const std::uint32_t corner : corners) {
      if (corner >= vertices.size())
        document_.fail(corners_name, bad_index(corner, vertices.size()));
    }
    // Those of a strip that name a vertex twice only join others.
    const auto is_joint = [&](std::size_t i) {
      return corners[i] == corners[i + 1] || corners[i + 1] == corners[i + 2] ||
             corners[i] == corners[i + 2];
    };
    const std::size_t step = mode == triangles_mode ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      if (mode == strip_mode && is_joint(i)) continue;
      std::array<std::size_t, 3> place{i, i + 1, i + 2};
      if (mode == strip_mode && i % 2 == 1) std::swap(place[0], place[1]);
      if (mode == fan_mode) place = {0, i + 1, i + 2};
      if (is_mirrored) std::swap(place[1], place[2]);
      Triangle triangle{};
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = vertices[corners[place[k]]];
      loaded_.mesh.triangles.push_back(triangle);
    }
  }

  // Parts may be there many times over, in as many places.
  void take_memory(std::uint64_t bytes) {
    taken_ += bytes;
    if (taken_ > options_.most_bytes) {
      document_.fail("nodes", "the meshes that they place take more than the " +
                                  std::to_string(options_.most_bytes) + " bytes that are allowed");
    }
  }

  static constexpr std::uint64_t triangles_mode = 4;
  static constexpr std::uint64_t strip_mode = 5;
  static constexpr std::uint64_t fan_mode = 6;

  GltfDocument document_;
  ReadOptions options_;
  ParsedMesh loaded_;
  Welder welder_{loaded_};
  std::uint64_t taken_ = 0;
  bool has_targets_ = false;
  CornerProperties colours_{"colours", {"red", "green", "blue"}};
  CornerProperties alpha_{"alpha", {"alpha"}};
  CornerProperties normals_{"normals", {"nx", "ny", "nz"}};
  CornerProperties texture_{"texture coordinates", {"s", "t"}};
};

}  // namespace

ParsedMesh read_gltf(std::string_view bytes, std::string_view name, const ReadOptions& options,
                     const std::filesystem::path* folder) {
  return GltfReader(bytes, name, options, folder).read();
}

}  // namespace geolloyd

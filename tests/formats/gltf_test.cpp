// glTF, binary and as text: what other programs may write of it, and complaints that name the part.
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/formats/gltf/base64.h"
#include "core/formats/mesh_io.h"
#include "core/properties/properties.h"
#include "tests/support/mesh_files.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

using nlohmann::json;

constexpr std::endian glb_order = std::endian::little;

std::string floats(const std::vector<float>& numbers) {
  std::string bytes;
  for (const float number : numbers) bytes += raw(number, glb_order);
  return bytes;
}

// A square of two triangles: positions, then indices of four bytes.
std::string square_bytes() {
  std::string bytes = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) bytes += raw(i, glb_order);
  return bytes;
}

json gltf_square() {
  return json::parse(R"({"asset":{"version":"2.0"},
    "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                 {"bufferView":1,"componentType":5125,"count":6,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
    "buffers":[{"byteLength":72}]})");
}

std::string as_text(json root, const std::string& bytes) {
  root["buffers"][0]["byteLength"] = bytes.size();
  root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + to_base64(bytes);
  return root.dump();
}

std::string as_binary(const json& root, const std::string& bytes) {
  std::string text = root.dump();
  while (text.size() % 4 != 0) text += ' ';
  std::string file = "glTF" + raw(std::uint32_t{2}, glb_order);
  file += raw(static_cast<std::uint32_t>(28 + text.size() + bytes.size()), glb_order);
  file += raw(static_cast<std::uint32_t>(text.size()), glb_order) + "JSON" + text;
  file +=
      raw(static_cast<std::uint32_t>(bytes.size()), glb_order) + std::string("BIN\0", 4) + bytes;
  return file;
}

const Triangles square_triangles{{0, 1, 2}, {0, 2, 3}};
const std::vector<Vec3> square_corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

class Gltf : public MeshFiles {
 protected:
  void expect_square(const json& root, const std::string& bytes) const {
    const Mesh mesh = load("m.gltf", as_text(root, bytes)).mesh;
    EXPECT_EQ(mesh.positions, square_corners);
    EXPECT_EQ(mesh.triangles, square_triangles);
  }
  [[nodiscard]] std::string refusal(const json& root) const {
    return complaint("m.gltf", as_text(root, square_bytes()));
  }
};

TEST_F(Gltf, IsReadAsTextAndBinary) {
  expect_square(gltf_square(), square_bytes());
  EXPECT_EQ(load("m.glb", as_binary(gltf_square(), square_bytes())).mesh.triangles,
            square_triangles);
  EXPECT_EQ(load("m.glb", as_binary(gltf_square(), square_bytes())).format, "glTF, binary");
  json without_nodes = gltf_square();
  without_nodes.erase("scenes");
  expect_square(without_nodes, square_bytes());
  without_nodes.erase("nodes");
  expect_square(without_nodes, square_bytes());
}

TEST_F(Gltf, MayHaveIndicesOfAnyTypeOrNone) {
  const std::string positions = square_bytes().substr(0, 48);
  json bytes = gltf_square();
  bytes["accessors"][1]["componentType"] = 5121;
  expect_square(bytes, positions + std::string("\0\1\2\0\2\3", 6) + std::string(18, '\0'));
  json shorts = gltf_square();
  shorts["accessors"][1]["componentType"] = 5123;
  std::string ids;
  for (const int i : {0, 1, 2, 0, 2, 3}) ids += raw(static_cast<std::uint16_t>(i), glb_order);
  expect_square(shorts, positions + ids + std::string(12, '\0'));
  json fan = gltf_square();
  fan["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}, {"mode", 6}};
  expect_square(fan, square_bytes());
  json strip = gltf_square();
  strip["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}, {"mode", 5}};
  EXPECT_EQ(load("m.gltf", as_text(strip, square_bytes())).mesh.triangles,
            (Triangles{{0, 1, 2}, {2, 1, 3}}));
}

TEST_F(Gltf, MayHaveStridesSparseRowsAndUnsetOnes) {
  // A float stands behind each position.
  std::string strided;
  for (std::size_t v = 0; v < 4; ++v) strided += square_bytes().substr(12 * v, 12) + "abcd";
  json root = gltf_square();
  root["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 64}, {"byteStride", 16}};
  root["bufferViews"][1]["byteOffset"] = 64;
  expect_square(root, strided + square_bytes().substr(48));

  // All at the origin, but for three.
  json sparse = gltf_square();
  sparse["accessors"][0].erase("bufferView");
  sparse["accessors"][0]["sparse"] = {{"count", 3},
                                      {"indices", {{"bufferView", 2}, {"componentType", 5121}}},
                                      {"values", {{"bufferView", 0}, {"byteOffset", 12}}}};
  sparse["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 3}});
  expect_square(sparse, square_bytes() + "\1\2\3");
  sparse["accessors"][0]["bufferView"] = 0;
  expect_square(sparse, square_bytes() + "\1\2\3");
}

TEST_F(Gltf, NodesMoveTurnScaleAndMirror) {
  json root = gltf_square();
  root["nodes"] = json::parse(R"([{"translation":[10,0,0],"children":[1]},
    {"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,1,1],"mesh":0}])");
  const Mesh mesh = load("m.gltf", as_text(root, square_bytes())).mesh;
  const std::vector<Vec3> expected{{10, 0, 0}, {10, 2, 0}, {9, 2, 0}, {9, 0, 0}};
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_LT((mesh.positions[v] - expected[v]).cwiseAbs().maxCoeff(), 1e-12) << v;
  }
  root["nodes"] = json::parse(R"([{"mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]}])");
  const Mesh mirrored = load("m.gltf", as_text(root, square_bytes())).mesh;
  EXPECT_EQ(mirrored.positions[1], Vec3(-1, 0, 5));
  EXPECT_EQ(mirrored.triangles, (Triangles{{0, 2, 1}, {0, 3, 2}}));
}

// Two places of one mesh share the square_corners that fall on each other.
TEST_F(Gltf, CornersInOnePlaceAreOneVertex) {
  json root = gltf_square();
  root["scenes"][0]["nodes"] = {0, 1};
  root["nodes"] = json::parse(R"([{"mesh":0},{"mesh":0,"translation":[1,0,0]}])");
  const LoadedMesh loaded = load("m.gltf", as_text(root, square_bytes()));
  EXPECT_EQ(loaded.mesh.vertex_count(), 6U);
  EXPECT_EQ(loaded.mesh.triangle_count(), 4U);
  EXPECT_EQ(loaded.welded_corners, 2U);
}

TEST_F(Gltf, BuffersLieBesideTheFileOnly) {
  const TemporaryFolder folder;
  (void)folder.write("the square.bin", square_bytes());
  json root = gltf_square();
  root["buffers"][0]["uri"] = "the%20square.bin";
  EXPECT_EQ(read(folder.write("m.gltf", root.dump())).mesh.triangles, square_triangles);
  for (const char* address : {"../m.bin", "/etc/passwd", "a/b.bin", "..%2fm.bin", "..", ".hidden",
                              "file:///m.bin", "http://x/m.bin", "c:\\m.bin", "", "%zz", "a%00"}) {
    root["buffers"][0]["uri"] = address;
    EXPECT_NE(complaint("m.gltf", root.dump()).find("is no name of a file beside this one"),
              std::string::npos)
        << address;
  }
  root["buffers"][0]["uri"] = "missing.bin";
  EXPECT_THROW((void)load("m.gltf", root.dump()), IoError);
}

// A fan of so many triangles, all of whose numbers are in a buffer beside the file.
class GltfBeside : public Gltf {
 protected:
  static constexpr std::uint32_t triangle_count = 5000;

  static json fan() {
    json root = gltf_square();
    root["accessors"][0]["count"] = triangle_count + 2;
    root["accessors"][1]["count"] = 3 * triangle_count;
    root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 12 * (triangle_count + 2)}},
                           {{"buffer", 0},
                            {"byteOffset", 12 * (triangle_count + 2)},
                            {"byteLength", 12 * triangle_count}}};
    root["buffers"] = {{{"byteLength", fan_bytes().size()}, {"uri", "fan.bin"}}};
    return root;
  }

  static std::string fan_bytes() {
    std::vector<float> positions{0, 0, 0};
    std::string corners;
    for (std::uint32_t i = 0; i <= triangle_count; ++i) {
      const auto x = static_cast<float>(i);
      positions.insert(positions.end(), {1, x, x * x});
      if (i == 0) continue;
      for (const std::uint32_t corner : {0U, i, i + 1}) corners += raw(corner, glb_order);
    }
    return floats(positions) + corners;
  }

  [[nodiscard]] Mesh read_beside(const json& root, const std::string& bytes) const {
    (void)folder_.write("fan.bin", bytes);
    return read(folder_.write("fan.gltf", root.dump())).mesh;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(GltfBeside, HasMoreRowsThanItsFileHasBytes) {
  ASSERT_LT(fan().dump().size(), triangle_count);
  const Mesh mesh = read_beside(fan(), fan_bytes());
  EXPECT_EQ(mesh.vertex_count(), triangle_count + 2);
  EXPECT_EQ(mesh.triangle_count(), triangle_count);
  EXPECT_EQ(mesh.positions.back(), Vec3(1, triangle_count, 25'000'000));
}

// All at the origin, but for the last.
TEST_F(GltfBeside, MayReplaceRowsThatAreUnset) {
  json root = fan();
  root["accessors"][0].erase("bufferView");
  root["accessors"][0]["sparse"] = {{"count", 1},
                                    {"indices", {{"bufferView", 2}, {"componentType", 5125}}},
                                    {"values", {{"bufferView", 0}, {"byteOffset", 12}}}};
  std::string bytes = fan_bytes();
  root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", 4}});
  bytes += raw(triangle_count + 1, glb_order);
  root["buffers"][0]["byteLength"] = bytes.size();
  const Mesh mesh = read_beside(root, bytes);
  EXPECT_EQ(mesh.positions.back(), Vec3(1, 0, 0));

  root["accessors"][0]["count"] = 4'000'000'000;
  EXPECT_THROW((void)read_beside(root, bytes), InvalidInput);
}

TEST_F(Gltf, ComplaintsNameThePart) {
  struct Change {
    const char* pointer;
    json value;
    const char* message;
  };
  for (const auto& [pointer, value, message] : std::initializer_list<Change>{
           {"/asset/version", "1.0", "asset: glTF of version '1.0'; 2.0 is understood"},
           {"/asset", 3, "asset: no version; is the file a glTF?"},
           {"/extensionsRequired",
            {"KHR_draco_mesh_compression"},
            "extensionsRequired: 'KHR_draco_mesh_compression' is not understood; save the mesh "
            "without it"},
           {"/scenes/0/nodes/0", 7, "nodes[7]: is named, but there is none"},
           {"/nodes/0/children", {0}, "nodes[0]: is met twice: nodes are no tree"},
           {"/nodes/0/mesh", -1, "nodes[0]: expected a whole number as 'mesh'"},
           {"/nodes/0/scale", {1, 2}, "nodes[0]: expected 3 numbers as 'scale'"},
           {"/nodes/0/rotation", {0, 0, 0, 0}, "nodes[0]: the rotation is no quaternion"},
           {"/meshes/0", json::object(), "meshes[0]: has no primitives"},
           {"/accessors/0/componentType", 5, "accessors[0]: no such componentType: 5"},
           {"/accessors/0/type", "MAT4",
            "accessors[0]: expected SCALAR, VEC2, VEC3 or VEC4 as 'type'"},
           {"/accessors/0/type", "VEC2", "accessors[0]: positions have to be VEC3"},
           {"/accessors/0/count", 5,
            "accessors[0]: 5 rows are promised, but 4 fit into bufferViews[0]"},
           {"/accessors/0/byteOffset", 4,
            "accessors[0]: 4 rows are promised, but 3 fit into bufferViews[0]"},
           {"/accessors/1/componentType", 5126,
            "accessors[1]: indices have to be unsigned integers"},
           {"/accessors/1/bufferView", 0,
            "accessors[1]: vertex index 1065353216 is out of range; there are 4 vertices, counted "
            "from 0"},
           {"/bufferViews/0/byteLength", 100, "bufferViews[0]: ends at byte 100 of a buffer of 72"},
           {"/bufferViews/0/byteStride", 4,
            "bufferViews[0]: byteStride 4 is less than the 12 bytes of a row"},
           {"/bufferViews/0/buffer", 1, "buffers[1]: is named, but there is none"},
       }) {
    json root = gltf_square();
    root[json::json_pointer(pointer)] = value;
    EXPECT_EQ(refusal(root), std::string("m.gltf: ") + message);
  }
  json unset = gltf_square();
  unset["accessors"][0].erase("bufferView");
  unset["accessors"][0]["count"] = 4'000'000'000;
  EXPECT_NE(refusal(unset).find("4000000000 rows are promised by a file of"), std::string::npos);
  EXPECT_EQ(complaint("m.gltf", "{\"asset\":"), "m.gltf: byte 9: the JSON is malformed");
  EXPECT_EQ(complaint("m.gltf", "[]"), "m.gltf: byte 0: the JSON is no object");
  EXPECT_EQ(complaint("m.gltf", std::string(100'000, '[')),
            "m.gltf: byte 100000: the JSON is malformed");
}

TEST_F(Gltf, OfWhichAPartIsMissingIsRefused) {
  const std::string bytes = as_binary(gltf_square(), square_bytes());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(is_accepted("m.glb", bytes.substr(0, size))) << size;
  }
  const std::string text = as_text(gltf_square(), square_bytes());
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_FALSE(is_accepted("m.gltf", text.substr(0, size))) << size;
  }
}

// A million places of one mesh, in some kilobytes.
TEST_F(Gltf, MeshesInVeryManyPlacesEndAtTheLimit) {
  json root = gltf_square();
  for (int i = 0; i < 1000; ++i) {
    root["nodes"].push_back({{"mesh", 0}});
    root["scenes"][0]["nodes"].push_back(i + 1);
  }
  const TemporaryFolder folder;
  const auto path = folder.write("m.gltf", as_text(root, square_bytes()));
  EXPECT_EQ(read(path).mesh.triangle_count(), 2002U);
  EXPECT_THROW((void)read(path, {false, 100'000}), InvalidInput);
}

TEST_F(Gltf, KeepsColoursNormalsAndTextureCoordinates) {
  const Mesh mesh = tetrahedron();
  Properties properties;
  properties.of_vertices = {{"red", std::vector<std::uint8_t>{1, 2, 3, 255}},
                            {"green", std::vector<std::uint8_t>{0, 0, 9, 9}},
                            {"blue", std::vector<std::uint8_t>{7, 7, 7, 7}},
                            {"nx", std::vector<float>{1, 0, 0, 0}},
                            {"ny", std::vector<float>{0, 1, 0, 1}},
                            {"nz", std::vector<float>{0, 0, 1, 0}},
                            {"s", std::vector<float>{0, 0.5, 1, 0.25}},
                            {"t", std::vector<float>{0, 0.5, 1, 0.75}}};
  const TemporaryFolder folder;
  for (const char* name : {"m.glb", "m.gltf", "m.glb.gz"}) {
    for (const bool has_alpha : {false, true}) {
      Properties given = properties;
      if (has_alpha) given.of_vertices.push_back({"alpha", std::vector<std::uint8_t>{0, 1, 2, 3}});
      write(folder.path() / name, mesh, given);
      const LoadedMesh same = read(folder.path() / name, {true});
      EXPECT_EQ(same.mesh.positions, mesh.positions);
      EXPECT_EQ(same.mesh.triangles, mesh.triangles);
      EXPECT_EQ(same.properties.of_vertices.size(), given.of_vertices.size());
      for (const Property& property : given.of_vertices) {
        const Property* found = find_property(same.properties.of_vertices, property.name);
        ASSERT_NE(found, nullptr) << property.name;
        for (std::size_t v = 0; v < 4; ++v) {
          EXPECT_EQ(value_at(*found, v), value_at(property, v)) << property.name;
        }
        EXPECT_EQ(has_integers(*found), is_colour_part(property.name));
      }
    }
  }
}

TEST(Base64, GoesBothWays) {
  std::string bytes;
  for (int i = 0; i < 70; ++i) {
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
    bytes += static_cast<char>(37 * i);
  }
  EXPECT_EQ(to_base64("Man"), "TWFu");
  EXPECT_EQ(to_base64("Ma"), "TWE=");
  EXPECT_EQ(to_base64("M"), "TQ==");
  EXPECT_EQ(to_base64("\xff\xfe\xfd\x80"), "//79gA==");
  EXPECT_EQ(from_base64("TWE"), "Ma");
  EXPECT_EQ(from_base64("T"), std::nullopt);
  EXPECT_EQ(from_base64("TW!u"), std::nullopt);
}

}  // namespace
}  // namespace geolloyd

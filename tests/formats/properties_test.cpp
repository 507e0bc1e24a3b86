// Properties of mesh files: read as they are, written as they were read.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/properties/properties.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

// Equal to the bit, so that numbers that are no numbers can be compared.
bool same_bits(const PropertyValues& a, const PropertyValues& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& values) {
        const auto& others = std::get<std::remove_cvref_t<decltype(values)>>(b);
        return values.size() == others.size() &&
               std::memcmp(values.data(), others.data(), values.size() * sizeof(values[0])) == 0;
      },
      a);
}

void expect_same(const std::vector<Property>& found, const std::vector<Property>& expected) {
  ASSERT_EQ(found.size(), expected.size()) << list_names(found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].name, expected[i].name);
    EXPECT_TRUE(same_bits(found[i].values, expected[i].values)) << found[i].name;
  }
}

template <class Number>
std::vector<Number> extremes() {
  using Limits = std::numeric_limits<Number>;
  if constexpr (std::is_integral_v<Number>) {
    return {Limits::min(), Limits::max(), Number{0}, Number{7}};
  } else {
    return {-Limits::infinity(), Limits::denorm_min(), Number{-0.0}, Number(0.1)};
  }
}

// A property of every type, four values each.
std::vector<Property> all_types() {
  std::vector<double> odd = extremes<double>();
  odd[3] = std::bit_cast<double>(0x7ff4000000abcdefU);  // a signalling NaN with a payload
  return {{"c", extremes<std::int8_t>()},  {"uc", extremes<std::uint8_t>()},
          {"s", extremes<std::int16_t>()}, {"us", extremes<std::uint16_t>()},
          {"i", extremes<std::int32_t>()}, {"ui", extremes<std::uint32_t>()},
          {"f", extremes<float>()},        {"d", odd}};
}

// Without the NaN, whose bits no text can hold.
std::vector<Property> all_types_of_text() {
  std::vector<Property> properties = all_types();
  properties.back().values = extremes<double>();
  return properties;
}

const Mesh corner_tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

enum class Encoding { ascii, little, big };

void append_number(const PropertyValues& values, std::size_t i, Encoding encoding,
                   std::string& bytes) {
  std::visit(
      [&](const auto& all) {
        const auto number = all[i];
        if (encoding == Encoding::ascii) {
          std::array<char, 64> text{};
          bytes.append(text.data(), std::to_chars(text.data(), text.data() + 64, number).ptr);
          bytes += ' ';
          return;
        }
        std::string raw(sizeof(number), '\0');
        std::memcpy(raw.data(), &all[i], sizeof(number));
        const auto order = encoding == Encoding::little ? std::endian::little : std::endian::big;
        if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
        bytes += raw;
      },
      values);
}

// The tetrahedron, with properties before and behind its coordinates and its corners.
std::string ply_of(const std::vector<Property>& properties, Encoding encoding) {
  const auto header = [&](std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t p = begin; p < end; ++p) {
      text += std::string("property ") + type_name(properties[p].values) + " " +
              properties[p].name + "\n";
    }
    return text;
  };
  const std::size_t half = properties.size() / 2;
  const char* name = encoding == Encoding::ascii    ? "ascii"
                     : encoding == Encoding::little ? "binary_little_endian"
                                                    : "binary_big_endian";
  std::string bytes =
      std::string("ply\nformat ") + name + " 1.0\nelement vertex 4\n" + header(0, half) +
      "property double x\nproperty double y\nproperty double z\n" +
      header(half, properties.size()) + "element face 4\n" + header(0, half) +
      "property list uchar int vertex_indices\n" + header(half, properties.size()) + "end_header\n";
  const auto append_row = [&](std::size_t row, const auto& append_middle) {
    for (std::size_t p = 0; p < half; ++p)
      append_number(properties[p].values, row, encoding, bytes);
    append_middle();
    for (std::size_t p = half; p < properties.size(); ++p) {
      append_number(properties[p].values, row, encoding, bytes);
    }
    if (encoding == Encoding::ascii) bytes += '\n';
  };
  for (std::size_t v = 0; v < 4; ++v) {
    append_row(v, [&] {
      for (const double x : corner_tetrahedron.positions[v]) {
        append_number(std::vector<double>{x}, 0, encoding, bytes);
      }
    });
  }
  for (std::size_t t = 0; t < 4; ++t) {
    append_row(t, [&] {
      append_number(std::vector<std::uint8_t>{3}, 0, encoding, bytes);
      for (const VertexId corner : corner_tetrahedron.triangles[t]) {
        append_number(std::vector<std::int32_t>{static_cast<std::int32_t>(corner)}, 0, encoding,
                      bytes);
      }
    });
  }
  return bytes;
}

class MeshProperties : public testing::Test {
 protected:
  [[nodiscard]] LoadedMesh load(const std::string& name, std::string_view bytes) const {
    return read(folder_.write(name, bytes), {true});
  }

  [[nodiscard]] Properties round_trip(const std::string& name, const Properties& properties) const {
    write(folder_.path() / name, corner_tetrahedron, properties);
    return read(folder_.path() / name, {true}).properties;
  }

  // Of the file, if properties are asked for; nothing is wrong with it if they are not.
  [[nodiscard]] std::string complaint(const std::string& name, std::string_view bytes) const {
    const auto path = folder_.write(name, bytes);
    EXPECT_TRUE(read(path).properties.empty());
    try {
      (void)read(path, {true});
      return {};
    } catch (const InvalidInput& error) {
      const std::string message = error.what();
      return message.substr(message.find(name));
    }
  }

  TemporaryFolder folder_;
};

TEST_F(MeshProperties, EveryTypeOfPlyKeepsItsBits) {
  for (const Encoding encoding : {Encoding::ascii, Encoding::little, Encoding::big}) {
    SCOPED_TRACE(static_cast<int>(encoding));
    const auto properties = encoding == Encoding::ascii ? all_types_of_text() : all_types();
    const LoadedMesh loaded = load("m.ply", ply_of(properties, encoding));
    EXPECT_EQ(loaded.mesh.positions, corner_tetrahedron.positions);
    EXPECT_EQ(loaded.mesh.triangles, corner_tetrahedron.triangles);
    expect_same(loaded.properties.of_vertices, properties);
    expect_same(loaded.properties.of_triangles, properties);
    EXPECT_TRUE(loaded.properties.left_out.empty());
    const Properties again = round_trip("again.ply", loaded.properties);
    expect_same(again.of_vertices, properties);
    expect_same(again.of_triangles, properties);
  }
}

TEST_F(MeshProperties, OfAFileThatWasCutOffAreRefused) {
  const std::string whole = ply_of(all_types(), Encoding::big);
  for (std::size_t size = whole.find("end_header"); size < whole.size(); ++size) {
    const auto path = folder_.write("m.ply", std::string_view(whole).substr(0, size));
    EXPECT_THROW((void)read(path, {true}), InvalidInput) << size;
  }
}

TEST_F(MeshProperties, AreReadOnRequestOnly) {
  const auto path = folder_.write("m.ply", ply_of(all_types(), Encoding::little));
  EXPECT_TRUE(read(path).properties.empty());
}

const std::string four_vertices =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\n";

TEST_F(MeshProperties, TextKeepsNumbersThatAreNone) {
  const LoadedMesh loaded =
      load("m.ply", four_vertices +
                        "property float q\nelement face 1\nproperty list uchar int vertex_indices\n"
                        "end_header\n0 0 0 nan\n1 0 0 -inf\n0 1 0 1e-60\n1 1 0 +0.1\n3 0 1 2\n");
  const auto& q = std::get<std::vector<float>>(loaded.properties.of_vertices.at(0).values);
  EXPECT_TRUE(std::isnan(q[0]));
  EXPECT_EQ(q[1], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(q[2], 0.0F);  // too small for a float
  EXPECT_EQ(q[3], 0.1F);
}

// Two triangles, a quadrilateral and a pentagon; concave ones are cut otherwise than in a fan.
TEST_F(MeshProperties, OfAPolygonAreThoseOfItsTriangles) {
  const LoadedMesh loaded =
      load("m.ply",
           "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
           "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
           "property int label\nend_header\n0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n"
           "3 0 1 3 7\n5 0 1 2 3 4 8\n4 0 1 2 3 9\n3 2 3 4 -1\n");
  ASSERT_EQ(loaded.mesh.triangle_count(), 7U);
  expect_same(loaded.properties.of_triangles,
              {{"label", std::vector<std::int32_t>{7, 8, 8, 8, 9, 9, -1}}});
}

TEST_F(MeshProperties, WhatCannotBeCarriedIsNamed) {
  const LoadedMesh loaded = load(
      "m.ply",
      four_vertices +
          "property list uchar float weights\nproperty int a\nproperty float a\nproperty int b\n"
          "element face 1\nproperty list uchar int vertex_indices\n"
          "property list uchar float texcoord\nelement edge 1\nproperty int k\nend_header\n"
          "0 0 0 2 .5 .5 1 2 3\n1 0 0 0 1 2 3\n0 1 0 1 1 1 2 3\n1 1 0 0 1 2 3\n3 0 1 2 2 0 0\n5\n");
  EXPECT_EQ(list_names(loaded.properties.of_vertices), "a, b");
  EXPECT_TRUE(loaded.properties.of_triangles.empty());
  EXPECT_EQ(loaded.properties.left_out,
            (std::vector<std::string>{
                "'weights' of vertices: a list", "'a' of vertices: the second one of this name",
                "'texcoord' of faces: a list", "element 'edge': neither vertices nor faces"}));
}

TEST_F(MeshProperties, MalformedOnesNameTheirLine) {
  const auto vertex = [&](const std::string& type, const std::string& value) {
    return complaint("m.ply", four_vertices + "property " + type +
                                  " q\nelement face 1\nproperty list uchar int vertex_indices\n"
                                  "end_header\n0 0 0 1\n1 0 0 " +
                                  value + "\n0 1 0 1\n1 1 0 1\n3 0 1 2\n");
  };
  EXPECT_EQ(vertex("int", "red"),
            "m.ply: line 12: expected property 'q', a number of type int, found 'red'");
  EXPECT_EQ(vertex("uchar", "256"),
            "m.ply: line 12: expected property 'q', a number of type uchar, found '256'");
  EXPECT_EQ(vertex("float", "1e39"),
            "m.ply: line 12: expected property 'q', a number of type float, found '1e39'");
  EXPECT_EQ(vertex("uint", "-1"),
            "m.ply: line 12: expected property 'q', a number of type uint, found '-1'");
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(complaint("m.obj", "v 0 0 0 1 0 red\n" + obj + "f 1 2 3\n"),
            "m.obj: line 1: expected a part of a colour, found 'red'");
  EXPECT_EQ(complaint("m.obj", obj + "vt x\nf 1 2 3\n"),
            "m.obj: line 4: expected a texture coordinate, found 'x'");
  EXPECT_EQ(complaint("m.obj", obj + "vn 0 0\nf 1 2 3\n"),
            "m.obj: line 4: expected a normal, found the end of the line");
  EXPECT_EQ(complaint("m.obj", obj + "vt 0 0\nf 1/1 2/2 3/1\n"),
            "m.obj: line 5: texture index 2 is out of range; there are 1");
  EXPECT_EQ(complaint("m.obj", obj + "f 1//-1 2//1 3//1\n"),
            "m.obj: line 4: expected a normal index, counted from 1, found '-1'");
  EXPECT_EQ(complaint("m.off", "COFF\n3 1 0\n0 0 0 1 2\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "m.off: line 3: the vertex has 2 numbers behind its position, which does not fit the "
            "file's first word");
  EXPECT_EQ(complaint("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 red\n"),
            "m.off: line 6: expected a number, found 'red'");
}

const std::string obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(MeshProperties, ObjHasColoursTextureCoordinatesAndNormals) {
  const LoadedMesh loaded =
      load("m.obj",
           "v 0 0 0 1 0 0.501961\nv 1 0 0 0 0 0 # black\nv 1 1 0 0.2 0.4 0.6\nv 0 1 0 1 1 1\n"
           "v 9 9 9 0 1 0\nvt 0 0\nvt 1 0\nvt 0.25 0.75\nvt 1 0\nvn 0 0 1\n"
           "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/-1 4/4/1\nf 4/2/1 3/-2/1 2/4/1\n");
  const double none = std::numeric_limits<double>::quiet_NaN();
  expect_same(loaded.properties.of_vertices,
              {{"red", std::vector<std::uint8_t>{255, 0, 51, 255, 0}},
               {"green", std::vector<std::uint8_t>{0, 0, 102, 255, 255}},
               {"blue", std::vector<std::uint8_t>{128, 0, 153, 255, 0}},
               {"nx", std::vector<double>{0, 0, 0, 0, none}},
               {"ny", std::vector<double>{0, 0, 0, 0, none}},
               {"nz", std::vector<double>{1, 1, 1, 1, none}},
               {"s", std::vector<double>{0, 1, 0.25, 1, none}},
               {"t", std::vector<double>{0, 0, 0.75, 0, none}}});
  EXPECT_TRUE(loaded.properties.left_out.empty());
}

TEST_F(MeshProperties, ObjSeamsAreNotCarried) {
  const LoadedMesh loaded = load("m.obj", obj_square +
                                              "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
                                              "f 1/1/1 2/2/1 3/3/1\nf 1/2/1 3/3/1 4/1\n");
  EXPECT_TRUE(loaded.properties.empty());
  EXPECT_EQ(loaded.properties.left_out,
            (std::vector<std::string>{
                "normals: 1 of 6 corners of faces have none",
                "texture coordinates: a vertex has one, and 1 of them have several, in different "
                "faces (a seam)"}));
}

TEST_F(MeshProperties, ObjColoursThatAreNoBytesStayAsTheyAre) {
  const LoadedMesh loaded =
      load("m.obj", "v 0 0 0 0.5 0 2\nv 1 0 0 0 0 0\nv 1 1 0 0.2 0.4 0.6\nf 1 2 3\n");
  expect_same(loaded.properties.of_vertices, {{"red", std::vector<double>{0.5, 0, 0.2}},
                                              {"green", std::vector<double>{0, 0, 0.4}},
                                              {"blue", std::vector<double>{2, 0, 0.6}}});
  const LoadedMesh some = load("m.obj", "v 0 0 0 1 1 1\nv 1 0 0\nv 1 1 0 1\nf 1 2 3\n");
  EXPECT_TRUE(some.properties.empty());
  EXPECT_EQ(some.properties.left_out,
            std::vector<std::string>{"colours of vertices: 2 of 3 vertices have none"});
  EXPECT_TRUE(load("m.obj", "v 0 0 0 1 1 1 1 1\nv 1 0 0 1\nv 1 1 0\nf 1 2 3\n").properties.empty());
}

TEST_F(MeshProperties, ObjGroupsAndMaterialsBecomeLabels) {
  const LoadedMesh loaded =
      load("m.obj", obj_square +
                        "g left arm\nusemtl steel\nf 1 2 3\ng right arm\nf 1 2 3 4\n"
                        "g left arm\nf 2 3 4\n");
  expect_same(loaded.properties.of_triangles, {{"group", std::vector<std::int32_t>{0, 1, 1, 0}}});
}

TEST_F(MeshProperties, OffHasColoursNormalsAndTextureCoordinates) {
  const LoadedMesh loaded =
      load("m.off",
           "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 7 128 0 0.5\n1 0 0 0 1 0 1 2 3 4 1 0.5 # two\n"
           "0 1 0 1 0 0 9 9 9 9 0 1\n3 0 1 2 10 20 30\n");
  expect_same(loaded.properties.of_vertices, {{"red", std::vector<std::uint8_t>{255, 1, 9}},
                                              {"green", std::vector<std::uint8_t>{0, 2, 9}},
                                              {"blue", std::vector<std::uint8_t>{7, 3, 9}},
                                              {"alpha", std::vector<std::uint8_t>{128, 4, 9}},
                                              {"nx", std::vector<double>{0, 0, 1}},
                                              {"ny", std::vector<double>{0, 1, 0}},
                                              {"nz", std::vector<double>{1, 0, 0}},
                                              {"s", std::vector<double>{0, 1, 0}},
                                              {"t", std::vector<double>{0.5, 0.5, 1}}});
  expect_same(loaded.properties.of_triangles, {{"red", std::vector<std::uint8_t>{10}},
                                               {"green", std::vector<std::uint8_t>{20}},
                                               {"blue", std::vector<std::uint8_t>{30}}});
}

std::vector<std::string> lost_in(const char* name, Properties properties) {
  const std::size_t before = properties.of_vertices.size() + properties.of_triangles.size();
  keep_writable(name, properties);
  const std::size_t after = properties.of_vertices.size() + properties.of_triangles.size();
  EXPECT_EQ(after == before, properties.left_out.empty());
  return properties.left_out;
}

Properties coloured() {
  Properties properties;
  properties.of_vertices = {{"red", std::vector<std::uint8_t>{0, 1, 128, 255}},
                            {"green", std::vector<std::uint8_t>{7, 8, 9, 254}},
                            {"blue", std::vector<std::uint8_t>{0, 0, 0, 2}},
                            {"nx", std::vector<double>{0.1, -0.0, 1, 0}},
                            {"ny", std::vector<double>{0, 1, 0, 1e-300}},
                            {"nz", std::vector<double>{0, 0, 0, 1}},
                            {"s", std::vector<double>{0, 0.3, 1, 2}},
                            {"t", std::vector<double>{0, 1.0 / 3, 1, 2}}};
  properties.of_triangles = {{"red", std::vector<std::uint8_t>{3, 200, 0, 1}},
                             {"green", std::vector<std::uint8_t>{3, 100, 0, 1}},
                             {"blue", std::vector<std::uint8_t>{3, 50, 0, 1}}};
  return properties;
}

TEST_F(MeshProperties, TextFormatsKeepWhatTheyCanHold) {
  const Properties properties = coloured();
  const Properties off = round_trip("m.off", properties);
  expect_same(off.of_vertices, properties.of_vertices);
  expect_same(off.of_triangles, properties.of_triangles);
  EXPECT_TRUE(lost_in("m.off", properties).empty());
  const Properties obj = round_trip("m.obj", properties);
  expect_same(obj.of_vertices, properties.of_vertices);
  EXPECT_TRUE(obj.of_triangles.empty());
  EXPECT_EQ(lost_in("m.obj", properties),
            std::vector<std::string>{
                "red, green, blue of triangles: OBJ has no place for them; PLY has"});
  EXPECT_TRUE(round_trip("m.stl", properties).empty());
  EXPECT_EQ(lost_in("m.stl", properties).size(), 2U);
  Properties labels;
  labels.of_vertices = {{"label", std::vector<std::int32_t>{1, 2, 3, 4}}};
  EXPECT_EQ(lost_in("m.off", labels),
            std::vector<std::string>{"label of vertices: OFF has no place for them; PLY has"});
}

TEST_F(MeshProperties, ReadAgainAsWrittenWhateverTheyAre) {
  for (const char* name : {"m.obj", "m.off"}) {
    Properties properties = coloured();
    properties.of_vertices[0].values = std::vector<float>{0.1F, 0, 1, 0.7F};
    properties.of_vertices[1].values = std::vector<float>{0.1F, 0, 1, 0.7F};
    properties.of_vertices[2].values = std::vector<float>{0.1F, 0, 1, 0.7F};
    const Properties again = round_trip(name, properties);
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_EQ(value_at(again.of_vertices[0], v), value_at(properties.of_vertices[0], v)) << name;
    }
  }
}

TEST_F(MeshProperties, LabelsOfRegionsLeaveNamesToThemselves) {
  Properties properties = coloured();
  properties.of_vertices.push_back({"input_red", std::vector<float>{1, 2, 3, 4}});
  const std::vector<Label> labels(4, Label{{1, 2, 3}, 5});
  FileWriter out(folder_.path() / "m.ply");
  write_labelled_ply(out, corner_tetrahedron, labels, {}, properties);
  out.commit();
  const Properties again = read(folder_.path() / "m.ply", {true}).properties;
  EXPECT_EQ(list_names(again.of_vertices),
            "red, green, blue, region, input_red, input_green, input_blue, nx, ny, nz, s, t, "
            "input_input_red");
  EXPECT_EQ(list_names(again.of_triangles), "red, green, blue");
  EXPECT_TRUE(same_bits(again.of_vertices[4].values, properties.of_vertices[0].values));
  EXPECT_TRUE(same_bits(again.of_vertices[12].values, properties.of_vertices[8].values));
}

TEST_F(MeshProperties, ThatDoNotFitAreRefused) {
  const auto refused = [&](const Properties& properties) {
    try {
      write(folder_.path() / "m.ply", corner_tetrahedron, properties);
      return std::string();
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
  };
  Properties properties;
  properties.of_vertices = {{"q", std::vector<float>{1, 2, 3}}};
  EXPECT_EQ(refused(properties), "property 'q' of vertices: 3 values for 4");
  properties.of_vertices = {{"q r", std::vector<float>{1, 2, 3, 4}}};
  EXPECT_EQ(refused(properties),
            "property 'q r' of vertices: a name has no blanks, and is not empty");
  properties.of_vertices = {{"q", std::vector<float>{1, 2, 3, 4}},
                            {"q", std::vector<float>{1, 2, 3, 4}}};
  EXPECT_EQ(refused(properties), "property 'q' of vertices: there is another one of this name");
}

// Few polygons of many corners, and many properties: what grows with both is left out.
TEST_F(MeshProperties, NeverTakeMemoryThatTheFileDoesNotWarrant) {
  constexpr std::size_t corners = 2000;
  constexpr std::size_t properties = 250;
  std::string bytes =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list int int vertex_indices\n";
  for (std::size_t i = 0; i < properties; ++i) {
    bytes.append("property double p").append(std::to_string(i)).append("\n");
  }
  bytes += "end_header\n0 0 0\n1 0 0\n0 1 0\n" + std::to_string(corners);
  for (std::size_t i = 0; i < corners; ++i) bytes.append(" ").append(std::to_string(i % 3));
  for (std::size_t i = 0; i < properties; ++i) bytes += " 1";
  const LoadedMesh loaded = load("m.ply", bytes + "\n");
  EXPECT_TRUE(loaded.properties.of_triangles.empty());
  ASSERT_EQ(loaded.properties.left_out.size(), 1U);
  EXPECT_NE(loaded.properties.left_out[0].find("they would outgrow the file"), std::string::npos);
}

}  // namespace
}  // namespace geolloyd

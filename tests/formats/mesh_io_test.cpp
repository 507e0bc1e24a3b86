#include "core/formats/mesh_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/formats/mesh_readers.h"
#include "core/mesh/mesh_measure.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tests/support/mesh_files.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

template <class Real, class Count, class Index>
std::string binary_ply(const std::string& types, std::endian order) {
  const bool is_little = order == std::endian::little;
  const std::string real = types.substr(0, types.find(' '));
  std::string bytes = std::string("ply\nformat binary_") + (is_little ? "little" : "big") +
                      "_endian 1.0\nelement vertex 4\nproperty " + real + " x\nproperty " + real +
                      " y\nproperty " + real + " z\nelement face 4\nproperty list" +
                      types.substr(types.find(' ')) + " vertex_indices\nend_header\n";
  const Mesh mesh = tetrahedron();
  for (const Vec3& position : mesh.positions) {
    for (const double x : position) bytes += raw(static_cast<Real>(x), order);
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes += raw(Count{3}, order);
    for (const VertexId v : triangle) bytes += raw(static_cast<Index>(v), order);
  }
  return bytes;
}

std::string little_ply() {
  return binary_ply<float, std::uint8_t, std::int32_t>("float uchar int", std::endian::little);
}

const std::string ascii_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string three_rows = "0 0 0\n1 0 0\n0 1 0\n";
const std::string off_start = "OFF\n3 1 0\n" + three_rows;
const std::string obj_start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string ascii_stl =
    "solid s\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 -0\n"
    "   vertex 0 1 0\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n"
    "   vertex 1 0 0\n   vertex 1 1e0 0\n   vertex -0 1 -0\n  endloop\n endfacet\nendsolid s\n";

class MeshIo : public MeshFiles {};

TEST_F(MeshIo, EveryFormatReadsBackWhatWasWritten) {
  for (const char* name : {"m.ply", "m.obj", "m.off", "m.stl", "M.PLY"}) {
    SCOPED_TRACE(name);
    expect_tetrahedron(name, written(name));
  }
}

TEST_F(MeshIo, TextFormatsKeepEveryBitOfACoordinate) {
  Mesh mesh = tetrahedron();
  mesh.positions[1] = {0.1, -1.0 / 3, 1e75};
  mesh.positions[2] = {5e-324, -0.0, std::nextafter(1.0, 2.0)};
  for (const char* name : {"m.obj", "m.off"}) {
    const Mesh again = round_trip(name, mesh);
    EXPECT_EQ(again.positions, mesh.positions);
    EXPECT_TRUE(std::signbit(again.positions[2].y()));
  }
}

TEST_F(MeshIo, WritersRefuseWhatTheirFormatCannotHold) {
  Mesh mesh = tetrahedron();
  mesh.positions[1].x() = 1e39;
  EXPECT_THROW((void)round_trip("m.stl", mesh), InvalidInput);
  EXPECT_EQ(round_trip("m.off", mesh).positions, mesh.positions);
  EXPECT_EQ(round_trip("m.ply", mesh).positions, mesh.positions);
  EXPECT_THROW((void)round_trip("m.xyz", mesh), InvalidInput);
}

TEST_F(MeshIo, BinaryPlyMayHaveAnyTypesInBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expect_tetrahedron("m.ply",
                       binary_ply<float, std::uint8_t, std::int32_t>("float uchar int", order));
    expect_tetrahedron(
        "m.ply", binary_ply<double, std::uint8_t, std::uint32_t>("float64 uint8 uint32", order));
    expect_tetrahedron("m.ply",
                       binary_ply<double, std::int32_t, std::uint16_t>("double int ushort", order));
    expect_tetrahedron(
        "m.ply", binary_ply<float, std::uint16_t, std::int16_t>("float32 uint16 int16", order));
    expect_tetrahedron("m.ply",
                       binary_ply<float, std::int8_t, std::uint8_t>("float char uchar", order));
    expect_tetrahedron("m.ply",
                       binary_ply<double, std::uint32_t, std::int8_t>("double uint int8", order));
  }
  EXPECT_EQ(load("m.ply", little_ply()).format, "PLY, binary little endian");
}

TEST_F(MeshIo, BinaryPlySkipsWhatNobodyAskedFor) {
  constexpr std::endian order = std::endian::big;
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\ncomment made by hand\r\nobj_info none\r\n"
      "element camera 2\r\nproperty list int double view\r\nproperty short id\r\n"
      "element face 1\r\nproperty uchar flag\r\nproperty list uchar short texture\r\n"
      "property list ushort uint vertex_index\r\nproperty list uchar float weight\r\n"
      "element vertex 4\r\nproperty short z\r\nproperty list uchar double near\r\n"
      "property double x\r\nproperty uchar red\r\nproperty float y\r\n"
      "element edge 1\r\nproperty int a\r\nend_header\r\n";
  bytes += raw(std::int32_t{1}, order) + raw(7.0, order) + raw(std::int16_t{1}, order);
  bytes += raw(std::int32_t{0}, order) + raw(std::int16_t{2}, order);
  bytes += "\1\2\1\2\3\4" + raw(std::uint16_t{4}, order);
  for (const std::uint32_t v : {3U, 2U, 1U, 0U}) bytes += raw(v, order);
  bytes += "\1" + raw(0.5F, order);
  for (const int v : {0, 1, 2, 3}) {
    bytes += raw(static_cast<std::int16_t>(v), order);
    bytes += v == 2 ? "\1" + raw(9.0, order) : std::string(1, '\0');
    bytes += raw(0.5 * v, order) + "\xff" + raw(-1.0F, order);
  }
  bytes += "edge and trailing bytes";
  const LoadedMesh loaded = load("m.ply", bytes);
  EXPECT_EQ(loaded.mesh.positions[3], Vec3(1.5, -1, 3));
  EXPECT_EQ(loaded.mesh.triangles, (Triangles{{3, 2, 1}, {3, 1, 0}}));
  EXPECT_EQ(loaded.polygon_count, 1U);
}

TEST_F(MeshIo, AsciiPlySkipsWhatNobodyAskedFor) {
  const LoadedMesh loaded = load(
      "m.ply",
      "ply\ncomment before\nformat ascii 1.0\nelement face 2\nproperty list uchar float w\n"
      "property list uchar int vertex_index\nproperty int flag\nelement edge 1\nproperty int a\n"
      "property list int int b\nelement vertex 4\nproperty float nx\nproperty double z\n"
      "property float y\nproperty float x\nend_header\n2 .5 .5 4 0 1 2 3 8\n\n0 3 0 2 2 8\r\n"
      "5 1 6\n0 3 2 1\n0 0 0 +1e0\n0 0 1 0\n0 0 1 1");
  EXPECT_EQ(loaded.mesh.positions[0], Vec3(1, 2, 3));
  EXPECT_EQ(loaded.mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(loaded.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 2}}));
  EXPECT_EQ(loaded.format, "PLY, ascii");
}

TEST_F(MeshIo, ObjTakesEveryFormOfAFace) {
  const LoadedMesh loaded =
      load("m.obj",
           "# a comment\nmtllib m.mtl\no thing\ng a b\ns off\nv 0 0 0 1.0\r\nv 1 0 0 # here\n"
           "v 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl red\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\n"
           "f 1/1/1 2/1/1 3/1/1\nf -3 -2 -1/-1\nf 1 2 \\\n3 \\\r\n 4 # later\nl 1 2\n\n"
           "f 1 2 3\\\n\nv 1 1 \\\n 0\nf 4 3 3");
  EXPECT_EQ(loaded.mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(loaded.mesh.triangles, (Triangles{{0, 1, 2},
                                              {0, 1, 2},
                                              {0, 1, 2},
                                              {0, 1, 2},
                                              {0, 1, 2},
                                              {0, 1, 2},
                                              {0, 2, 3},
                                              {0, 1, 2},
                                              {3, 2, 2}}));
  EXPECT_EQ(loaded.polygon_count, 1U);
}

TEST_F(MeshIo, OffTakesCountsCommentsAndExtraNumbersWhereTheyOccur) {
  const Triangles expected{{0, 1, 2}, {0, 2, 3}};
  const std::string body = "0 0 0 255 0 0 255\n1 0 0\n\n# between\n1 1 0\n0 1 0\n4 0 1 2 3 0.5 1\n";
  for (const char* start : {"OFF\n4 1 0\n", "OFF 4 1 0\n", "# first\n\nOFF # here\n# and\n4 1\n",
                            "COFF\n4 1 0\n", "NOFF\n4 1 0\n", "STCNOFF 4 1 0\n"}) {
    EXPECT_EQ(load("m.off", start + body).mesh.triangles, expected) << start;
  }
  EXPECT_EQ(load("m.off", "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n").mesh.triangles,
            (Triangles{{0, 1, 2}}));
  EXPECT_EQ(complaint("m.off", "OFF\r3 1 0\r0 0 0\r\r1 0 0\r0 1 x\r3 0 1 2\r"),
            "m.off: line 6: expected a coordinate, found 'x'");
}

TEST_F(MeshIo, StlWeldsEqualCornersInOrderOfAppearance) {
  const LoadedMesh ascii = load("m.stl", ascii_stl);
  EXPECT_EQ(ascii.mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(ascii.mesh.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(ascii.welded_corners, 2U);
  EXPECT_EQ(ascii.format, "STL, ascii");
  EXPECT_EQ(load("m.stl", written("m.stl")).welded_corners, 8U);
}

TEST_F(MeshIo, WeldingKeepsManyPointsApart) {
  Mesh mesh;
  for (VertexId v = 0; v < 9000; ++v) mesh.positions.emplace_back(v % 7, v % 11, v / 77);
  for (VertexId v = 0; v < 9000; v += 3) mesh.triangles.push_back({v, v + 1, v + 2});
  const Mesh again = round_trip("m.stl", mesh);
  EXPECT_EQ(again.positions, mesh.positions);
  EXPECT_EQ(again.triangles, mesh.triangles);
}

// The heights of a column differ only in bits that do not reach the slot of the reader's hash
// table: thousands of points want the same one.
TEST_F(MeshIo, WeldingKeepsCollidingPointsApart) {
  Mesh mesh;
  for (int column = 0; column < 15; ++column) {
    for (int exponent = -120; exponent < 120; ++exponent) {
      for (int eighth = 8; eighth < 16; ++eighth) {
        mesh.positions.emplace_back(column, 0, std::ldexp(eighth, exponent - 3));
        mesh.positions.emplace_back(column, 0, -std::ldexp(eighth, exponent - 3));
      }
    }
  }
  for (int turn = 0; turn < 2; ++turn) {
    for (VertexId v = 0; v < mesh.vertex_count(); v += 3) {
      mesh.triangles.push_back({v, v + 1, v + 2});
    }
  }
  const Mesh again = round_trip("m.stl", mesh);
  EXPECT_EQ(again.positions, mesh.positions);
  EXPECT_EQ(again.triangles, mesh.triangles);
}

TEST_F(MeshIo, BinaryStlMayBeginWithSolid) {
  std::string bytes = written("m.stl");
  bytes.replace(0, 6, "solid ");
  expect_tetrahedron("m.stl", bytes);
  EXPECT_EQ(load("m.stl", bytes).format, "STL, binary");
}

TEST_F(MeshIo, FacesThatNameAVertexTwiceAreKept) {
  EXPECT_EQ(load("m.off", off_start + "3 0 1 1\n").mesh.triangles, (Triangles{{0, 1, 1}}));
}

TEST_F(MeshIo, ComplaintsAboutAnyFormatSayWhere) {
  EXPECT_EQ(complaint("m.xyz", "?"),
            "m.xyz: unknown extension '.xyz'; .ply, .obj, .off, .stl, .glb, .gltf, .msh and .mesh "
            "are understood");
  for (const std::string name : {"m.ply", "m.obj", "m.off", "m.stl"}) {
    EXPECT_EQ(complaint(name, ""), name + ": byte 0: the file is empty");
    EXPECT_FALSE(is_accepted(name, std::string(300, '\0'))) << name;
  }
  EXPECT_THROW((void)read("no such folder/m.ply"), IoError);
  EXPECT_EQ(complaint("m.obj", "# nothing\n"), "m.obj: byte 10: the file ends without a vertex");
  EXPECT_EQ(complaint("m.obj", obj_start),
            "m.obj: byte 24: the file ends without a face; a point cloud has no surface to "
            "relax");
}

struct Hostile {
  const char* bytes;
  const char* message;
};

TEST_F(MeshIo, ComplaintsAboutOffNameTheLine) {
  for (const auto& [bytes, message] : std::initializer_list<Hostile>{
           {"OBJ\n", "line 1: expected 'OFF' with at most ST, C and N before it, found 'OBJ'"},
           {"4OFF\n", "line 1: expected 'OFF' with at most ST, C and N before it, found '4OFF'"},
           {"OFF BINARY\n", "line 1: binary OFF is not understood; save the mesh as text"},
           {"OFF\n", "line 2: expected the number of vertices, found the end of the file"},
           {"OFF\n-3 1 0\n", "line 2: the number of vertices is negative: -3"},
           {"OFF\n4000000000 1 0\n0 0 0\n",
            "line 2: 4000000000 vertices are promised, but the file ends after 7 more bytes"},
           {"OFF\n99999999999999999999 1 0\n",
            "line 2: expected the number of vertices, found '99999999999999999999'"},
           {"OFF\n1 9000000000000000000 0\n0 0 0\n",
            "line 2: 9000000000000000000 faces are promised, but the file ends after 7 more bytes"},
           {"OFF\n2 1 0\n0 0 0\n# nothing here\n", "line 5: the file ends after 1 of 2 vertices"},
           {"OFF\n2 1 0\n0 0\n0 0 0\n", "line 5: expected a coordinate, found the end of the file"},
           {"OFF\n1 1 0\n0 nan 0\n3 0 0 0\n", "line 3: a coordinate is not finite"},
           {"OFF\n1 1 0\n0 -inf 0\n3 0 0 0\n", "line 3: a coordinate is not finite"},
           {"OFF\n1 1 0\n0 1e999 0\n3 0 0 0\n", "line 3: expected a coordinate, found '1e999'"},
           {"OFF\n1 1 0\n0 1e76 0\n3 0 0 0\n",
            "line 3: a coordinate is beyond 1e75; scale the mesh down"},
           {"OFF\n1 1 0\n0 1,5 0\n3 0 0 0\n", "line 3: expected a coordinate, found '1,5'"},
           {"OFF\n1 1 0\n0 0 0\n2 0 0\n", "line 4: the face has 2 corners; it needs at least 3"},
           {"OFF\n1 1 0\n0 0 0\n-1 0 0\n", "line 4: the face has -1 corners; it needs at least 3"},
           {"OFF\n1 1 0\n0 0 0\n3 0 0\n",
            "line 5: expected a vertex index, found the end of the file"},
           {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
            "line 4: vertex index 1 is out of range; there are 1 vertices, counted from 0"},
           {"OFF\n1 1 0\n0 0 0\n3 0 0 -1\n",
            "line 4: vertex index -1 is out of range; there are 1 vertices, counted from 0"},
           {"COFF 1 1 0 0 0 0 1 1 1 3 0 0 0\n",
            "line 1: the file has fewer lines than vertices and faces, so nobody can tell how many "
            "numbers a colour has; give each vertex a line"},
           {"OFF\n0 0 0\n", "byte 10: the file ends without a vertex"},
       }) {
    EXPECT_EQ(complaint("m.off", bytes), std::string("m.off: ") + message);
  }
}

TEST_F(MeshIo, ComplaintsAboutObjNameTheLine) {
  for (const auto& [face, message] : std::initializer_list<Hostile>{
           {"f 1 2", "line 4: the face has 2 corners; it needs at least 3"},
           {"f 0 1 2", "line 4: expected a vertex index, counted from 1, found '0'"},
           {"f 1 2 x/3", "line 4: expected a vertex index, counted from 1, found 'x/3'"},
           {"f 1 2 /3", "line 4: expected a vertex index, counted from 1, found '/3'"},
           {"f 1 2 -4", "line 4: vertex index -4 is out of range; only 3 vertices stand before it"},
           {"f 1 2 3\nf 1 2 9\nf 1 2 4\n",
            "line 5: vertex index 9 is out of range; there are 3 vertices, counted from 1"},
           {"f 1 2 4294967297",
            "line 4: vertex index 4294967297 is out of range; there are 3 vertices, counted from "
            "1"},
           {"v 0 0", "line 4: expected a coordinate, found the end of the file"},
           {"v 0 0 inf", "line 4: a coordinate is not finite"},
           {"v 0 0 \x01;\x7f", "line 4: expected a coordinate, found '?;?'"},
       }) {
    EXPECT_EQ(complaint("m.obj", obj_start + face), std::string("m.obj: ") + message);
  }
}

TEST_F(MeshIo, ComplaintsAboutAPlyHeaderNameTheLine) {
  struct Change {
    const char* from;
    const char* to;
    const char* message;
  };
  for (const auto& [from, to, message] : std::initializer_list<Change>{
           {"ply", "plain", "line 1: expected 'ply', found 'plain'"},
           {"ascii", "binary",
            "line 2: expected ascii, binary_little_endian or binary_big_endian, found 'binary'"},
           {"format ascii 1.0\n", "", "line 8: the header has no format"},
           {"vertex 3", "vertex -3", "line 3: the number of elements is negative: -3"},
           {"vertex 3", "vertex 3e0", "line 3: expected the number of elements, found '3e0'"},
           {"element vertex 3\n", "", "line 3: a property before any element"},
           {"float y", "quad y",
            "line 5: expected a property type (char to uint, float, double, list), found 'quad'"},
           {"float y", "float ",
            "line 5: expected the name of a property, found the end of the line"},
           {"float y", "float t", "line 9: the header has no vertex property 'y'"},
           {"float y", "float x", "line 9: the header has more than one vertex property 'x'"},
           {"element vertex 3", "element edge 3", "line 9: the header has no element 'vertex'"},
           {"element face 1", "element edge 1", "line 9: the header has no element 'face'"},
           {"vertex_indices", "corners",
            "line 9: the header has no face property list 'vertex_indices'"},
           {"uchar int", "float int", "line 8: the count of a list must have an integer type"},
           {"uchar int", "uchar float", "line 8: vertex indices must have an integer type"},
           {"end_header", "comment\nelement user 4000000000\nend_header",
            "line 11: element 'user' has no properties"},
           {"end_header", "end", "line 9: expected a line of a PLY header, found 'end'"},
       }) {
    EXPECT_EQ(complaint("m.ply", with(ascii_header + three_rows + "3 0 1 2\n", from, to)),
              std::string("m.ply: ") + message);
  }
  EXPECT_EQ(complaint("m.ply", ascii_header.substr(0, ascii_header.find("end_header"))),
            "m.ply: line 9: the header has no end_header");
}

TEST_F(MeshIo, ComplaintsAboutAsciiPlyNameTheLine) {
  EXPECT_EQ(complaint("m.ply", with(ascii_header, "vertex 3", "vertex 4000000000") + three_rows),
            "m.ply: line 10: 4000000000 rows of element 'vertex' are promised, but the file ends "
            "after 18 more bytes");
  EXPECT_EQ(complaint("m.ply", ascii_header + "0 0 0\n1 0 NaN\n0 1 0\n3 0 1 2\n"),
            "m.ply: line 11: a coordinate is not finite");
  EXPECT_EQ(complaint("m.ply", ascii_header + "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"),
            "m.ply: line 11: more values than element 'vertex' has");
  EXPECT_EQ(complaint("m.ply", ascii_header + three_rows + "3 0 1 3\n"),
            "m.ply: line 13: vertex index 3 is out of range; there are 3 vertices, counted from 0");
  EXPECT_EQ(complaint("m.ply", ascii_header + three_rows + "\n\n"),
            "m.ply: line 15: the file ends after 0 of 1 rows of element 'face'");
  const std::string with_extra =
      with(ascii_header, "end_header", "property list int int extra\nend_header");
  EXPECT_EQ(complaint("m.ply", with_extra + three_rows + "3 0 1 2 -1\n"),
            "m.ply: line 14: a list has the negative length -1");
  EXPECT_EQ(complaint("m.ply", with_extra + three_rows + "3 0 1 2 1000000000000 1\n"),
            "m.ply: line 14: expected property 'extra', found the end of the line");
}

TEST_F(MeshIo, ComplaintsAboutBinaryPlyNameTheByte) {
  const std::string good = little_ply();
  const std::size_t body = good.find("end_header\n") + 11;
  const std::size_t faces = body + 48;
  const auto patched = [&](std::size_t at, const std::string& bytes) {
    return std::string(good).replace(at, bytes.size(), bytes);
  };
  const auto at = [](std::size_t byte) { return "m.ply: byte " + std::to_string(byte) + ": "; };
  constexpr std::endian little = std::endian::little;

  EXPECT_EQ(complaint("m.ply", with(good, "vertex 4\n", "vertex 4294967295\n")),
            at(body + 9) +
                "4294967295 rows of element 'vertex' are promised, but the file ends "
                "after 100 more bytes");
  EXPECT_EQ(complaint("m.ply", with(good, "face 4\n", "face 9000000000000000000\n")),
            at(faces + 18) +
                "9000000000000000000 rows of element 'face' are promised, but the "
                "file ends after 52 more bytes");
  EXPECT_EQ(complaint("m.ply",
                      patched(body + 12 + 4, raw(std::numeric_limits<float>::quiet_NaN(), little))),
            at(body + 12) + "a coordinate is not finite");
  EXPECT_EQ(complaint("m.ply", patched(faces + 13, "\2")),
            at(faces + 13) + "the face has 2 corners; it needs at least 3");
  EXPECT_EQ(complaint("m.ply", patched(faces + 13, "\xff")),
            at(faces + 13) + "the file ends inside the row that begins here");
  EXPECT_EQ(
      complaint("m.ply", patched(faces + 14, raw(std::int32_t{-1}, little))),
      at(faces + 13) + "vertex index -1 is out of range; there are 4 vertices, counted from 0");
  EXPECT_EQ(
      complaint("m.ply", patched(faces + 14, raw(std::int32_t{4}, little))),
      at(faces + 13) + "vertex index 4 is out of range; there are 4 vertices, counted from 0");
  EXPECT_EQ(complaint("m.ply", patched(faces, "\xff").replace(good.find("uchar"), 5, "char ")),
            at(faces) + "the face has -1 corners; it needs at least 3");
  const std::string extra = with(good, "end_header", "property list char uchar extra\nend_header");
  EXPECT_EQ(complaint("m.ply", std::string(extra).replace(extra.size() - 39, 1, "\xff")),
            at(extra.size() - 52) + "a list has the negative length -1");
}

TEST_F(MeshIo, ComplaintsAboutStlSayWhere) {
  const std::string good = written("m.stl");
  EXPECT_EQ(complaint("m.stl", good.substr(0, 80)),
            "m.stl: byte 80: the file ends inside the header of a binary STL");
  EXPECT_EQ(
      complaint("m.stl", good.substr(0, 200)),
      "m.stl: byte 200: the file ends here, but its header promises 4 triangles in 284 bytes");
  EXPECT_EQ(complaint("m.stl", std::string(good).replace(80, 4, "\xff\xff\xff\xff")),
            "m.stl: byte 284: the file ends here, but its header promises 4294967295 triangles in "
            "214748364834 bytes");
  std::string infinite = good;
  infinite.replace(84 + 50 + 16, 4,
                   raw(std::numeric_limits<float>::infinity(), std::endian::little));
  EXPECT_EQ(complaint("m.stl", infinite), "m.stl: byte 134: a coordinate is not finite");
  EXPECT_EQ(complaint("m.stl", with(ascii_stl, "   vertex 0 0 0\n", "")),
            "m.stl: line 6: the face has 2 corners; it needs at least 3");
  EXPECT_EQ(complaint("m.stl", with(ascii_stl, "1e0", "1e77")),
            "m.stl: line 12: a coordinate is beyond 1e75; scale the mesh down");
  EXPECT_EQ(complaint("m.stl", with(ascii_stl, "facet", "faucet")),
            "m.stl: line 2: expected a line of an ascii STL, found 'faucet'");
  EXPECT_EQ(complaint("m.stl", ascii_stl.substr(0, ascii_stl.rfind("  endloop"))),
            "m.stl: line 14: the file ends inside a facet");
}

TEST_F(MeshIo, NoPartOfABinaryFileIsTakenForTheWhole) {
  const std::string stl = written("m.stl");
  for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
           {"m.ply", little_ply()},
           {"m.ply",
            binary_ply<double, std::int32_t, std::uint16_t>("double int ushort", std::endian::big)},
           {"m.stl", stl},
           {"m.stl", "solid" + stl.substr(5)}}) {
    EXPECT_TRUE(is_accepted(name, bytes));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_FALSE(is_accepted(name, std::string_view(bytes).substr(0, size))) << name << size;
    }
  }
}

TEST_F(MeshIo, AnyPartOfATextFileIsRefusedOrSound) {
  for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
           {"m.ply", ascii_header + three_rows + "3 0 1 2\n"},
           {"m.off", written("m.off")},
           {"m.obj", written("m.obj")},
           {"m.stl", ascii_stl}}) {
    EXPECT_TRUE(is_accepted(name, bytes));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      (void)is_accepted(name, std::string_view(bytes).substr(0, size));
    }
  }
}

TEST_F(MeshIo, MutatedFilesAreRefusedOrSound) {
  std::mt19937 random(20240229);  // the standard fixes its sequence, unlike a distribution's
  for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
           {"m.ply", little_ply()},
           {"m.ply",
            binary_ply<double, std::int8_t, std::uint16_t>("double char ushort", std::endian::big)},
           {"m.ply", ascii_header + three_rows + "3 0 1 2\n"},
           {"m.off", off_start + "3 0 1 2\n"},
           {"m.obj", obj_start + "f 1/1 2/2 \\\n -1\n"},
           {"m.stl", written("m.stl")},
           {"m.stl", ascii_stl}}) {
    constexpr std::size_t rounds = 1000;
    std::size_t accepted = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
      std::string mutated = bytes;
      for (auto changes = 1 + random() % 3; changes > 0; --changes) {
        const std::size_t at = random() % mutated.size();
        const std::size_t removed = random() % 2;
        mutated.replace(at, removed, random() % 3 != 0, static_cast<char>(random() % 256));
      }
      if (is_accepted(name, mutated)) ++accepted;
    }
    EXPECT_GT(accepted, 0U) << name;
    EXPECT_LT(accepted, rounds) << name;
  }
}

TEST(MeshFile, PassesOverAByteOrderMark) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.obj", "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read(path).mesh.vertex_count(), 3U);
}

TEST(MeshFile, ReadsAsciiStlInCapitalsAfterABlankLine) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.stl",
                                 "\n SOLID x\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\n"
                                 "VERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID x\n");
  EXPECT_EQ(read(path).mesh.triangle_count(), 1U);
}

TEST(MeshFile, RefusesAMeshTooSmallToHaveAnArea) {
  const TemporaryFolder folder;
  const std::string faces = "3 1 0\n0 0 0\n1e-90 0 0\n0 1e-90 0\n3 0 1 2\n";
  EXPECT_THROW((void)read(folder.write("a.off", "OFF\n" + faces)), InvalidInput);
}

TEST(MeshFile, WritesPlyWithoutLosingADigit) {
  const TemporaryFolder folder;
  const Mesh mesh{{{1e7, 0.1, 0}, {1e7 + 0.1, 0, 0}, {1e7, 0, 1e-80}}, {{0, 1, 2}}};
  write(folder.path() / "a.ply", mesh);
  EXPECT_EQ(read(folder.path() / "a.ply").mesh.positions, mesh.positions);
}

TEST(MeshFile, WritesLabelsThatOtherReadersSkip) {
  const TemporaryFolder folder;
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<Label> of_vertices = {{{1, 2, 3}, 0}, {{4, 5, 6}, 1}, {{7, 8, 9}, -1}};
  const std::vector<Label> of_triangles = {{{10, 11, 12}, 7}};
  FileWriter out(folder.path() / "a.ply");
  write_labelled_ply(out, mesh, of_vertices, of_triangles);
  out.commit();
  const Mesh again = read(folder.path() / "a.ply").mesh;
  EXPECT_EQ(again.positions, mesh.positions);
  EXPECT_EQ(again.triangles, mesh.triangles);
  const std::string bytes = read_file(folder.path() / "a.ply");
  EXPECT_EQ(bytes.substr(bytes.size() - 7), std::string("\x0a\x0b\x0c\x07\0\0\0", 7));
}

struct PlanePolygon {
  std::vector<Vec3> corners;
  double area;
};

// A corridor of width 1 that winds inward: ears are at its two ends only. (A face of the binary
// file below has 255 corners at most.)
std::pair<std::vector<std::array<double, 2>>, double> spiral(int turns) {
  std::vector<std::array<double, 2>> outer;
  std::vector<std::array<double, 2>> inner;
  double area = 0;
  std::array<double, 2> at = {0, 0};
  const std::array<std::array<double, 2>, 4> along = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (int i = 0; i < turns; ++i) {
    const auto& [dx, dy] = along[static_cast<std::size_t>(i % 4)];
    const double length = 2.0 * (turns - i) + 1;
    outer.push_back(at);
    // The inner corner lies one to the left of this side and one to the left of the last one.
    const auto& [bx, by] = along[static_cast<std::size_t>((i + 3) % 4)];
    inner.push_back(i == 0 ? std::array{at[0] - dy, at[1] + dx}
                           : std::array{at[0] - dy - by, at[1] + dx + bx});
    at = {at[0] + dx * length, at[1] + dy * length};
    area += i == 0 ? length : length - 1;
  }
  const auto& [dx, dy] = along[static_cast<std::size_t>((turns - 1) % 4)];
  outer.push_back(at);
  outer.push_back({at[0] - dy, at[1] + dx});
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return {outer, area};
}

// A letter L, the same from its inner corner's neighbour, a star, and a square with a slit to a
// square hole, spirals, in a slanted plane; forward and backward.
std::vector<PlanePolygon> concave_polygons() {
  const std::vector<std::pair<std::vector<std::array<double, 2>>, double>> flat = {
      {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3},
      {{{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}}, 3},
      {{{2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}}, 3},
      {{{0, 4}, {-1, 1}, {-4, 0}, {-1, -1}, {0, -4}, {1, -1}, {4, 0}, {1, 1}}, 16},
      {{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}, 8},
      spiral(5),
      spiral(40),
      spiral(100)};
  std::vector<PlanePolygon> polygons;
  for (const auto& [points, area] : flat) {
    PlanePolygon polygon{{}, 9 * area};  // along (1, 2, 2) and (-2, -1, 2), both of length 3
    for (const auto& [x, y] : points) {
      polygon.corners.emplace_back(x - 2 * y, 2 * x - y, 2 * x + 2 * y);
    }
    polygons.push_back(polygon);
    std::reverse(polygon.corners.begin(), polygon.corners.end());
    polygons.push_back(polygon);
  }
  return polygons;
}

std::string rows(const PlanePolygon& polygon, const std::string& opening) {
  std::string text;
  for (const Vec3& p : polygon.corners) {
    text += opening + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
            std::to_string(p.z()) + "\n";
  }
  return text;
}

std::string face(const PlanePolygon& polygon, std::size_t first) {
  std::string text;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    text += std::string(" ").append(std::to_string(first + i));
  }
  return text + "\n";
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) area += triangle_area(mesh, t);
  return area;
}

TEST(Polygons, ConcaveOnesKeepTheirAreaInAllFormats) {
  for (const PlanePolygon& polygon : concave_polygons()) {
    const std::string n = std::to_string(polygon.corners.size());
    const std::string vertex =
        "element vertex " + n + "\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string row = n + face(polygon, 0);
    const std::string ply = "ply\nformat ascii 1.0\n";
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + vertex + faces + "end_header\n";
    for (const Vec3& p : polygon.corners) {
      for (const double x : p) binary += raw(static_cast<float>(x), std::endian::little);
    }
    binary += raw(static_cast<std::uint8_t>(polygon.corners.size()), std::endian::little);
    for (std::int32_t i = 0; i < std::ssize(polygon.corners); ++i) {
      binary += raw(i, std::endian::little);
    }
    const std::string obj_face = std::string("f").append(face(polygon, 1));
    const std::vector<std::pair<MeshFormat, std::string>> files = {
        {MeshFormat::off, "OFF\n" + n + " 1 0\n" + rows(polygon, "") + row},
        {MeshFormat::obj, rows(polygon, "v ") + obj_face},
        {MeshFormat::obj, obj_face + rows(polygon, "v ")},
        {MeshFormat::ply, ply + vertex + faces + "end_header\n" + rows(polygon, "") + row},
        {MeshFormat::ply, ply + faces + vertex + "end_header\n" + row + rows(polygon, "")},
        {MeshFormat::ply, binary}};
    for (const auto& [format, bytes] : files) {
      const LoadedMesh loaded = parse_mesh(format, bytes, "polygon");
      EXPECT_EQ(loaded.polygon_count, 1U);
      EXPECT_EQ(loaded.mesh.triangle_count(), polygon.corners.size() - 2);
      EXPECT_NEAR(area_of(loaded.mesh), polygon.area, 1e-9) << bytes;
      Vec3 normal = Vec3::Zero();
      for (const auto& [a, b, c] : loaded.mesh.triangles) {
        const auto& p = loaded.mesh.positions;
        normal += 0.5 * cross(p[b] - p[a], p[c] - p[a]);
      }
      EXPECT_NEAR(norm(normal), polygon.area, 1e-9);  // none turned over
    }
  }
}

TEST(Polygons, ConvexAndCrossedOnesAreFans) {
  const auto triangles_of = [](const std::string& corners, int count) {
    return parse_mesh(MeshFormat::off,
                      "OFF\n" + std::to_string(count) + " 1 0\n" + corners + std::to_string(count) +
                          " 0 1 2 3" + (count > 4 ? " 4" : "") + "\n",
                      "polygon")
        .mesh.triangles;
  };
  const std::vector<Triangle> fan4 = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Triangle> fan5 = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(triangles_of("0 0 0\n1 0 0\n1 1 0\n0 1 0\n", 4), fan4);
  EXPECT_EQ(triangles_of("0 0 0\n2 0 0\n3 1 0\n1 3 0\n-1 1 0\n", 5), fan5);
  EXPECT_EQ(triangles_of("0 0 0\n1 1 0\n1 0 0\n0 1 0\n", 4), fan4);  // no area: an hourglass
  EXPECT_EQ(triangles_of("0 0 0\n1 0 0\n2 0 0\n3 0 0\n", 4), fan4);  // a line
  EXPECT_EQ(triangles_of("0 0 0\n4 0 0\n1 1 2\n0 4 0\n", 4), fan4);  // not flat
}

}  // namespace
}  // namespace geolloyd

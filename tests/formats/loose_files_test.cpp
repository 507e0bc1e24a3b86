// Files as other programs write them: words of OFF on any line, strips of triangles in PLY.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "tests/support/mesh_files.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

class LooseFiles : public MeshFiles {};

TEST_F(LooseFiles, OffTakesWordsWhateverLinesTheyStandOn) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Triangles expected{{0, 1, 2}, {0, 2, 3}};
  for (const char* bytes : {
           "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",  // no first word
           "# a comment\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
           "OFF 4 2 0 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3",
           "OFF\n4 2 0\n0 0 0 1 0\n0 1 1 0 0\n1 0 3 0 1 2\n3 0 2 3\n",
           "OFF\n4\n2\n0\n0\n0\n0\n1\n0\n0\n1\n1\n0\n0\n1\n0\n3 0\n1 2\n3\n0\n2\n3\n",
           "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3\n0 # here\n1\n2\n3\n0 2\n3\n",
           "NOFF 4 2 0 0 0 0 9 9 9 1 0 0 9 9 9\n1 1 0 9 9 9 0 1 0 9 9\n9 3 0 1 2 3 0 2 3",
       }) {
    const Mesh mesh = load("m.off", bytes).mesh;
    EXPECT_EQ(mesh.positions, square) << bytes;
    EXPECT_EQ(mesh.triangles, expected) << bytes;
  }
}

// A polygon of all vertices, twice, and a triangle, as programs wrap them that know no lines.
TEST_F(LooseFiles, OffMayBeWrapped) {
  constexpr int corners = 30;
  std::vector<std::string> words;
  for (int i = 0; i < corners; ++i) {
    for (const int x : {i, i * i, 0}) words.push_back(std::to_string(x));
  }
  for (int face = 0; face < 2; ++face) {
    words.push_back(std::to_string(corners));
    for (int i = 0; i < corners; ++i) words.push_back(std::to_string(i));
  }
  for (const char* word : {"3", "0", "1", "2"}) words.emplace_back(word);
  const auto wrapped = [&](std::size_t width) {
    std::string text = "OFF\n" + std::to_string(corners) + " 3 0";
    for (std::size_t i = 0; i < words.size(); ++i) text += (i % width == 0 ? "\n" : " ") + words[i];
    return text + "\n";
  };
  const Mesh expected = load("m.off", wrapped(words.size())).mesh;
  ASSERT_EQ(expected.triangle_count(), 2U * (corners - 2) + 1);
  for (std::size_t width = 1; width < words.size(); ++width) {
    const Mesh mesh = load("m.off", wrapped(width)).mesh;
    EXPECT_EQ(mesh.positions, expected.positions) << width;
    EXPECT_EQ(mesh.triangles, expected.triangles) << width;
  }
  words[3 * corners + corners + 2] = "99";  // the first corner of the second polygon
  const std::string message =
      "vertex index 99 is out of range; there are 30 vertices, counted from 0";
  EXPECT_EQ(complaint("m.off", wrapped(4)), "m.off: line 33: " + message);
  EXPECT_EQ(complaint("m.off", wrapped(1)), "m.off: line 125: " + message);
}

// Whether all faces have one or not.
TEST_F(LooseFiles, OffHasColoursOnTheLastLineOfAFace) {
  const std::string vertices = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const TemporaryFolder folder;
  const auto read_faces = [&](const char* faces) {
    return read(folder.write("m.off", vertices + faces), {true});
  };
  for (const char* faces :
       {"3 0 1 2 9 8 7\n3 0 2 3 6 5 4\n", "3 0\n1 2 9 8 7\n3\n0 2\n3 6 5 4 # f\n"}) {
    const LoadedMesh loaded = read_faces(faces);
    EXPECT_EQ(loaded.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(loaded.properties.of_triangles.size(), 3U) << faces;
    EXPECT_EQ(loaded.properties.of_triangles[1].values,
              PropertyValues(std::vector<std::uint8_t>{8, 5}));
  }
  const LoadedMesh partly = read_faces("3 0 1 2 9 8 7\n3 0 2 3\n");
  EXPECT_EQ(partly.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(partly.properties.left_out,
            std::vector<std::string>{"colours of faces: 1 of 2 faces have none"});
}

const std::string strip_header =
    "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";

// Of five vertices, two strips: the second one begins behind -1, and its first joint names a vertex
// twice.
TEST_F(LooseFiles, PlyMayHaveStripsOfTriangles) {
  const std::vector<std::int32_t> strip{0, 1, 2, 3, -1, 4, 2, 2, 1, 0, -1, 0, 1};
  const Triangles expected{{0, 1, 2}, {2, 1, 3}, {2, 1, 0}};
  const std::string rows = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n";
  std::string ascii = "ply\nformat ascii 1.0\n" + strip_header + rows + "13";
  for (const std::int32_t index : strip) ascii.append(" ").append(std::to_string(index));
  EXPECT_EQ(load("m.ply", ascii + "\n").mesh.triangles, expected);
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string bytes = std::string("ply\nformat binary_") +
                        (order == std::endian::little ? "little" : "big") + "_endian 1.0\n" +
                        strip_header;
    for (const float x :
         {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 1.F, 1.F, 0.F, 2.F, 2.F, 0.F})
      bytes += raw(x, order);
    bytes += raw(static_cast<std::int32_t>(strip.size()), order);
    for (const std::int32_t index : strip) bytes += raw(index, order);
    EXPECT_EQ(load("m.ply", bytes).mesh.triangles, expected);
    EXPECT_EQ(load("m.ply", with(bytes, "list int int", "list int uint")).mesh.triangles, expected);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_FALSE(is_accepted("m.ply", bytes.substr(0, size))) << size;
    }
  }
  EXPECT_EQ(complaint("m.ply", with(ascii, "4 2", "5 2")),
            "m.ply: line 15: vertex index 5 is out of range; there are 5 vertices, counted from 0");
  EXPECT_EQ(complaint("m.ply", with(ascii, "13 0", "-2 0")),
            "m.ply: line 15: a list has the negative length -2");
  EXPECT_EQ(complaint("m.ply", with(ascii, "vertex_indices", "corners")),
            "m.ply: line 9: the header has no tristrips property list 'vertex_indices'");
}

TEST_F(LooseFiles, PlyMayHaveFacesAndStrips) {
  const std::string bytes =
      "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list uchar int vertex_indices\n"
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\nend_header\n"
      "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 1 3 2 7\n";
  const TemporaryFolder folder;
  const LoadedMesh loaded = read(folder.write("m.ply", bytes), {true});
  EXPECT_EQ(loaded.mesh.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_TRUE(loaded.properties.of_triangles.empty());
  EXPECT_EQ(loaded.properties.left_out,
            std::vector<std::string>{"properties of faces: triangles of strips have none"});
}

}  // namespace
}  // namespace geolloyd

// Gmsh and medit: text and bytes that other programs write, labels, and complaints that say where.
// VTP, read by a checker of our own.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/formats/mesh_readers.h"
#include "core/properties/properties.h"
#include "core/text/file_io.h"
#include "tests/support/mesh_files.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

const std::string medit_text =
    "MeshVersionFormatted 1\n# a comment\nDimension\n3\nCorners 1\n1\nVertices\n4\n0 0 0 0\n1 0 0 "
    "0\n"
    "1 1 0 0\n0 1 0 0\nEdges 1\n1 2 7\nTriangles\n2\n1 2 3 5\n1 3 4 6\nTetrahedra\n0\nEnd\n";

const std::string gmsh_text_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"a $Nodes "
    "b\"\n$EndPhysicalNames\n"
    "$Nodes\n4\n10 0 0 0\n2 1 0 0\n7 1 1 0\n4 0 1 0\n$EndNodes\n"
    "$Elements\n4\n1 15 2 0 1 10\n2 1 2 0 1 10 2\n3 2 2 8 1 10 2 7\n4 2 2 9 1 10 7 "
    "4\n$EndElements\n";

const std::string gmsh_text_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 4 1 4\n1 1 1 2\n1\n2\n0 0 0 0.5\n1 0 0 0.75\n"
    "2 1 0 2\n3\n4\n1 1 0\n0 1 0\n$EndNodes\n"
    "$Elements\n3 3 1 3\n1 1 1 1\n1 1 2\n2 5 2 1\n2 1 2 3\n2 6 2 1\n3 1 3 4\n$EndElements\n";

std::string gmsh_bytes_2(std::endian order) {
  std::string bytes =
      "$MeshFormat\n2.2 1 8\n" + raw(std::int32_t{1}, order) + "\n$EndMeshFormat\n$Nodes\n4\n";
  const std::vector<std::vector<double>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (std::size_t v = 0; v < 4; ++v) {
    bytes += raw(static_cast<std::int32_t>(v + 1), order);
    for (const double x : points[v]) bytes += raw(x, order);
  }
  bytes += "\n$EndNodes\n$Elements\n3\n";
  for (const std::int32_t x : {1, 1, 1, 1, 7, 1, 2, 2, 2, 2, 2, 8, 1, 1, 2, 3, 3, 9, 1, 1, 3, 4}) {
    bytes += raw(x, order);
  }
  return bytes + "\n$EndElements\n";
}

std::string gmsh_bytes_4(std::endian order) {
  const auto sizes = [&](const std::vector<std::int64_t>& numbers) {
    std::string bytes;
    for (const std::int64_t x : numbers) bytes += raw(x, order);
    return bytes;
  };
  const auto ints = [&](const std::vector<std::int32_t>& numbers) {
    std::string bytes;
    for (const std::int32_t x : numbers) bytes += raw(x, order);
    return bytes;
  };
  std::string bytes = "$MeshFormat\n4.1 1 8\n" + ints({1}) + "\n$EndMeshFormat\n$Nodes\n";
  bytes += sizes({1, 4, 1, 4}) + ints({2, 1, 0}) + sizes({4, 1, 2, 3, 4});
  for (const double x : {0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.}) bytes += raw(x, order);
  bytes += "\n$EndNodes\n$Elements\n" + sizes({2, 2, 1, 2}) + ints({2, 5, 2}) +
           sizes({1, 1, 1, 2, 3}) + ints({2, 6, 2}) + sizes({1, 2, 1, 3, 4});
  return bytes + "\n$EndElements\n";
}

class LabelFormats : public MeshFiles {
 protected:
  void expect_labelled_square(const char* name, const std::string& bytes, const char* property,
                              const std::vector<std::int32_t>& labels) const {
    const TemporaryFolder folder;
    const LoadedMesh loaded = read(folder.write(name, bytes), {true});
    EXPECT_EQ(loaded.mesh.positions,
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(loaded.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    const Property* found = find_property(loaded.properties.of_triangles, property);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(std::get<std::vector<std::int32_t>>(found->values), labels);
  }
};

TEST_F(LabelFormats, AreReadWithTheirLabels) {
  expect_labelled_square("m.mesh", medit_text, "ref", {5, 6});
  expect_labelled_square("m.msh", gmsh_text_2, "physical", {8, 9});
  expect_labelled_square("m.msh", gmsh_text_4, "entity", {5, 6});
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expect_labelled_square("m.msh", gmsh_bytes_2(order), "physical", {8, 9});
    expect_labelled_square("m.msh", gmsh_bytes_4(order), "entity", {5, 6});
  }
}

TEST_F(LabelFormats, HaveQuadrilateralsToo) {
  const Triangles expected{{0, 1, 2}, {0, 2, 3}};
  const std::string medit =
      with(medit_text, "Triangles\n2\n1 2 3 5\n1 3 4 6", "Quadrilaterals\n1\n1 2 3 4 5");
  EXPECT_EQ(load("m.mesh", medit).mesh.triangles, expected);
  EXPECT_EQ(load("m.mesh", medit).polygon_count, 1U);
  const std::string gmsh =
      with(gmsh_text_2, "3 2 2 8 1 10 2 7\n4 2 2 9 1 10 7 4", "3 3 2 8 1 10 2 7 4\n4 15 0 2");
  EXPECT_EQ(load("m.msh", gmsh).mesh.triangles, expected);
}

TEST_F(LabelFormats, KeepALabelAndEveryDigit) {
  Mesh mesh = tetrahedron();
  mesh.positions[1] = {0.1, 1e-70, -1.0 / 3};
  Properties properties;
  properties.of_triangles = {{"region", std::vector<std::int32_t>{3, 1, 4, 1}}};
  const TemporaryFolder folder;
  for (const char* name : {"m.mesh", "m.msh", "m.msh.zst"}) {
    const auto path = folder.path() / name;
    write(path, mesh, properties);
    const LoadedMesh same = read(path, {true});
    EXPECT_EQ(same.mesh.positions, mesh.positions) << name;
    EXPECT_EQ(same.mesh.triangles, mesh.triangles) << name;
    ASSERT_FALSE(same.properties.of_triangles.empty()) << name;
    EXPECT_EQ(same.properties.of_triangles[0].values, properties.of_triangles[0].values) << name;
    write(path, mesh);
    EXPECT_TRUE(read(path, {true}).properties.empty()) << name;
  }
}

TEST_F(LabelFormats, ComplaintsSayWhere) {
  EXPECT_EQ(complaint("m.mesh", "OFF"),
            "m.mesh: line 1: expected 'MeshVersionFormatted', found 'OFF'");
  EXPECT_EQ(complaint("m.mesh", with(medit_text, "\n3\n", "\n4\n")),
            "m.mesh: line 4: a mesh of dimension 4; 2 and 3 are understood");
  EXPECT_EQ(
      complaint("m.mesh", with(medit_text, "1 3 4 6", "1 3 5 6")),
      "m.mesh: line 18: vertex index 5 is out of range; there are 4 vertices, counted from 1");
  EXPECT_EQ(
      complaint("m.mesh", with(medit_text, "Vertices\n4", "Vertices\n4000000000")),
      "m.mesh: line 8: 4000000000 vertices are promised, but the file ends after 92 more bytes");
  EXPECT_EQ(complaint("m.mesh", with(medit_text, "1 1 0 0", "1 nan 0 0")),
            "m.mesh: line 11: a coordinate is not finite");
  EXPECT_EQ(complaint("m.msh", with(gmsh_text_2, "2.2 0", "3 0")),
            "m.msh: line 2: Gmsh's format '3'; 2.2 and 4.1 are understood");
  EXPECT_EQ(complaint("m.msh", with(gmsh_text_2, "$Elements", "$Other")),
            "m.msh: byte " + std::to_string(gmsh_text_2.size() - 3) +
                ": the file has no section '$Elements'");
  EXPECT_EQ(complaint("m.msh", with(gmsh_text_2, "10 7 4\n", "10 7 3\n")),
            "m.msh: line 20: there is no node 3");
  EXPECT_EQ(
      complaint("m.msh", with(gmsh_text_2, "\n7 1 1", "\n10 1 1")),
      "m.msh: byte " + std::to_string(gmsh_text_2.find("4\n10 0")) + ": two nodes have one number");
  EXPECT_EQ(complaint("m.msh", with(gmsh_text_2, "1 15 2", "1 99 2")),
            "m.msh: line 17: no element of type 99 is known");
  EXPECT_EQ(complaint("m.vtp", "?"),
            "m.vtp: VTP is not read; .ply, .obj, .off, .stl, .glb, .gltf, .msh and .mesh are");
}

TEST_F(LabelFormats, OfWhichAPartIsMissingAreRefusedOrSound) {
  for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
           {"m.mesh", medit_text}, {"m.msh", gmsh_text_2}, {"m.msh", gmsh_text_4}}) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      (void)is_accepted(name, bytes.substr(0, size));
    }
  }
  for (const std::string& bytes :
       {gmsh_bytes_2(std::endian::big), gmsh_bytes_4(std::endian::little)}) {
    EXPECT_TRUE(is_accepted("m.msh", bytes));
    for (std::size_t size = 0; size < bytes.size() - 14; ++size) {
      EXPECT_FALSE(is_accepted("m.msh", bytes.substr(0, size))) << size;
    }
  }
}

// The numbers of an array of a VTP file that we wrote, by its name.
template <class Number>
std::vector<Number> vtp_array(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  EXPECT_NE(tag, std::string::npos) << name;
  const std::size_t offset = file.find("offset=\"", tag) + 8;
  const std::size_t data = file.find("\n_") + 2;
  const std::size_t at = data + std::stoull(file.substr(offset));
  const auto size = load<std::uint64_t>(file.data() + at);
  EXPECT_LE(at + 8 + size, file.size());
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < size; i += sizeof(Number)) {
    numbers.push_back(load<Number>(file.data() + at + 8 + i));
  }
  return numbers;
}

TEST(Vtp, HasTheShapeAndAllPropertiesAsArrays) {
  const Mesh mesh = tetrahedron();
  Properties properties;
  properties.of_vertices = {{"distance", std::vector<double>{0, 0.5, 1e-300, 3}},
                            {"<a&b>", std::vector<std::uint8_t>{1, 2, 3, 255}}};
  properties.of_triangles = {{"region", std::vector<std::int32_t>{-1, 0, 1, 7}}};
  const TemporaryFolder folder;
  write(folder.path() / "m.vtp", mesh, properties);
  const std::string file = read_file(folder.path() / "m.vtp");
  EXPECT_EQ(vtp_array<double>(file, "distance"), (std::vector<double>{0, 0.5, 1e-300, 3}));
  EXPECT_EQ(vtp_array<std::uint8_t>(file, "&lt;a&amp;b&gt;"),
            (std::vector<std::uint8_t>{1, 2, 3, 255}));
  EXPECT_EQ(vtp_array<std::int32_t>(file, "region"), (std::vector<std::int32_t>{-1, 0, 1, 7}));
  EXPECT_EQ(vtp_array<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{3, 6, 9, 12}));
  EXPECT_EQ(vtp_array<std::int64_t>(file, "connectivity"),
            (std::vector<std::int64_t>{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}));
  EXPECT_EQ(vtp_array<double>(file, "Points").size(), 12U);
  EXPECT_EQ(vtp_array<double>(file, "Points")[4], 0);
  EXPECT_EQ(vtp_array<double>(file, "Points")[7], -1.25);
}

}  // namespace
}  // namespace geolloyd

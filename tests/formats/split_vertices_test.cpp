// Vertices that a file has several times are welded, whatever the format; what differs between them
// stays with the corners.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/properties/properties.h"
#include "tests/support/mesh_files.h"

namespace geolloyd {
namespace {

using Ids = std::vector<VertexId>;

// Two triangles on each side of an edge, whose ends each has for itself.
const Ids split_is_welded_to = {0, 1, 2, 0, 2, 5};
const Triangles split_whole = {{0, 1, 2}, {0, 2, 5}};
const Triangles split_apart = {{0, 1, 2}, {3, 4, 5}};

const std::string split_ply =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
    "property float z\nproperty float s\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 0 0 4\n1 1 0 5\n0 1 -0 6\n3 0 1 2\n3 3 4 5\n";
const std::string split_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 -0\nv 1 1 0\nv 0 1 0\n"
    "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 4//2 5//2 6//2\n";
const std::string split_off =
    "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n";
const std::string split_gmsh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 0 0\n"
    "5 1 1 0\n6 0 1 0\n$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 4 5 6\n"
    "$EndElements\n";
const std::string split_medit =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 0 0 0\n"
    "1 1 0 0\n0 1 0 0\nTriangles\n2\n1 2 3 0\n4 5 6 0\nEnd\n";

class SplitVertices : public MeshFiles {
 protected:
  [[nodiscard]] LoadedMesh load_all(const std::string& name, const std::string& bytes,
                                    bool weld = true) const {
    return read(folder_.write(name, bytes), {.properties = true, .weld = weld});
  }
  TemporaryFolder folder_;
};

TEST_F(SplitVertices, AreWeldedInEveryFormat) {
  const std::vector<std::pair<std::string, std::string>> files = {{"m.ply", split_ply},
                                                                  {"m.obj", split_obj},
                                                                  {"m.off", split_off},
                                                                  {"m.msh", split_gmsh},
                                                                  {"m.mesh", split_medit}};
  for (const auto& [name, bytes] : files) {
    SCOPED_TRACE(name);
    const LoadedMesh whole = load_all(name, bytes);
    EXPECT_EQ(whole.mesh.triangles, split_whole);
    EXPECT_EQ(whole.mesh.vertex_count(), 6U);
    EXPECT_EQ(whole.welded_to, split_is_welded_to);
    EXPECT_EQ(whole.welded_vertices, 2U);
    const LoadedMesh split = load_all(name, bytes, false);
    EXPECT_EQ(split.mesh.triangles, split_apart);
    EXPECT_EQ(split.mesh.positions, whole.mesh.positions);
    EXPECT_TRUE(split.welded_to.empty());
    EXPECT_EQ(split.welded_vertices, 0U);
  }
}

// Normals and texture coordinates that nobody asks for do not keep vertices apart.
TEST_F(SplitVertices, AreWeldedWithoutTheirProperties) {
  const std::string bytes =
      "STNOFF\n6 2 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 0 0\n1 1 0 0 0 1 0 0\n"
      "0 0 0 0 1 0 0 0\n1 1 0 0 1 0 0 0\n0 1 0 0 1 0 0 0\n3 0 1 2\n3 3 4 5\n";
  const LoadedMesh bare = load("m.off", bytes);
  EXPECT_EQ(bare.mesh.triangles, split_whole);
  EXPECT_TRUE(bare.properties.empty());
  EXPECT_TRUE(bare.properties.corner_values.empty());
  const LoadedMesh whole = load_all("m.off", bytes);
  EXPECT_EQ(whole.mesh.triangles, split_whole);
  EXPECT_EQ(whole.properties.of_vertices.size(), 5U);
  EXPECT_EQ(whole.properties.corner_values, split_apart);
}

TEST_F(SplitVertices, OfGltfStayApartOnRequest) {
  const std::filesystem::path file = folder_.path() / "m.glb";
  write(file, {load_all("m.ply", split_ply).mesh.positions, split_apart});
  const LoadedMesh whole = read(file);
  EXPECT_EQ(whole.mesh.vertex_count(), 4U);
  EXPECT_EQ(whole.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(read(file, {.weld = false}).mesh.triangles, split_apart);
}

TEST_F(SplitVertices, KeepWhatDiffersAtTheirCorners) {
  const LoadedMesh loaded = load_all("m.ply", split_ply);
  EXPECT_EQ(loaded.properties.corner_values, split_apart);
  EXPECT_EQ(std::get<std::vector<float>>(loaded.properties.of_vertices[0].values),
            (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(load_all("n.obj", split_obj).properties.corner_values, split_apart);
  // What agrees needs no corners.
  std::string same = split_ply;
  same = with(with(same, "0 0 0 4", "0 0 0 1"), "1 1 0 5", "1 1 0 3");
  EXPECT_TRUE(load_all("m.ply", same).properties.corner_values.empty());
  EXPECT_EQ(load_all("m.ply", same).mesh.triangles, split_whole);
}

TEST_F(SplitVertices, AreWrittenWithTheirValues) {
  const LoadedMesh loaded = load_all("m.obj", split_obj);
  for (const char* name : {"w.ply", "w.obj", "w.off", "w.vtp"}) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = folder_.path() / name;
    write(file, loaded.mesh, loaded.properties);
    if (file.extension() == ".vtp") continue;  // is not read
    const LoadedMesh again = read(file, {.properties = true});
    EXPECT_EQ(again.mesh.triangles, loaded.mesh.triangles);
    EXPECT_EQ(again.properties.corner_values, loaded.properties.corner_values);
    for (const char* axis : {"nx", "ny", "nz"}) {
      const Property* found = find_property(again.properties.of_vertices, axis);
      const Property* expected = find_property(loaded.properties.of_vertices, axis);
      ASSERT_NE(found, nullptr);
      for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(value_at(*found, v), value_at(*expected, v));
    }
  }
}

}  // namespace
}  // namespace geolloyd

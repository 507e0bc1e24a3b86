// The command convert: the same mesh in another format, whatever is wrong with it.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/properties/properties.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

class Converting : public Program {
 protected:
  [[nodiscard]] std::string in(const std::string& name) const { return out(name).string(); }

  [[nodiscard]] Outcome convert(const std::string& from, const std::string& to,
                                const std::string& options = "") const {
    return geolloyd_with("convert " + in(from) + " " + in(to) + " " + options);
  }

  // As it stands in the file: nothing welded.
  [[nodiscard]] LoadedMesh loaded(const std::string& name) const {
    return read(out(name), {.properties = true, .weld = false});
  }

  static void expect_text(const Outcome& outcome, const std::string& text) {
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find(text), std::string::npos) << text << "\n" << outcome.text;
  }
};

// Split vertices, a vertex of no triangle, a triangle twice and one that names a vertex twice.
Mesh flawed() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}},
          {{0, 1, 2}, {4, 6, 5}, {0, 1, 2}, {0, 0, 1}}};
}

TEST_F(Converting, KeepsTheMeshWithItsFlaws) {
  const Mesh mesh = flawed();
  write(out("a.ply"), mesh);
  std::string before = "a.ply";
  for (const char* name :
       {"b.obj", "c.off", "d.msh", "e.mesh", "f.gltf", "g.glb.gz", "h.ply.zst"}) {
    expect_text(convert(before, name), "7 vertices, 4 triangles\n");
    EXPECT_EQ(loaded(name).mesh.positions, mesh.positions) << name;
    EXPECT_EQ(loaded(name).mesh.triangles, mesh.triangles) << name;
    before = name;
  }
  // STL has the triangles alone.
  expect_text(convert(before, "i.stl"), "4 triangles");
  expect_text(convert("i.stl", "j.ply"), "found       8 repeated corners: welded");
  EXPECT_EQ(loaded("j.ply").mesh.vertex_count(), 4U);
  EXPECT_EQ(loaded("j.ply").mesh.triangle_count(), 4U);
}

TEST_F(Converting, KeepsAllDigitsWhereTheFormatHasThem) {
  Mesh mesh = flawed();
  mesh.positions[0] = {0.1, 1.0 / 3, 1e-30};
  write(out("a.ply"), mesh);
  EXPECT_EQ(convert("a.ply", "b.obj").status, 0);
  EXPECT_EQ(convert("b.obj", "c.off").status, 0);
  EXPECT_EQ(convert("c.off", "d.ply").status, 0);
  EXPECT_EQ(read_file(out("d.ply")), read_file(out("a.ply")));
}

// Two of the split vertices have colours and normals of their own.
TEST_F(Converting, KeepsWhatBothFormatsHaveAPlaceFor) {
  Properties properties;
  properties.of_vertices = {{"red", std::vector<std::uint8_t>{1, 2, 3, 4, 50, 60, 70}},
                            {"green", std::vector<std::uint8_t>{9, 9, 9, 9, 9, 9, 9}},
                            {"blue", std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0}},
                            {"nx", std::vector<float>{0, 0, 0, 1, 1, 1, 1}},
                            {"ny", std::vector<float>{0, 0, 0, 0, 0, 0, 0}},
                            {"nz", std::vector<float>{1, 1, 1, 0, 0, 0, 0}}};
  write(out("a.ply"), flawed(), properties);
  expect_text(convert("a.ply", "b.glb"), "carried     red, green, blue, nx, ny, nz of vertices\n");
  EXPECT_EQ(convert("b.glb", "c.off").status, 0);
  EXPECT_EQ(convert("c.off", "d.ply").status, 0);
  const std::vector<Property> found = loaded("d.ply").properties.of_vertices;
  EXPECT_EQ(found.size(), 6U);
  for (const Property& property : properties.of_vertices) {
    const Property* same = find_property(found, property.name);
    ASSERT_NE(same, nullptr) << property.name;
    for (std::size_t v = 0; v < 7; ++v) EXPECT_EQ(value_at(*same, v), value_at(property, v));
  }
  expect_text(convert("a.ply", "e.stl"),
              "left out    red, green, blue, nx, ny, nz of vertices: STL");
  const Outcome dropped = convert("a.ply", "f.ply", "--drop");
  EXPECT_EQ(dropped.text, in("f.ply") + ": 7 vertices, 4 triangles\n");
  EXPECT_TRUE(loaded("f.ply").properties.empty());
}

TEST_F(Converting, CountsThePolygonsThatItSplits) {
  (void)folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  expect_text(convert("a.obj", "b.off"), "found       1 polygons: split into triangles");
  const Outcome printed = convert("a.obj", "b.off", "--json");
  const auto json = nlohmann::json::parse(printed.text, nullptr, false);
  ASSERT_TRUE(json.is_object()) << printed.text;
  EXPECT_EQ(json["command"], "convert");
  EXPECT_EQ(json["output"], in("b.off"));
  EXPECT_EQ(json["triangles"], 2);
  EXPECT_EQ(json["polygons_split"], 1);
  EXPECT_EQ(json["properties"]["vertices"].size(), 0U);
}

TEST_F(Converting, GoesFromOneStreamToTheOther) {
  write(out("a.ply"), flawed());
  ASSERT_EQ(convert("a.ply", "b.off").status, 0);
  const Outcome outcome =
      run_shell("(" GEOLLOYD_PROGRAM " convert - - --format ply --output-format off <" +
                in("a.ply") + " >" + in("c.dat") + ")");
  EXPECT_EQ(outcome.text, "standard output: 7 vertices, 4 triangles\n");
  EXPECT_EQ(read_file(out("c.dat")), read_file(out("b.off")));
  ASSERT_EQ(convert("c.dat", "d.dat", "--format off --output-format ply").status, 0);
  EXPECT_EQ(read_file(out("d.dat")), read_file(out("a.ply")));
}

TEST_F(Converting, RefusesInOneLine) {
  write(out("a.ply"), flawed());
  expect_complaint(convert("a.ply", "a.ply"), "a.ply: would be overwritten");
  expect_complaint(convert("a.ply", "b.xyz"), "unknown extension '.xyz'");
  expect_complaint(convert("a.ply", "no/b.obj"), "b.obj: cannot write: No such file");
  expect_complaint(convert("no.ply", "b.obj"), "no.ply: cannot open");
  expect_complaint(geolloyd_with("convert " + in("a.ply")), "OUTPUT");
  Mesh large = flawed();
  large.positions[3] = {1e60, 0, 0};
  write(out("large.ply"), large);
  expect_complaint(convert("large.ply", "b.stl"), "is too large for STL");
  EXPECT_FALSE(fs::exists(out("b.stl")));
}

}  // namespace
}  // namespace geolloyd

// The command repair, and --repair of remesh and relax.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

class Repairing : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    // A hole of one triangle, turned triangles, a copy, and one triangle with vertices of its own.
    whole_ = read(mesh_).mesh;
    Mesh mesh = whole_;
    for (std::size_t t = 0; t < 100; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    for (VertexId& v : mesh.triangles[300]) {
      const Vec3 place = mesh.positions[v];
      v = static_cast<VertexId>(mesh.vertex_count());
      mesh.positions.push_back(place);
    }
    mesh.triangles.push_back(mesh.triangles[400]);
    mesh.triangles.erase(mesh.triangles.begin() + 500);
    flawed_ = folder_.path() / "flawed.ply";
    write(flawed_, mesh);
  }

  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(read_file(file(name)));
  }

  static void expect_repairs(const nlohmann::json& repairs) {
    EXPECT_EQ(repairs["any"], true);
    EXPECT_EQ(repairs["duplicate_triangles"], 1);
    EXPECT_EQ(repairs["vertices_merged"], 3);
    EXPECT_EQ(repairs["triangles_turned"], 100);
    EXPECT_EQ(repairs["holes_filled"], 1);
    EXPECT_EQ(repairs["triangles_added"], 1);
    for (const char* key :
         {"repeated_vertex_triangles", "vertices_cut", "slivers_removed", "slivers_left",
          "unorientable_components", "holes_left", "unused_vertices"}) {
      EXPECT_EQ(repairs[key], 0) << key;
    }
  }
  static void expect_text(const Outcome& outcome, const std::string& text) {
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find(text), std::string::npos) << text << "\n" << outcome.text;
  }

  Mesh whole_;
  fs::path flawed_;
};

TEST_F(Repairing, WritesTheRepairedMeshItsMapAndReport) {
  const Outcome outcome =
      geolloyd_with("repair " + flawed_.string() + " -o " + file("r.ply").string() +
                    " --no-weld --fill-holes 3 --map " + file("map.csv").string() + " --report " +
                    file("r.json").string());
  expect_text(outcome, "  repaired    1 duplicate triangle: left out\n");
  expect_text(outcome, "  repaired    3 vertices merged with others in the same place\n");
  expect_text(outcome, "  repaired    1 hole filled with 1 triangle\n");
  expect_text(outcome, "0 boundary loops, manifold");
  const Mesh made = read(file("r.ply")).mesh;
  EXPECT_EQ(topology_of(made), topology_of(whole_));
  const nlohmann::json report = json("r.json");
  expect_repairs(report["repairs"]);
  EXPECT_EQ(report["command"], "repair");
  EXPECT_EQ(report["options"]["fill_holes"], "3");
  EXPECT_EQ(report["is_manifold"], true);
  EXPECT_EQ(report["topology"]["boundary_loops"], 0);
  const auto map = lines_of(file("map.csv"));
  ASSERT_EQ(map.size(), made.vertex_count() + 1);
  EXPECT_EQ(map[0], "vertex,input_vertex");
  EXPECT_EQ(map[8], "7,7");
}

TEST_F(Repairing, AppliesToRemeshes) {
  const Outcome outcome = geolloyd_with(
      "remesh " + flawed_.string() + " --no-weld --repair --fill-holes 3 --vertices 150 -o " +
      file("r.ply").string() + " --report " + file("r.json").string());
  expect_text(outcome, "  repaired    100 triangles turned");
  expect_text(outcome, "0 boundary loops, manifold, of the input's topology\n");
  const nlohmann::json report = json("r.json");
  expect_repairs(report["repairs"]);
  EXPECT_EQ(report["options"]["repair"], true);
  EXPECT_EQ(report["input"]["inconsistent_edges"], 0);
  EXPECT_EQ(report["remesh"]["has_input_topology"], true);
}

TEST_F(Repairing, AppliesToTessellations) {
  const Outcome outcome = geolloyd_with("relax " + flawed_.string() + " -o " + out().string() +
                                        " --no-weld --repair --fill-holes 3 --seeds 40");
  expect_text(outcome, "  repaired    3 vertices merged");
  expect_repairs(json("out/report.json")["repairs"]);
  // The tessellation is one of the repaired mesh.
  EXPECT_EQ(topology_of(read(out() / "tessellation.ply").mesh), topology_of(whole_));
}

TEST_F(Repairing, ChangesNothingOnACleanMesh) {
  const std::string torus = mesh_.string();
  const std::string copy = file("copy.ply").string();
  expect_text(geolloyd_with("repair " + torus + " -o " + copy), "nothing: no flaw");
  EXPECT_EQ(read_file(copy), read_file(torus));
  ASSERT_EQ(relax("--seeds 40", "plain").status, 0);
  ASSERT_EQ(relax("--seeds 40 --repair", "repaired").status, 0);
  EXPECT_EQ(json("plain/report.json")["fingerprint"], json("repaired/report.json")["fingerprint"]);
  EXPECT_TRUE(json("plain/report.json")["repairs"].is_null());
  EXPECT_EQ(json("repaired/report.json")["repairs"]["any"], false);
  const std::string remesh = "remesh " + torus + " --vertices 100 -o " + file("r.ply").string();
  ASSERT_EQ(geolloyd_with(remesh + " --report " + file("a.json").string()).status, 0);
  ASSERT_EQ(geolloyd_with(remesh + " --repair --report " + file("b.json").string()).status, 0);
  EXPECT_EQ(json("a.json")["fingerprint"], json("b.json")["fingerprint"]);
}

TEST_F(Repairing, RefusesOptionsThatNameIds) {
  const std::string list = folder_.write("list.txt", "0\n").string();
  for (const char* option : {"--feature-edges ", "--fixed ", "--map "}) {
    expect_complaint(geolloyd_with("remesh " + mesh_.string() + " --vertices 100 --repair -o " +
                                   file("r.ply").string() + " " + option + list),
                     "geolloyd repair");
  }
  expect_complaint(relax("--repair --seeds-file " + list), "geolloyd repair");
  expect_complaint(relax("--repair --seeds 4 --vfield " + list), "geolloyd repair");
  expect_complaint(relax("--seeds 4 --fill-holes 3"), "give --repair, too");
}

TEST_F(Repairing, RefusesWhatMakesNoSense) {
  const std::string start = "repair " + flawed_.string() + " -o ";
  for (const char* size : {"0", "-3", "x", "5.5", "0%", "nan%", "%", "99999999999"}) {
    expect_complaint(geolloyd_with(start + file("r.ply").string() + " --fill-holes=" + size),
                     "--fill-holes");
  }
  expect_complaint(geolloyd_with(start + flawed_.string()), "flawed.ply");
  expect_complaint(geolloyd_with(start + file("r.txt").string()), "r.txt");
  expect_complaint(
      geolloyd_with(start + file("r.ply").string() + " --map " + file("r.ply").string()), "r.ply");
  EXPECT_FALSE(fs::exists(file("r.ply")));
}

TEST_F(Repairing, NeedsAnAreaToRemesh) {
  const std::string line =
      folder_.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").string();
  expect_complaint(
      geolloyd_with("remesh " + line + " --repair --vertices 10 -o " + file("r.ply").string()),
      "no triangle with an area");
  EXPECT_EQ(geolloyd_with("repair " + line + " -o " + file("r.ply").string()).status, 0);
}

// Each vertex knows its x, each triangle the number of its row of ten.
TEST_F(Repairing, KeepsProperties) {
  const Mesh flawed = read(flawed_).mesh;
  std::vector<double> x;
  for (const Vec3& p : flawed.positions) x.push_back(p.x());
  std::vector<std::int32_t> row;
  for (std::size_t t = 0; t < flawed.triangle_count(); ++t) {
    row.push_back(static_cast<std::int32_t>(t / 10));
  }
  write(flawed_, flawed, {{{"heat", x}}, {{"row", row}}, {}});
  const std::string filling = " --fill-holes 3 -o " + file("r.ply").string();
  expect_text(geolloyd_with("repair " + flawed_.string() + filling),
              "carried     heat of vertices; row of triangles\n");
  const LoadedMesh repaired = read(file("r.ply"), {true});
  const auto& heat = std::get<std::vector<double>>(repaired.properties.of_vertices.at(0).values);
  for (std::size_t v = 0; v < heat.size(); ++v) {
    EXPECT_EQ(heat[v], repaired.mesh.positions[v].x());
  }
  const auto& rows =
      std::get<std::vector<std::int32_t>>(repaired.properties.of_triangles.at(0).values);
  ASSERT_EQ(rows.size(), whole_.triangle_count());
  for (std::size_t t = 0; t + 1 < rows.size(); ++t) {  // the last one fills the hole
    EXPECT_EQ(rows[t], row[t]);
  }
  const std::string options = " --repair --vertices 150 -o " + file("m.ply").string();
  expect_text(geolloyd_with("remesh " + flawed_.string() + options), "heat of vertices");
}

}  // namespace
}  // namespace geolloyd

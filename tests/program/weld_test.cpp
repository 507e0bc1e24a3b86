// Meshes whose vertices are split, as commands take them: welded, unless told otherwise; and
// numbers of vertices in files stay those of the mesh's file.
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/shapes/shapes.h"
#include "core/text/file_io.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

constexpr std::size_t triangles = 320;

// Triangle t of a sphere has the vertices 3 t, 3 t + 1 and 3 t + 2 for itself.
Mesh split_sphere() {
  const Mesh sphere = icosphere(triangles);
  Mesh split;
  for (std::uint32_t t = 0; t < sphere.triangle_count(); ++t) {
    for (const VertexId v : sphere.triangles[t]) split.positions.push_back(sphere.positions[v]);
    split.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return split;
}

class Welding : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    mesh_ = file("split.ply");
    write(mesh_, split_sphere());
  }

  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }

  [[nodiscard]] Outcome run(const std::string& command, const std::string& options) const {
    return geolloyd_with(command + " " + mesh_.string() + " " + options);
  }
  [[nodiscard]] nlohmann::json report_of_remesh(const std::string& options) const {
    const Outcome outcome = run("remesh", "-o " + file("r.ply").string() + " --report " +
                                              file("r.json").string() + " " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return nlohmann::json::parse(read_file(file("r.json")));
  }
  [[nodiscard]] fs::path list(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }
};

void expect_part(const Outcome& outcome, const std::string& text) {
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find(text), std::string::npos) << text << "\n" << outcome.text;
}

TEST_F(Welding, IsSaidAndMayBeTurnedOff) {
  const std::string line = "found       798 vertices in the places of others: welded\n";
  const std::string whole = "1 component, Euler characteristic 2, closed";
  expect_part(run("info", ""), whole);
  expect_part(run("info", ""), line);
  expect_part(run("info", "--no-weld"), "320 components");
  EXPECT_EQ(run("info", "--no-weld").text.find("welded"), std::string::npos);

  const nlohmann::json report = report_of_remesh("-n 100");
  EXPECT_EQ(report["input"]["vertices_welded"], 798);
  EXPECT_EQ(report["input"]["unreferenced_vertices"], 0);
  EXPECT_EQ(report["options"]["weld"], true);
  EXPECT_EQ(report["remesh"]["vertices"], 100);
  EXPECT_EQ(report["remesh"]["topology"]["components"], 1);
  const nlohmann::json apart = report_of_remesh("-n 100 --no-weld");
  EXPECT_EQ(apart["input"]["vertices_welded"], 0);
  EXPECT_EQ(apart["options"]["weld"], false);
  EXPECT_EQ(apart["remesh"]["topology"]["components"], 320);
}

TEST_F(Welding, IsAChoiceOfEveryCommandThatReadsAMesh) {
  for (const char* command :
       {"remesh", "remesh-all", "relax", "verify", "view", "render", "quality", "repair",
        "subdivide", "info", "ground-truth", "compare", "profile", "batch"}) {
    expect_part(geolloyd_with(std::string(command) + " --help"), "--no-weld");
  }
}

// The sphere has 162 places, and edges of triangle 0 are those of triangles beside it, too.
TEST_F(Welding, KeepsTheNumbersOfFilesOfVertices) {
  const Mesh split = split_sphere();
  const Mesh whole = read(mesh_).mesh;
  VertexId last = 0;  // the last vertex in the place of the first
  for (VertexId v = 1; v < split.vertex_count(); ++v) {
    if (split.positions[v] == split.positions[0]) last = v;
  }
  ASSERT_GT(last, 2U);
  ASSERT_EQ(split.triangles[last / 3][last % 3], last);
  EXPECT_EQ(whole.triangles[last / 3][last % 3], 0U);

  const std::string number = std::to_string(last);
  (void)report_of_remesh("-n 100 --fixed " + list("fixed.txt", number + "\n").string());
  const Mesh remesh = read(file("r.ply")).mesh;
  double nearest = 1;
  for (const Vec3& p : remesh.positions) {
    nearest = std::min(nearest, norm(p - split.positions[last]));
  }
  EXPECT_LT(nearest, 1e-6);

  const std::string next = std::to_string(last - last % 3 + (last + 1) % 3);
  const auto kept =
      report_of_remesh("-n 100 --feature-edges " + list("e.txt", number + " " + next).string());
  EXPECT_GT(kept["remesh"]["feature_edges"], 0);

  std::string lengths;
  for (std::size_t v = 0; v < split.vertex_count(); ++v) lengths += "0.3\n";
  (void)report_of_remesh("--sizing " + list("lengths.txt", lengths).string());
  (void)report_of_remesh("-n 100 --density " + list("densities.txt", lengths).string());
  expect_complaint(run("remesh", "-n 100 -o " + file("r.ply").string() + " --density " +
                                     list("short.txt", lengths.substr(4)).string()),
                   "the mesh has 960 vertices");
}

TEST_F(Welding, KeepsTheNumbersOfSeedsAndRegions) {
  const fs::path seeds = list("seeds.txt", "959\n480\n");
  const Outcome outcome =
      run("relax", "--seeds-file " + seeds.string() + " -o " + file("out").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const std::vector<std::string> rows = lines_of(file("out") / "regions.csv");
  ASSERT_EQ(rows.size(), 961U);
  const Mesh split = split_sphere();
  const auto of_row = [](const std::string& row) { return row.substr(row.find(',') + 1); };
  std::map<std::array<double, 3>, std::string> at;
  for (std::size_t v = 0; v < 960; ++v) {
    const Vec3& p = split.positions[v];
    const auto [known, is_new] = at.try_emplace({p.x(), p.y(), p.z()}, of_row(rows[v + 1]));
    EXPECT_EQ(of_row(rows[v + 1]), known->second) << v;
    EXPECT_EQ(rows[v + 1].find("-1"), std::string::npos) << rows[v + 1];
  }
  EXPECT_EQ(at.size(), 162U);
  const Outcome same = run("relax", "--seeds-file " + list("twice.txt", "0\n0\n").string() +
                                        " -o " + file("two").string());
  EXPECT_EQ(same.status, 2);
}

TEST_F(Welding, LeavesTouchingBoxesAsTheyAre) {
  Mesh boxes = flat_box(1);
  append(boxes, moved(flat_box(1), {1, 0, 0}));
  append(boxes, moved(flat_box(1), {0, 3, 0}));
  append(boxes, moved(flat_box(1), {1, 4, 0}));
  write(mesh_, boxes);
  const nlohmann::json report = report_of_remesh("-n 400");
  EXPECT_EQ(report["input"]["vertices_welded"], 0);
  EXPECT_EQ(report["remesh"]["topology"]["components"], 4);
  EXPECT_EQ(report["remesh"]["topology"]["euler_characteristic"], 8);
  const nlohmann::json apart = report_of_remesh("-n 400 --no-weld");
  EXPECT_EQ(apart["fingerprint"], report["fingerprint"]);
}

TEST_F(Welding, ComesBeforeARepair) {
  const Outcome outcome = run("repair", "-o " + file("whole.ply").string());
  expect_part(outcome, "798 vertices in the places of others: welded");
  expect_part(outcome, "nothing: no flaw that a repair knows");
  EXPECT_EQ(read(file("whole.ply")).mesh.vertex_count(), 162U);
  const Outcome apart = run("repair", "--no-weld -o " + file("whole.ply").string());
  expect_part(apart, "798 vertices merged with others in the same place");
}

// Each triangle of the sphere has its own normal, and a remesh takes that of the triangle it is on.
TEST_F(Welding, CarriesValuesOfCorners) {
  const Mesh split = split_sphere();
  Properties properties;
  std::vector<std::int32_t> of_triangle;
  for (std::int32_t v = 0; v < 960; ++v) of_triangle.push_back(v / 3);
  properties.of_vertices = {{"of_triangle", of_triangle}};
  write(mesh_, split, properties);
  (void)report_of_remesh("-n 100 --map " + file("map.csv").string());
  const LoadedMesh remesh = read(file("r.ply"), {.properties = true});
  const auto& values =
      std::get<std::vector<std::int32_t>>(remesh.properties.of_vertices.at(0).values);
  const std::vector<std::string> rows = lines_of(file("map.csv"));
  for (std::size_t v = 0; v < values.size(); ++v) {
    EXPECT_EQ(rows[v + 1].rfind(std::to_string(v) + "," + std::to_string(values[v]) + ",", 0), 0U)
        << rows[v + 1] << " " << values[v];
  }
}

}  // namespace
}  // namespace geolloyd

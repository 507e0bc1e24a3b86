// A bad result says so: on standard error, in the report, and with --strict by the exit status.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/formats/mesh_io.h"
#include "core/repair/crossings.h"
#include "core/shapes/shapes.h"
#include "core/text/file_io.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

class Warnings : public Program {
 protected:
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }

  // A sphere each of whose triangles has vertices for itself.
  void write_split_sphere(const fs::path& path) const {
    Mesh split;
    const Mesh sphere = icosphere(320);
    for (const Triangle& t : sphere.triangles) {
      append(split, {{sphere.positions[t[0]], sphere.positions[t[1]], sphere.positions[t[2]]},
                     {{0, 1, 2}}});
    }
    write(path, split);
  }

  [[nodiscard]] Outcome remesh(const std::string& options) const {
    return geolloyd_with("remesh " + mesh_.string() + " -o " + file("r.ply").string() +
                         " --report " + file("r.json").string() + " " + options);
  }
  [[nodiscard]] std::set<std::string> kinds() const {
    const auto report = nlohmann::json::parse(read_file(file("r.json")));
    std::set<std::string> found;
    for (const auto& warning : report["warnings"]) {
      EXPECT_FALSE(warning["text"].get<std::string>().empty());
      found.insert(warning["kind"]);
    }
    return found;
  }
};

bool warns(const Outcome& outcome) {
  return outcome.text.find("geolloyd: warning: ") != std::string::npos;
}

TEST_F(Warnings, AreNoneWhereAllIsWell) {
  const Outcome outcome = remesh("-n 600 --strict");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_FALSE(warns(outcome)) << outcome.text;
  EXPECT_TRUE(kinds().empty());
}

TEST_F(Warnings, EndTheProgramOnRequestOnceAllFilesAreThere) {
  mesh_ = file("split.ply");
  write_split_sphere(mesh_);
  const Outcome mild = remesh("-n 100 --no-weld");
  EXPECT_EQ(mild.status, 0) << mild.text;
  EXPECT_TRUE(warns(mild)) << mild.text;
  EXPECT_TRUE(kinds().contains("split_vertices"));
  EXPECT_TRUE(kinds().contains("vertices"));
  fs::remove(file("r.ply"));
  fs::remove(file("r.json"));
  const Outcome strict = remesh("-n 100 --no-weld --strict --quiet");
  EXPECT_EQ(strict.status, 3) << strict.text;
  EXPECT_TRUE(warns(strict)) << strict.text;
  EXPECT_TRUE(fs::exists(file("r.ply")));
  EXPECT_TRUE(kinds().contains("split_vertices"));
  EXPECT_EQ(remesh("-n 100 --no-weld --quiet").text, "");
  EXPECT_EQ(remesh("-n 100 --strict").status, 0);
}

TEST_F(Warnings, TellOfALostVolume) {
  ASSERT_EQ(geolloyd_with("generate icosphere -t 2000 -o " + mesh_.string()).status, 0);
  EXPECT_EQ(remesh("-n 4 --strict").status, 3);
  EXPECT_TRUE(kinds().contains("volume"));
}

// Of each command that has --issues: as many lines as its report counts, with the triangles of its
// mesh.
TEST_F(Warnings, NameTheTrianglesThatCross) {
  Mesh mesh = icosphere(320);
  append(mesh, moved(mesh, {0.5, 0.1, 0}));
  mesh_ = file("two.ply");
  write(mesh_, mesh);
  const std::string issues = " --issues " + file("i.csv").string();
  const auto check = [&](const std::string& command, const fs::path& made, const char* place) {
    const Outcome outcome = geolloyd_with(command + issues);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find(" pairs of triangles cross\n"), std::string::npos);
    std::ifstream lines(file("i.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "kind,triangle,other_triangle,x,y,z");
    const Mesh judged = read(made).mesh;
    const std::vector<TrianglePair> expected = find_crossings(judged);
    EXPECT_GT(expected.size(), 10U);
    for (const TrianglePair& pair : expected) {
      std::getline(lines, line);
      const std::string start =
          "self_intersection," + std::to_string(pair[0]) + "," + std::to_string(pair[1]) + ",";
      EXPECT_EQ(line.substr(0, start.size()), start);
    }
    EXPECT_FALSE(std::getline(lines, line));
    const auto report = nlohmann::json::parse(read_file(file("r.json")));
    EXPECT_EQ(report.at(nlohmann::json::json_pointer(place)), expected.size());
  };
  const std::string out = " -o " + file("r.ply").string() + " --report " + file("r.json").string();
  check("quality " + mesh_.string() + " -o " + file("r.json").string(), mesh_,
        "/self_intersections");
  check("repair " + mesh_.string() + out, file("r.ply"), "/self_intersections");
  check("remesh " + mesh_.string() + " -n 200" + out, file("r.ply"), "/remesh/self_intersections");
  EXPECT_FALSE(kinds().contains("self_intersections"));
}

TEST_F(Warnings, AreInTheJsonWhereThatIsWanted) {
  mesh_ = file("split.ply");
  write_split_sphere(mesh_);
  const Outcome outcome = remesh("-n 100 --no-weld --json --strict");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_FALSE(nlohmann::json::parse(outcome.text)["warnings"].empty());
}

TEST_F(Warnings, AreListedForEachOfManyMeshes) {
  const fs::path meshes = file("meshes");
  fs::create_directory(meshes);
  fs::copy(mesh_, meshes / "good.ply");
  write_split_sphere(meshes / "split.ply");
  const std::string command = "remesh-all " + meshes.string() + " -n 600 --no-weld -o ";
  const Outcome mild = geolloyd_with(command + file("mild").string());
  EXPECT_EQ(mild.status, 0) << mild.text;
  EXPECT_NE(mild.text.find("geolloyd: warning: " + (meshes / "split.ply").string() + ": "),
            std::string::npos);
  EXPECT_EQ(mild.text.find((meshes / "good.ply").string()), std::string::npos) << mild.text;
  const Outcome strict = geolloyd_with(command + file("strict").string() + " --strict");
  EXPECT_EQ(strict.status, 3) << strict.text;
  for (const char* folder : {"mild", "strict"}) {
    const auto record = nlohmann::json::parse(read_file(file(folder) / "remesh-all.json"));
    EXPECT_TRUE(record["rows"][0]["warnings"].is_null());
    EXPECT_FALSE(record["rows"][1]["warnings"].get<std::string>().empty());
    EXPECT_TRUE(fs::exists(file(folder) / "split.ply"));
    EXPECT_EQ(lines_of(file(folder) / "remesh-all.csv").size(), 3U);
  }
}

}  // namespace
}  // namespace geolloyd

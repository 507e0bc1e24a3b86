// Seeds of a file, taken by position: from another level of a mesh, another graph, another mesh.
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace geolloyd {
namespace {

class GivenSeeds : public Program {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(out(name).parent_path());
    std::ofstream(out(name)) << text;
  }

  [[nodiscard]] static nlohmann::json report_in(const std::filesystem::path& folder) {
    return nlohmann::json::parse(read_file(folder / "report.json"));
  }

  [[nodiscard]] std::string by_position(const std::string& name) const {
    return "--by position --seeds-file " + out(name).string();
  }
};

TEST_F(GivenSeeds, OfACoarserLevelBeginAtTheSamePlaces) {
  ASSERT_EQ(relax("--seeds 12", "coarse").status, 0);
  const std::string fine = out("fine.ply").string();
  ASSERT_EQ(geolloyd_with("subdivide " + mesh_.string() + " -s midpoint -o " + fine).status, 0);
  const std::string seeds = by_position("coarse/seeds.csv");
  const Outcome run = geolloyd_with("relax " + fine + " -o " + out("next").string() + " " + seeds);
  ASSERT_EQ(run.status, 0) << run.text;
  EXPECT_NE(run.text.find("by position: up to 0 from their nodes, 0% of"), std::string::npos)
      << run.text;
  const nlohmann::json report = report_in(out("next"));
  EXPECT_EQ(report["options"]["by"], "position");
  EXPECT_EQ(report["options"]["seeds"], 12);
  EXPECT_EQ(report["seed_fit"], (nlohmann::json{{"farthest", 0.0}, {"left_out", 0}}));
}

TEST_F(GivenSeeds, OfTheSameGraphAreTheSameByIdAndByPosition) {
  ASSERT_EQ(relax("--seeds 12", "first").status, 0);
  std::string fingerprint;
  for (const std::string& by : std::vector<std::string>{"id", "position"}) {
    ASSERT_EQ(relax("--by " + by + " --seeds-file " + out("first/seeds.csv").string(), by).status,
              0);
    const std::string found = report_in(out(by))["fingerprint"];
    EXPECT_EQ(found, fingerprint.empty() ? found : fingerprint);
    fingerprint = found;
  }
}

TEST_F(GivenSeeds, OfAnotherKindOfGraphAreTakenByPositionOnly) {
  ASSERT_EQ(relax("--seeds 12 --graph triangle", "triangles").status, 0);
  expect_complaint(relax("--seeds-file " + out("triangles/seeds.csv").string()),
                   "belong to another kind of graph");
  EXPECT_EQ(relax(by_position("triangles/seeds.csv")).status, 0);
  EXPECT_GT(report_in(out())["seed_fit"]["farthest"], 0);
}

TEST_F(GivenSeeds, AreTheVerticesOfAnyMeshFile) {
  for (const std::string& name : std::vector<std::string>{"few.stl", "few.glb", "few.obj.gz"}) {
    write("few.ply", "");
    ASSERT_EQ(geolloyd_with("remesh " + mesh_.string() + " -n 20 -o " + out(name).string()).status,
              0);
    ASSERT_EQ(relax(by_position(name)).status, 0) << name;
    EXPECT_EQ(report_in(out())["options"]["seeds"], 20) << name;
  }
  expect_complaint(relax("--seeds-file " + out("few.stl").string()),
                   "few.stl: a mesh has no ids of seeds: give --by position, too");
}

// Whoever mixes millimetres with metres sees it.
TEST_F(GivenSeeds, OfOtherUnitsAreFarAwayAndTheSummarySaysSo) {
  write("metres", "1000 0 0\n0 1000 0\n0 0.1 1000\n1000 0 1\n");
  const Outcome run = relax(by_position("metres"));
  ASSERT_EQ(run.status, 0) << run.text;
  EXPECT_NE(run.text.find("% of the mesh's diagonal"), std::string::npos) << run.text;
  const nlohmann::json fit = report_in(out())["seed_fit"];
  EXPECT_GT(fit["farthest"], 990);
  EXPECT_LT(fit["farthest"], 1010);
}

TEST_F(GivenSeeds, AtOneNodeAreOneSeedAndCounted) {
  write("twice", "1 0 0\n1 0 0\n-1 0 0\n");
  const Outcome run = geolloyd_with("ground-truth " + mesh_.string() + " " + by_position("twice"));
  ASSERT_EQ(run.status, 0) << run.text;
  EXPECT_NE(run.text.find("; 1 left out, nearest to the node of another"), std::string::npos)
      << run.text;
  EXPECT_NE(run.text.find("2 seeds"), std::string::npos) << run.text;
}

TEST_F(GivenSeeds, ThatNobodyCanUseAreRefusedInALine) {
  const std::string head = "input_id,kind,x,y,z\n";
  const std::array<std::array<std::string, 3>, 8> rows{{
      {"empty.csv", "", "no seeds in this file"},
      {"header.csv", head, "no seeds in this file"},
      {"no_z.csv", "input_id,kind,x,y\n3,vertex,0,1\n", "no column z"},
      {"nan.csv", head + "3,vertex,nan,0,0\n", "line 2: coordinate is not a finite number"},
      {"ids.txt", "3\n4\n", "a list of input ids has no positions"},
      {"none.obj", "# nothing\n", "none.obj: "},
      {"lines.off", "OFF\n0 0 0\n", "lines.off: "},
      {"scan.vtp", "", "scan.vtp: "},
  }};
  for (const auto& [name, text, complaint] : rows) {
    write(name, text);
    expect_complaint(relax(by_position(name)), complaint);
  }
  expect_complaint(relax("--seeds 4 --by position"), "--by requires --seeds-file");
  expect_complaint(relax(by_position("missing.ply")), "missing.ply: cannot open");
}

// A repair changes ids, not places.
TEST_F(GivenSeeds, ByPositionMayBeGivenWithARepair) {
  write("places", "1 0 0\n-1 0 0\n");
  EXPECT_EQ(relax("--repair " + by_position("places")).status, 0);
}

}  // namespace
}  // namespace geolloyd

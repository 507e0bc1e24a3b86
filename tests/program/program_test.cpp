#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_topology.h"
#include "core/shapes/shapes.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"
#include "tests/support/sanitizers.h"
#include "tools/system/build_facts.h"

namespace geolloyd {
namespace {

nlohmann::json report_in(const fs::path& folder) {
  return nlohmann::json::parse(read_file(folder / "report.json"));
}

TEST_F(Program, RelaxWritesAllItsResults) {
  const Outcome outcome = relax("--seeds 20");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("converged"), std::string::npos);

  const auto seeds = lines_of(out() / "seeds.csv");
  ASSERT_EQ(seeds.size(), 21U);
  EXPECT_EQ(seeds[0], "input_id,kind,x,y,z,nodes,area,energy");
  const auto regions = lines_of(out() / "regions.csv");
  EXPECT_EQ(regions[0], "input_id,kind,region,distance");
  const Mesh mesh = read(mesh_).mesh;
  EXPECT_EQ(regions.size(), mesh.vertex_count() + 1);

  const Mesh written = read(out() / "tessellation.ply").mesh;
  EXPECT_EQ(written.triangles, mesh.triangles);
  EXPECT_EQ(written.positions, mesh.positions);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(out())) ++files;
  EXPECT_EQ(files, 5U);
}

TEST_F(Program, ReportHasTheKeysThatScriptsRelyOn) {
  ASSERT_EQ(relax("--seeds 20 --random-seed 7 --greedy extended").status, 0);
  const nlohmann::json report = report_in(out());
  EXPECT_EQ(report["fingerprint"].get<std::string>().size(), 16U);
  EXPECT_GT(report["energy"], 0);
  EXPECT_GT(report["energy_ratio_hexagonal"], 0.9);
  EXPECT_LT(report["energy_ratio_hexagonal"], 1.6);
  for (const char* key : {"load", "graph", "seeds", "relax", "write", "total"}) {
    EXPECT_GE(report["seconds"][key], 0) << key;
  }
  for (const char* key : {"greedy", "macro", "micro", "partitions", "node_visits"}) {
    EXPECT_GT(report["steps"][key], 0) << key;
  }
  EXPECT_GT(report["peak_memory_bytes"], 1000000);
  EXPECT_EQ(report["input"]["triangles"], 2000);
  EXPECT_EQ(report["options"]["random_seed"], 7);
  EXPECT_EQ(report["interrupted"], false);
  EXPECT_EQ(report["end"], "converged");
  const std::size_t steps =
      report["steps"]["greedy"].get<std::size_t>() + report["steps"]["macro"].get<std::size_t>();
  EXPECT_EQ(report["trace"].size(), steps);
}

TEST_F(Program, RemeshIsAManifoldOfTheInputsTopology) {
  for (const std::string vertices : {"seeds", "centroids"}) {
    const Outcome outcome = relax("--seeds 2 -g mixed --dual-vertices " + vertices);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find("manifold"), std::string::npos) << outcome.text;
    const Mesh remesh = read(out() / "dual.ply").mesh;
    const MeshTopology topology = find_topology(remesh, find_edges(remesh));
    EXPECT_TRUE(topology.is_manifold());
    EXPECT_EQ(topology.parts, (std::vector<PartTopology>{{0, 0}}));
    const nlohmann::json told = report_in(out())["dual"];
    EXPECT_EQ(told["vertices"], remesh.vertex_count());
    EXPECT_EQ(told["seeds_added"], remesh.vertex_count() - 2);
    EXPECT_EQ(told["is_manifold"], true);
    EXPECT_EQ(told["has_input_topology"], true);
    EXPECT_EQ(told["input_is_manifold"], true);
    EXPECT_EQ(told["triangles_without_area"], 0);
    EXPECT_EQ(told["topology"], told["input_topology"]);
    EXPECT_TRUE(told["flaw"].is_null());
  }
}

TEST_F(Program, TellsWhyTheRemeshIsNoManifold) {
  const Outcome outcome = relax("--seeds 2 --no-manifold");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("NO MANIFOLD"), std::string::npos) << outcome.text;
  const nlohmann::json told = report_in(out())["dual"];
  EXPECT_NE(outcome.text.find("NOT OF THE INPUT'S TOPOLOGY"), std::string::npos) << outcome.text;
  EXPECT_EQ(told["is_manifold"], false);
  EXPECT_EQ(told["has_input_topology"], false);
  EXPECT_EQ(told["input_is_manifold"], true);
  EXPECT_NE(told["flaw"].get<std::string>().find("--no-manifold"), std::string::npos);
  EXPECT_EQ(told["closed_ball_violations_found"], told["closed_ball_violations_left"]);
  EXPECT_EQ(read(out() / "tessellation.ply").mesh.triangle_count(), 2000U);
}

// Two spheres that touch in a vertex: of the input's topology, but neither is a manifold.
TEST_F(Program, TellsApartAManifoldAndTheTopologyOfTheInput) {
  Mesh touching = icosphere(320);
  const auto shift = static_cast<VertexId>(touching.vertex_count());
  const Mesh other = touching;
  for (const Vec3& p : other.positions) {
    touching.positions.push_back(2 * other.positions[0] - p);
  }
  for (const Triangle& t : other.triangles) {
    Triangle copy{};
    for (std::size_t c = 0; c < 3; ++c) copy[2 - c] = t[c] == 0 ? 0 : t[c] + shift;
    touching.triangles.push_back(copy);
  }
  const auto file = folder_.path() / "touching.ply";
  write(file, touching);
  const Outcome outcome =
      geolloyd_with("relax " + file.string() + " --seeds 40 -o " + out().string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("the input is no manifold"), std::string::npos) << outcome.text;
  const nlohmann::json told = report_in(out())["dual"];
  EXPECT_EQ(told["is_manifold"], false);
  EXPECT_EQ(told["has_input_topology"], true);
  EXPECT_EQ(told["input_is_manifold"], false);

  const Outcome informed = geolloyd_with("info " + file.string());
  EXPECT_NE(informed.text.find("1 vertex where surfaces touch"), std::string::npos)
      << informed.text;
  const nlohmann::json facts =
      nlohmann::json::parse(geolloyd_with("info --json " + file.string()).text);
  EXPECT_EQ(facts["non_manifold_vertices"], 1);
  EXPECT_EQ(facts["boundary_loops"], 0);
  EXPECT_EQ(facts["is_manifold"], false);
  EXPECT_EQ(facts["triangles"], touching.triangle_count());
}

// Sums over seeds.csv and regions.csv agree with each other and with the report.
TEST_F(Program, FilesAgreeWithEachOther) {
  ASSERT_EQ(relax("--seeds 20").status, 0);
  std::map<int, int> nodes_of_region;
  for (const std::string& line : lines_of(out() / "regions.csv")) {
    if (line.rfind("input_id", 0) == 0) continue;
    const std::size_t region = line.find(',', line.find(',') + 1) + 1;
    ++nodes_of_region[std::stoi(line.substr(region))];
  }
  double energy = 0;
  const auto seeds = lines_of(out() / "seeds.csv");
  for (std::size_t r = 0; r + 1 < seeds.size(); ++r) {
    std::istringstream fields(seeds[r + 1]);
    std::vector<std::string> field;
    for (std::string f; std::getline(fields, f, ',');) field.push_back(f);
    ASSERT_EQ(field.size(), 8U);
    EXPECT_EQ(nodes_of_region[static_cast<int>(r)], std::stoi(field[5]));
    energy += std::stod(field[7]);
  }
  EXPECT_NEAR(energy / report_in(out())["energy"].get<double>(), 1, 1e-9);
}

// Each option does something: no two of these give the same course.
TEST_F(Program, WorksOnEveryGraphInitNormAndMode) {
  std::set<std::string> fingerprints;
  const std::vector<std::string> all_options = {"",
                                                "-g vertex-dense",
                                                "-g triangle",
                                                "-g triangle-dense",
                                                "-g mixed",
                                                "-g vertex-far",
                                                "-g vertex-far --norm linf --vfield cross",
                                                "--init random",
                                                "--init random-area",
                                                "--init kmeans++",
                                                "--norm manhattan",
                                                "--norm linf",
                                                "--greedy extended",
                                                "--greedy standard",
                                                "--init farthest",
                                                "--init farthest --random-seed 2",
                                                "--greedy extended --max-greedy-steps 3"};
  for (const std::string& options : all_options) {
    const Outcome outcome = relax("--seeds 20 " + options);
    ASSERT_EQ(outcome.status, 0) << options << ": " << outcome.text;
    const nlohmann::json report = report_in(out());
    EXPECT_EQ(report["options"]["seeds"], 20) << options;
    EXPECT_EQ(report["end"], "converged") << options;
    EXPECT_EQ(report["steps"]["greedy"] == 0, report["options"]["greedy"] == "off");
    EXPECT_TRUE(fingerprints.insert(report["fingerprint"].get<std::string>()).second) << options;
  }
  EXPECT_EQ(relax("--seeds 20 --no-macrostep-skip").status, 0);
  EXPECT_EQ(report_in(out())["options"]["macrostep_skip"], false);
}

TEST_F(Program, ChoosesTheGreedyModeByTheFirstSeeds) {
  ASSERT_EQ(relax("--seeds 20 --init random", "earlier").status, 0);
  const std::string file = "--seeds-file " + (out("earlier") / "seeds.csv").string();
  const std::pair<std::string, std::string> rows[] = {
      {"--seeds 20", "off"},
      {"--seeds 20 --init farthest", "off"},
      {"--seeds 20 --init kmeans++", "extended"},
      {"--seeds 20 --init random-area", "extended"},
      {"--seeds 20 --init random", "extended"},
      {file, "extended"},
  };
  for (const auto& [seeds, mode] : rows) {
    std::set<std::string> fingerprints;
    for (const std::string& greedy :
         std::vector<std::string>{"", " --greedy auto", " --greedy " + mode}) {
      ASSERT_EQ(relax(seeds + greedy).status, 0) << seeds << greedy;
      const nlohmann::json report = report_in(out());
      EXPECT_EQ(report["options"]["greedy"], mode) << seeds << greedy;
      EXPECT_EQ(report["steps"]["greedy"] == 0, mode == "off") << seeds << greedy;
      fingerprints.insert(report["fingerprint"].get<std::string>());
    }
    EXPECT_EQ(fingerprints.size(), 1U) << seeds;
  }
}

TEST_F(Program, WarnsInOneLineWhereRegionsAreTooSmallForAGoodRemesh) {
  const auto said = [this](const std::string& options) {  // on standard error
    const Outcome outcome = run_shell("(" GEOLLOYD_PROGRAM " relax " + mesh_.string() + " -o " +
                                      out().string() + " " + options + " >/dev/null)");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return outcome.text;
  };
  EXPECT_EQ(said("--seeds 101"), mesh_.string() +
                                     ": 1,000 nodes for 101 seeds: with fewer than 10 a seed the "
                                     "dual will be poor: subdivide the mesh, or use fewer seeds\n");
  EXPECT_EQ(said("--seeds 100"), "");
  EXPECT_EQ(said("--seeds 101 -g triangle"), "");
}

TEST_F(Program, GivesTheSameFingerprintAgainAndWithTheMicrostepsSearched) {
  std::set<std::string> fingerprints;
  for (const std::string options : {"", "", "--no-microstep-skip"}) {
    ASSERT_EQ(relax("--seeds 20 " + options).status, 0);
    fingerprints.insert(report_in(out())["fingerprint"].get<std::string>());
  }
  EXPECT_EQ(fingerprints.size(), 1U);
}

TEST_F(Program, GivesTheSameFingerprintWhateverTheEngineFrontierThreadsAndBackend) {
  ASSERT_EQ(relax("--seeds 20 --engine reference").status, 0);
  const nlohmann::json reference = report_in(out());
  EXPECT_EQ(reference["options"]["engine"], "reference");
  EXPECT_EQ(reference["options"]["threads"], 1);
  for (const std::string frontier : {"heap", "delta", "regions", "auto"}) {
    for (const std::string team : {"--threads 1", "--threads 3", "--threads 2 --backend openmp"}) {
      ASSERT_EQ(relax("--seeds 20 --frontier " + frontier + " " + team).status, 0);
      const nlohmann::json report = report_in(out());
      EXPECT_EQ(report["fingerprint"], reference["fingerprint"]);
      EXPECT_EQ(report["steps"], reference["steps"]);
      EXPECT_EQ(report["options"]["frontier"], frontier);
    }
  }
}

TEST_F(Program, VerifiesThatTheEnginesAgree) {
  const Outcome outcome = geolloyd_with("verify " + mesh_.string() + " --seeds 20 --threads 3");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("identical"), std::string::npos) << outcome.text;
  ASSERT_EQ(relax("--seeds 20").status, 0);
  EXPECT_NE(outcome.text.find(report_in(out())["fingerprint"].get<std::string>()),
            std::string::npos)
      << outcome.text;
  expect_complaint(geolloyd_with("verify " + mesh_.string()), "how many regions?");
}

// Address space enough to start, and not enough to end.
TEST_F(Program, SaysSoWhenMemoryRunsOut) {
  if (under_sanitizer) GTEST_SKIP() << "sanitizers need more address space than that";
  mesh_ = folder_.path() / "sphere.ply";
  ASSERT_EQ(geolloyd_with("generate icosphere -t 1000000 -o " + mesh_.string()).status, 0);
  for (const char* kilobytes : {"150000", "200000", "250000", "300000", "350000", "400000"}) {
    const Outcome outcome = run_shell(
        "ulimit -v " + std::string(kilobytes) + "; " GEOLLOYD_PROGRAM " relax " + mesh_.string() +
        " --seeds 2000 --max-greedy-steps 1 --max-macrosteps 1 -o " + out(kilobytes).string());
    if (outcome.status == 0) continue;         // there may be room for all
    expect_complaint(outcome, "are allowed");  // foreseen, or met
    EXPECT_FALSE(fs::exists(out(kilobytes) / "report.json"));
  }
}

TEST_F(Program, ContinuesFromWrittenSeeds) {
  ASSERT_EQ(relax("--seeds 20 --init farthest --max-macrosteps 1", "first").status, 0);
  EXPECT_EQ(report_in(out("first"))["end"], "limit");
  const double reached = report_in(out("first"))["energy"];
  ASSERT_EQ(relax("--seeds-file " + (out("first") / "seeds.csv").string(), "second").status, 0);
  EXPECT_DOUBLE_EQ(report_in(out("second"))["energy_initial"].get<double>(), reached);
  EXPECT_LT(report_in(out("second"))["energy"], reached);
  EXPECT_EQ(report_in(out("second"))["end"], "converged");
}

TEST_F(Program, MakesAFieldOfTheSurfacesCurvature) {
  mesh_ = folder_.path() / "tube.ply";
  ASSERT_EQ(geolloyd_with("generate cylinder -t 2000 -o " + mesh_.string()).status, 0);
  ASSERT_EQ(relax("--seeds 20", "isotropic").status, 0);
  ASSERT_EQ(relax("--seeds 20 --vfield curvature", "metric").status, 0);
  ASSERT_EQ(relax("--seeds 20 --vfield curvature --averaging pairwise", "pairwise").status, 0);
  EXPECT_EQ(report_in(out("isotropic"))["options"]["averaging"], nullptr);
  EXPECT_EQ(report_in(out("metric"))["options"]["averaging"], "metric");
  EXPECT_EQ(report_in(out("metric"))["options"]["vfield"], "curvature");
  EXPECT_EQ(report_in(out("pairwise"))["options"]["averaging"], "pairwise");
  EXPECT_NE(report_in(out("metric"))["fingerprint"], report_in(out("isotropic"))["fingerprint"]);
  EXPECT_NE(relax("--seeds 20 --vfield ./curvature", "file").status, 0);
}

TEST_F(Program, MakesAFieldOfCrosses) {
  ASSERT_EQ(relax("--seeds 20 --norm linf", "coordinates").status, 0);
  ASSERT_EQ(relax("--seeds 20 --norm linf --vfield cross", "crosses").status, 0);
  EXPECT_EQ(report_in(out("crosses"))["options"]["vfield"], "cross");
  EXPECT_EQ(report_in(out("crosses"))["options"]["averaging"], "pairwise");
  EXPECT_NE(report_in(out("crosses"))["fingerprint"], report_in(out("coordinates"))["fingerprint"]);
  EXPECT_NE(relax("--seeds 20 --vfield ./cross", "file").status, 0);
}

TEST_F(Program, JoinsTrianglesOfTheRemesh) {
  ASSERT_EQ(relax("--seeds 100", "triangles").status, 0);
  ASSERT_EQ(relax("--seeds 100 --quads", "quads").status, 0);
  EXPECT_EQ(report_in(out("triangles"))["quads"], nullptr);
  const nlohmann::json quads = report_in(out("quads"))["quads"];
  const auto joined = quads["quadrilaterals"].get<std::size_t>();
  const auto left = quads["triangles"].get<std::size_t>();
  EXPECT_GT(joined, left);
  EXPECT_GE(quads["smallest_angle"], 29.9);
  EXPECT_EQ(2 * joined + left, report_in(out("quads"))["dual"]["triangles"]);
  EXPECT_NE(read_file(out("quads") / "dual.ply")
                .find("element face " + std::to_string(joined + left) + "\n"),
            std::string::npos);
  const Mesh mesh = read(out("quads") / "dual.ply").mesh;
  EXPECT_EQ(mesh.triangle_count(), 2 * joined + left);
  EXPECT_EQ(mesh.vertex_count(), read(out("triangles") / "dual.ply").mesh.vertex_count());
}

TEST_F(Program, StretchesRegionsAlongAField) {
  const fs::path plane = folder_.path() / "plane.ply";
  ASSERT_EQ(geolloyd_with("generate plane -t 20000 -o " + plane.string()).status, 0);
  const Mesh mesh = read(plane).mesh;
  std::string field = "k1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n";
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) field += "3 1 1 0 0 0 1 0\n";
  mesh_ = plane;
  ASSERT_EQ(
      relax("--seeds 100 -g vertex-dense --vfield " + folder_.write("f.vfield", field).string())
          .status,
      0);

  // Second moments of the regions about their means, by axis. In the plane itself it would be 3 to
  // 1; the graph's zigzags cost more across the field than along it.
  std::vector<std::array<double, 5>> sums(100);
  const auto lines = lines_of(out() / "regions.csv");
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::string& line = lines[v + 1];
    auto& s = sums[std::stoul(line.substr(line.find(',', line.find(',') + 1) + 1))];
    const Vec3& p = mesh.positions[v];
    s[0] += 1;
    s[1] += p.x();
    s[2] += p.y();
    s[3] += p.x() * p.x();
    s[4] += p.y() * p.y();
  }
  double along = 0;
  double across = 0;
  for (const auto& s : sums) {
    along += s[3] - s[1] * s[1] / s[0];
    across += s[4] - s[2] * s[2] / s[0];
  }
  EXPECT_GT(std::sqrt(across / along), 2.3);
  EXPECT_LT(std::sqrt(across / along), 3.2);
}

TEST_F(Program, DrawsItsResult) {
  EXPECT_EQ(relax("--seeds 4 --picture " + (folder_.path() / "p.png").string()).status, 0);
  EXPECT_EQ(read_file(folder_.path() / "p.png").substr(1, 3), "PNG");
}

// Meshes without area, of one triangle, of any size: a result, and no "nan" in it.
TEST_F(Program, TessellatesWhatIsHardlyASurface) {
  const std::string faces = "3 0 1 2\n3 0 2 3\n";
  const std::map<std::string, std::string> vertices = {
      {"point", "1 1 1\n1 1 1\n1 1 1\n1 1 1\n"},
      {"line", "0 0 0\n1 0 0\n2 0 0\n3 0 0\n"},
      {"tiny", "0 0 0\n1e-30 0 0\n1e-30 1e-30 0\n0 1e-30 0\n"},
      {"huge", "0 0 0\n1e30 0 0\n1e30 1e30 0\n0 1e30 0\n"}};
  for (const auto& [name, text] : vertices) {
    mesh_ = folder_.write(name + ".off", "OFF\n4 2 0\n" + text + faces);
    for (const std::string graph :
         {"vertex", "vertex-dense", "triangle", "triangle-dense", "mixed", "vertex-far"}) {
      const std::string picture =
          graph == "mixed" ? " --size 200x200 --picture " + out("p.png").string() : "";
      const Outcome outcome = relax("--seeds 2 -g " + graph + picture);
      EXPECT_EQ(outcome.status, 0) << name << " " << graph << ": " << outcome.text;
      EXPECT_EQ(outcome.text.find("nan"), std::string::npos) << outcome.text;
      EXPECT_EQ(report_in(out())["end"], "converged");
    }
  }
}

TEST_F(Program, ReportNamesItsInput) {
  const fs::path odd = folder_.path() / "ein schöner Name.ply";
  fs::rename(mesh_, odd);
  const Outcome outcome =
      geolloyd_with("relax '" + odd.string() + "' --seeds 4 -o " + out().string());
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(report_in(out())["input"]["file"], odd.string());
}

class Interrupt : public Program, public testing::WithParamInterface<const char*> {
 protected:
  // From random seeds on a mesh of this size the relaxation takes seconds.
  void SetUp() override {
    Program::SetUp();
    mesh_ = folder_.path() / "sphere.ply";
    ASSERT_EQ(geolloyd_with("generate icosphere -t 400000 -o " + mesh_.string()).status, 0);
  }

  [[nodiscard]] Running start() const {
    std::vector<std::string> arguments = {
        "relax", mesh_.string(), "-o", out().string(), "--seeds", "6", "--init", "random"};
    std::istringstream options(GetParam());
    for (std::string option; options >> option;) arguments.push_back(option);
    return {arguments, folder_.path() / "text", out()};
  }
};

TEST_P(Interrupt, EndsWithAMarkedResultThatCanBeContinued) {
  Running running = start();
  ::usleep(100'000);
  running.send(SIGINT);
  running.send(SIGINT);  // as timeout(1) does
  EXPECT_EQ(running.wait(), 130);
  const nlohmann::json report = report_in(out());
  EXPECT_EQ(report["end"], "interrupted");
  EXPECT_EQ(report["interrupted"], true);
  EXPECT_LE(report["energy"], report["energy_initial"]);
  std::size_t violations = 0;
  for (const nlohmann::json& count : report["dual"]["closed_ball_violations_found"]) {
    violations += count.get<std::size_t>();
  }
  const bool needs_seeds = violations > 0;
  EXPECT_EQ(report["dual"]["interrupted"], needs_seeds);
  EXPECT_EQ(read_file(folder_.path() / "text").find("INTERRUPTED while seeds were added") !=
                std::string::npos,
            needs_seeds);
  EXPECT_NE(read_file(folder_.path() / "text").find("INTERRUPTED"), std::string::npos);
  EXPECT_EQ(lines_of(out() / "seeds.csv").size(), 7U);

  const Outcome again = relax(
      "--max-greedy-steps 1 --max-macrosteps 0 --seeds-file " + (out() / "seeds.csv").string(),
      "again");
  EXPECT_EQ(again.status, 0) << again.text;
  EXPECT_DOUBLE_EQ(report_in(out("again"))["energy_initial"].get<double>(), report["energy"]);
}

TEST_P(Interrupt, ByTermIsTheSame) {
  Running running = start();
  running.send(SIGTERM);
  EXPECT_EQ(running.wait(), 130);
  EXPECT_EQ(report_in(out())["interrupted"], true);
}

INSTANTIATE_TEST_SUITE_P(Engines, Interrupt,
                         testing::Values("--engine reference", "--engine parallel",
                                         "--greedy off --backend openmp --threads 3"));

TEST_F(Program, IsSilentAboutProgressInAPipe) {
  const Outcome outcome = relax("--seeds 20");
  EXPECT_EQ(outcome.text.find('\r'), std::string::npos);
  EXPECT_EQ(outcome.text.find("moving"), std::string::npos);
}

TEST_F(Program, SubdividesAndInforms) {
  const fs::path finer = folder_.path() / "finer.obj";
  const Outcome outcome = geolloyd_with("subdivide " + mesh_.string() +
                                        " -s midpoint -s barycentric -o " + finer.string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(read(finer).mesh.triangle_count(), 2000U * 4 * 6);
  const Outcome info = geolloyd_with("info " + finer.string());
  EXPECT_EQ(info.status, 0);
  EXPECT_NE(info.text.find("48,000 triangles"), std::string::npos) << info.text;
  EXPECT_NE(info.text.find("Euler characteristic 0, closed"), std::string::npos) << info.text;
}

// In the order that the usage shows.
TEST_F(Program, SubdividesWhatFollowsTheSchemes) {
  const std::string finer = (folder_.path() / "finer.obj").string();
  const Outcome outcome =
      geolloyd_with("subdivide -s midpoint,barycentric " + mesh_.string() + " -o " + finer);
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(read(finer).mesh.triangle_count(), 2000U * 4 * 6);
}

// A folder that is there may be called anything.
TEST_F(Program, WritesIntoAFolderNamedLikeAMesh) {
  fs::create_directory(out("folder.ply"));
  EXPECT_EQ(relax("--seeds 20", "folder.ply").status, 0);
  EXPECT_TRUE(fs::exists(out("folder.ply") / "report.json"));
}

TEST_F(Program, SaysWhatItWasBuiltWith) {
  const std::string facts = geolloyd_with("--version").text;
  EXPECT_EQ(facts.rfind(program_name() + "\n", 0), 0U) << facts;
  for (const std::string& what : {compiler_name(), std::string("-ffp-contract=off"),
                                  std::string("oneTBB 20"), std::string("Embree ")}) {
    EXPECT_NE(facts.find(what), std::string::npos) << facts;
  }
}

TEST_F(Program, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(geolloyd_with("--version").status, 0);
  for (const std::string command : {"", "relax ", "remesh ", "verify ", "compare ", "profile ",
                                    "batch ", "generate ", "subdivide ", "info "}) {
    const Outcome help = geolloyd_with(command + "--help");
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.text.find("Usage:"), std::string::npos);
  }
}

// Each file is the same as among the others.
TEST_F(Program, WritesOnlyWhatIsAskedFor) {
  ASSERT_EQ(relax("--seeds 20", "all").status, 0);
  for (const std::string file :
       {"tessellation.ply", "seeds.csv", "regions.csv", "dual.ply", "report.json"}) {
    SCOPED_TRACE(file);
    const std::string name = file.substr(0, file.find('.'));
    const Outcome outcome = relax("--seeds 20 --only " + name, name);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find(name + "/: " + file + "\n"), std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.text.find("removed"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(out(name)), {}), 1);
    if (name == "report") {
      EXPECT_EQ(report_in(out(name))["fingerprint"], report_in(out("all"))["fingerprint"]);
      EXPECT_EQ(report_in(out(name))["dual"], report_in(out("all"))["dual"]);
    } else {
      EXPECT_EQ(read_file(out(name) / file), read_file(out("all") / file));
    }
  }
  const Outcome two = relax("--seeds 20 --only dual,seeds", "two");
  EXPECT_NE(two.text.find("two/: seeds.csv dual.ply\n"), std::string::npos) << two.text;
  EXPECT_NE(two.text.find("\n  dual "), std::string::npos) << two.text;
  const Outcome none = relax("--seeds 20 --only seeds", "none");
  EXPECT_EQ(none.text.find("\n  dual "), std::string::npos) << none.text;
}

// What is left of it would look like a part of this run's result.
TEST_F(Program, RemovesFilesOfAnEarlierRunThatAreNotAskedFor) {
  ASSERT_EQ(relax("--seeds 20").status, 0);
  const std::string seeds = (out() / "seeds.csv").string();
  expect_complaint(relax("--only dual --seeds-file " + seeds), "would be overwritten");
  EXPECT_TRUE(fs::exists(out() / "report.json"));
  const Outcome outcome = relax("--seeds 30 --only dual,regions");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("out/: tessellation.ply seeds.csv report.json, of an earlier run"),
            std::string::npos)
      << outcome.text;
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 2);
}

TEST_F(Program, ListsTheOutputsThereAre) {
  expect_complaint(relax("--seeds 20 --only seeds,remsh"),
                   "--only: remsh not in {tessellation,seeds,regions,dual,report}");
  expect_complaint(relax("--seeds 20 --only ''"), "--only");
  EXPECT_FALSE(fs::exists(out()));
}

}  // namespace
}  // namespace geolloyd

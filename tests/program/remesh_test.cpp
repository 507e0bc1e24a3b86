// The command remesh, and verify for remeshes.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_edges.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"
#include "tests/support/sanitizers.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

class Remeshing : public Program {
 protected:
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }

  [[nodiscard]] Outcome remesh(const std::string& options,
                               const std::string& name = "r.ply") const {
    return geolloyd_with("remesh " + mesh_.string() + " -o " + file(name).string() + " " + options);
  }

  [[nodiscard]] nlohmann::json report_of(const std::string& options) const {
    const Outcome outcome = remesh(options + " --report " + file("r.json").string());
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return nlohmann::json::parse(read_file(file("r.json")));
  }

  static void write_list(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
  }

  static void expect_text(const Outcome& outcome, const std::string& text) {
    EXPECT_NE(outcome.text.find(text), std::string::npos) << text << "\n" << outcome.text;
  }
};

TEST_F(Remeshing, WritesAllItsFiles) {
  const Outcome outcome =
      remesh("--vertices 150 --size 200 --report " + file("r.json").string() + " --map " +
             file("r.csv").string() + " --picture " + file("r.png").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  expect_text(outcome,
              "150 vertices, 300 triangles, 1 component, Euler characteristic 0, 0 boundary "
              "loops, manifold, of the input's topology\n");
  for (const char* name : {"r.ply", "r.json", "r.csv", "r.png"}) {
    expect_text(outcome, file(name).string());
  }
  const Mesh made = read(file("r.ply")).mesh;
  EXPECT_EQ(made.vertex_count(), 150U);
  const MeshTopology topology = topology_of(made);
  EXPECT_TRUE(topology.is_manifold());
  EXPECT_EQ(topology.parts, (std::vector<PartTopology>{{0, 0}}));
  EXPECT_EQ(read_file(file("r.png")).substr(1, 3), "PNG");
  EXPECT_TRUE(nlohmann::json::accept(read_file(file("r.json"))));
}

// Each vertex is where the map says.
TEST_F(Remeshing, MapsItsVerticesOntoTheInput) {
  ASSERT_EQ(remesh("--vertices 150 --no-fit --map " + file("r.csv").string()).status, 0);
  const Mesh input = read(mesh_).mesh;
  const Mesh made = read(file("r.ply")).mesh;
  const auto lines = lines_of(file("r.csv"));
  ASSERT_EQ(lines.size(), 151U);
  EXPECT_EQ(lines[0], "vertex,triangle,weight_0,weight_1,weight_2");
  for (std::size_t v = 0; v < 150; ++v) {
    std::istringstream fields(lines[v + 1]);
    std::vector<std::string> field;
    for (std::string f; std::getline(fields, f, ',');) field.push_back(f);
    ASSERT_EQ(field.size(), 5U) << lines[v + 1];
    EXPECT_EQ(field[0], std::to_string(v));
    const Triangle& t = input.triangles.at(std::stoul(field[1]));
    Vec3 place = Vec3::Zero();
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double weight = std::stod(field[2 + c]);
      EXPECT_GE(weight, 0);
      sum += weight;
      place += weight * input.positions[t[c]];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_LT((place - made.positions[v]).norm(), 1e-14);
  }
}

TEST_F(Remeshing, ReportHasTheKeysThatScriptsRelyOn) {
  const nlohmann::json report = report_of("--vertices 150 --threads 2 --backend openmp");
  EXPECT_EQ(report["fingerprint"].get<std::string>().size(), 16U);
  EXPECT_EQ(report["input"]["triangles"], 2000);
  EXPECT_EQ(report["options"]["vertices"], 150);
  EXPECT_EQ(report["options"]["engine"], "parallel");
  EXPECT_EQ(report["options"]["threads"], 2);
  EXPECT_EQ(report["options"]["backend"], "openmp");
  EXPECT_EQ(report["interrupted"], false);
  EXPECT_EQ(report["trace"].size(), report["iterations"]);
  EXPECT_EQ(report["trace"].back()["mesh_vertices"].get<std::size_t>() >= 1000, true);
  for (const nlohmann::json& step : report["trace"]) EXPECT_GT(step["energy"], 0);
  EXPECT_NEAR(report["trace"].back()["energy"].get<double>() / report["energy"].get<double>(), 1,
              0.02);
  const nlohmann::json& told = report["remesh"];
  EXPECT_EQ(told["vertices"], 150);
  EXPECT_EQ(told["triangles"], 300);
  EXPECT_EQ(told["surplus_vertices"], 0);
  EXPECT_EQ(told["curve_vertices"], 0);
  EXPECT_EQ(told["is_manifold"], true);
  EXPECT_EQ(told["has_input_topology"], true);
  EXPECT_EQ(told["input_is_manifold"], true);
  EXPECT_EQ(told["topology"], told["input_topology"]);
  EXPECT_TRUE(told["flaw"].is_null());
  EXPECT_EQ(told["closed_ball_violations_left"], 0);
  double sum = 0;
  for (const char* part : {"load", "edges", "prepare", "move", "assemble", "judge", "write"}) {
    EXPECT_GE(report["seconds"][part], 0) << part;
    sum += report["seconds"][part].get<double>();
  }
  EXPECT_LE(sum, report["seconds"]["total"].get<double>());
  EXPECT_GT(report["peak_memory_bytes"], 1'000'000);
  EXPECT_GT(report["memory_estimate_bytes"], 1'000'000);
}

// What is told of a remesh is what `quality` finds in its file.
TEST_F(Remeshing, JudgesAsQualityDoes) {
  const nlohmann::json report = report_of("--vertices 150");
  const Outcome judged =
      geolloyd_with("quality " + file("r.ply").string() + " --original " + mesh_.string() +
                    " --samples 25000 -o " + file("q.json").string());
  ASSERT_EQ(judged.status, 0) << judged.text;
  const auto quality = nlohmann::json::parse(read_file(file("q.json")));
  EXPECT_EQ(report["quality"], quality["quality"]);
  EXPECT_EQ(report["remesh"]["topology"], quality["topology"]);
  nlohmann::json distance = report["input_to_remesh"];
  EXPECT_EQ(distance["samples"], 25'000);
  distance.erase("samples");
  EXPECT_EQ(distance, quality["likeness"]["original_to_remesh"]);
  EXPECT_NEAR(report["energy_ratio_hexagonal"].get<double>(),
              quality["likeness"]["energy_ratio_hexagonal"].get<double>(), 0.01);
}

// A shape beside the mesh of all tests.
TEST_F(Remeshing, KeepsSharpEdges) {
  ASSERT_EQ(geolloyd_with("generate cube -t 300 -o " + file("cube.ply").string()).status, 0);
  const std::string start = "remesh " + file("cube.ply").string() + " -n 200 -o " +
                            file("r.ply").string() + " --report " + file("r.json").string();
  const Outcome sharp = geolloyd_with(start);
  ASSERT_EQ(sharp.status, 0) << sharp.text;
  expect_text(sharp, " of length 12 run along features of the input\n");
  nlohmann::json told = nlohmann::json::parse(read_file(file("r.json")));
  EXPECT_NEAR(told["remesh"]["feature_length"].get<double>(), 12, 1e-6);
  EXPECT_EQ(told["options"]["features"], "auto");
  EXPECT_LT(told["input_to_remesh"]["hausdorff"].get<double>(), 1e-6);
  const Outcome round = geolloyd_with(start + " --features off --no-fit");
  ASSERT_EQ(round.status, 0) << round.text;
  told = nlohmann::json::parse(read_file(file("r.json")));
  EXPECT_EQ(told["remesh"]["feature_edges"], 0);
  EXPECT_EQ(told["remesh"]["vertices_fitted"], 0);
  EXPECT_GT(told["input_to_remesh"]["hausdorff"].get<double>(), 0.01);
  ASSERT_EQ(geolloyd_with(start + " --features 91").status, 0);
  told = nlohmann::json::parse(read_file(file("r.json")));
  EXPECT_EQ(told["remesh"]["feature_edges"], 0);
  EXPECT_EQ(told["options"]["features"], "91");
}

TEST_F(Remeshing, KeepsEdgesAndVerticesOfFiles) {
  const Mesh input = read(mesh_).mesh;
  const auto& [a, b, c] = input.triangles[100];
  write_list(file("edges.txt"), "# one\n\n" + std::to_string(a) + " " + std::to_string(b) + "\n");
  write_list(file("fixed.txt"), std::to_string(c) + "\n7\n");
  const nlohmann::json report = report_of("-n 300 --feature-edges " + file("edges.txt").string() +
                                          " --fixed " + file("fixed.txt").string());
  EXPECT_GE(report["remesh"]["feature_edges"], 1);
  const Mesh made = read(file("r.ply")).mesh;
  for (const VertexId v : {a, b, c, VertexId{7}}) {
    EXPECT_NE(std::find(made.positions.begin(), made.positions.end(), input.positions[v]),
              made.positions.end())
        << v;
  }
}

TEST_F(Remeshing, RefusesFilesThatDoNotFit) {
  const auto expect_refused = [&](const std::string& option, const std::string& text,
                                  const std::string& message) {
    write_list(file("list.txt"), text);
    const Outcome outcome = remesh("-n 100 " + option + " " + file("list.txt").string());
    EXPECT_EQ(outcome.status, 2);
    expect_text(outcome, message);
  };
  expect_refused("--fixed", "1\n2000000\n", "list.txt: line 2: the mesh has no vertex 2000000");
  expect_refused("--fixed", "1\n\n2 3\n", "list.txt: line 3: expected a vertex and no more");
  expect_refused("--fixed", "x\n", "list.txt: line 1: expected a vertex, found 'x'");
  expect_refused("--feature-edges", "1\n", "list.txt: line 1: expected a vertex");
  expect_refused("--feature-edges", "0 999\n", "list.txt: line 1: the mesh has no edge from");
  const Outcome own = geolloyd_with("remesh " + mesh_.string() + " -n 100 --fixed " +
                                    file("list.txt").string() + " -o " + file("list.txt").string());
  EXPECT_EQ(own.status, 2);
}

TEST_F(Remeshing, HasEdgesOfTheLengthAskedFor) {
  for (const double length : {0.1, 0.25}) {
    const nlohmann::json report = report_of("--edge-length " + std::to_string(length));
    const Mesh made = read(file("r.ply")).mesh;
    const MeshEdges edges = find_edges(made);
    double sum = 0;
    for (const auto& [a, b] : edges.ends) sum += norm(made.positions[a] - made.positions[b]);
    EXPECT_NEAR(sum / static_cast<double>(edges.size()), length, 0.02 * length);
    EXPECT_EQ(report["options"]["vertices"], nullptr);
    EXPECT_EQ(report["remesh"]["surplus_vertices"], 0);
  }
}

// One number per vertex of the input.
std::string ramp_for(const Mesh& mesh) {
  std::string lines = "# lengths\n";
  for (const Vec3& p : mesh.positions) lines += std::to_string(0.15 + 0.05 * p.x()) + "\n";
  return lines;
}

TEST_F(Remeshing, FollowsSizes) {
  const std::string lines = ramp_for(read(mesh_).mesh);
  write_list(file("sizes.txt"), lines);
  const nlohmann::json alone = report_of("--sizing " + file("sizes.txt").string());
  const nlohmann::json ratios = alone["edge_length_ratios"];
  EXPECT_NEAR(ratios["median"].get<double>(), 1, 0.05);
  EXPECT_GE(ratios["within_a_third_percent"].get<double>(), 95);
  const nlohmann::json scaled = report_of("-n 300 --sizing " + file("sizes.txt").string());
  EXPECT_EQ(scaled["remesh"]["vertices"], 300);
  EXPECT_EQ(report_of("-n 300 --density " + file("sizes.txt").string())["remesh"]["vertices"], 300);
  const nlohmann::json adapted = report_of("-n 300 --adapt 1 --growth 1.2");
  EXPECT_EQ(adapted["options"]["adapt"], 1);
  EXPECT_EQ(adapted["options"]["growth"], 1.2);
  EXPECT_TRUE(adapted["remesh"]["has_input_topology"].get<bool>());
  EXPECT_TRUE(report_of("-n 300")["edge_length_ratios"].is_null());
}

std::string field_for(const Mesh& mesh, const std::string& magnitudes) {
  std::string lines = "k1 k2 ax ay az bx by bz\n";
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) lines += magnitudes + " 1 0 0 0 1 0\n";
  return lines;
}

TEST_F(Remeshing, FollowsATangentField) {
  const nlohmann::json curved = report_of("-n 80 --vfield curvature");
  EXPECT_TRUE(curved["remesh"]["has_input_topology"].get<bool>());
  EXPECT_EQ(curved["options"]["vfield"], "curvature");
  EXPECT_GT(curved["quality_in_metric"]["mean_quality"], curved["quality"]["mean_quality"]);
  EXPECT_TRUE(report_of("-n 40")["quality_in_metric"].is_null());

  write_list(file("a.vfield"), field_for(read(mesh_).mesh, "2 1"));
  const std::string field = " --vfield " + file("a.vfield").string();
  EXPECT_EQ(report_of("-n 60" + field)["remesh"]["vertices"], 60);
  const nlohmann::json by_length = report_of("--edge-length 0.3" + field);
  EXPECT_NEAR(by_length["edge_length_ratios"]["median"].get<double>(), 1, 0.08);
  const std::string judged = file("judged.json").string();
  EXPECT_EQ(geolloyd_with("quality " + file("r.ply").string() + " --original " + mesh_.string() +
                          field + " -o " + judged)
                .status,
            0);
  const nlohmann::json in_metric = nlohmann::json::parse(read_file(judged))["in_metric"];
  EXPECT_NEAR(in_metric["mean_edge_length"].get<double>(), 0.3, 0.04);
  EXPECT_NEAR(in_metric["energy_ratio_hexagonal"].get<double>(), 1, 0.1);
  EXPECT_EQ(geolloyd_with("verify " + mesh_.string() + " -n 40" + field).status, 0);
}

TEST_F(Remeshing, RefusesFieldsThatDoNotFit) {
  const auto expect_refused = [&](const std::string& message, const std::string& options) {
    expect_complaint(remesh(options), message);
  };
  const std::string field = "-n 100 --vfield " + file("a.vfield").string();
  write_list(file("a.vfield"), field_for(read(mesh_).mesh, "0 1"));
  expect_refused("field: vertex 0 has the principal magnitudes 0 and 1", field);
  write_list(file("a.vfield"), field_for(read(mesh_).mesh, "1000 1"));
  expect_refused("one at most 100 times the other", field);
  write_list(file("a.vfield"), "k1 k2 ax ay az bx by bz\n1 1 1 0 0 0 1 0\n");
  expect_refused("a.vfield", field);
  expect_refused("--vfield", field + " --repair");
  expect_refused("--vfield cross: has directions without magnitudes", "-n 100 --vfield cross");
  expect_complaint(geolloyd_with("quality " + mesh_.string() + " --vfield curvature"),
                   "--vfield: of which mesh? Give --original MESH");
}

TEST_F(Remeshing, RefusesSizesThatDoNotFit) {
  const std::string lines = ramp_for(read(mesh_).mesh);
  const std::string name = file("sizes.txt").string();
  const auto expect_refused = [&](const std::string& text, const std::string& options) {
    const Outcome outcome = remesh(options);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    expect_text(outcome, text);
    EXPECT_FALSE(fs::exists(file("r.ply")));
  };
  write_list(file("sizes.txt"), lines + "1\n");
  expect_refused("sizes.txt: line 1002: more numbers than the mesh has vertices (1000)",
                 "--sizing " + name);
  write_list(file("sizes.txt"), "1\n2\n");
  expect_refused("the file ends after 2 numbers, but the mesh has 1000 vertices",
                 "-n 100 --density " + name);
  for (const char* bad : {"0", "-1", "nan", "inf", "1 2", "x", "1e999"}) {
    write_list(file("sizes.txt"), std::string("1\n") + bad + "\n");
    expect_refused("sizes.txt: line 2: ", "--sizing " + name);
  }
  const std::string exclusive = "--sizing, --density, --adapt and --equal-error exclude each other";
  expect_refused(exclusive, "-n 100 --adapt 1 --density " + name);
  expect_refused(exclusive, "-n 100 --equal-error --adapt 1");
  expect_refused("how fine? Give ", "--adapt 1");
  expect_refused("--adapt: '2.5': give a number from 0 to 2", "-n 100 --adapt 2.5");
  expect_refused("--growth: '1': give a number above 1", "-n 100 --adapt 1 --growth 1");
}

TEST_F(Remeshing, StaysWithinATolerance) {
  const nlohmann::json report = report_of("--tolerance 6%");
  const double tolerance = 0.06 * report["input"]["bounding_diagonal"].get<double>();
  EXPECT_LE(report["input_to_remesh"]["hausdorff"].get<double>(), tolerance);
  EXPECT_LE(report["certified"]["hausdorff_upper"], tolerance);
  EXPECT_LE(report["certified"]["hausdorff_upper"].get<double>(),
            report["certified"]["hausdorff_lower"].get<double>() + 0.01 * tolerance);
  ASSERT_GE(report["trials"].size(), 2U);
  const auto vertices = report["remesh"]["vertices"].get<std::size_t>();
  bool has_close_failure = false;
  for (const nlohmann::json& trial : report["trials"]) {
    const auto tried = trial["vertices"].get<std::size_t>();
    EXPECT_TRUE(trial["distance"].get<double>() > tolerance || tried >= vertices);
    has_close_failure =
        has_close_failure || (trial["distance"].get<double>() > tolerance &&
                              1.06 * static_cast<double>(tried) >= static_cast<double>(vertices));
  }
  EXPECT_TRUE(has_close_failure);
}

TEST_F(Remeshing, SaysHowCloseItCameWhereAToleranceIsOutOfReach) {
  if (under_sanitizer) GTEST_SKIP() << "tries 100,000 vertices, which takes minutes";
  const Outcome impossible = remesh("--tolerance 1e-12");
  EXPECT_EQ(impossible.status, 2);
  expect_text(impossible, "tolerance: the largest distance is ");
}

// Without its times, which never go back.
nlohmann::json course_of(const nlohmann::json& report) {
  nlohmann::json course = report["trace"];
  double before = 0;
  for (nlohmann::json& step : course) {
    EXPECT_GE(step["seconds"], before);
    before = step["seconds"];
    step.erase("seconds");
  }
  EXPECT_LE(before, report["seconds"]["total"].get<double>());
  return course;
}

TEST_F(Remeshing, GivesTheSameFingerprintWhateverTheEngineThreadsAndBackend) {
  const nlohmann::json reference = report_of("--vertices 100 --engine reference");
  EXPECT_EQ(reference["options"]["threads"], 1);
  EXPECT_TRUE(reference["options"]["backend"].is_null());
  const std::string bytes = read_file(file("r.ply"));
  for (const std::string team : {"--threads 1", "--threads 3", "--threads 2 --backend openmp"}) {
    const nlohmann::json report = report_of("--vertices 100 " + team);
    EXPECT_EQ(report["fingerprint"], reference["fingerprint"]) << team;
    EXPECT_TRUE(course_of(report) == course_of(reference)) << team;
    EXPECT_EQ(read_file(file("r.ply")), bytes) << team;
  }
  EXPECT_NE(report_of("--vertices 101")["fingerprint"], reference["fingerprint"]);
}

TEST_F(Remeshing, WritesEveryFormatAndReplacesWhatWasThere) {
  for (const std::string name : {"r.obj", "r.off", "r.stl", "r.ply"}) {
    for (const std::string vertices : {"60", "90"}) {
      ASSERT_EQ(remesh("-n " + vertices, name).status, 0);
      const Mesh made = read(file(name)).mesh;
      EXPECT_EQ(made.vertex_count(), std::stoul(vertices)) << name;
      EXPECT_EQ(made.triangle_count(), 2 * std::stoul(vertices)) << name;
    }
  }
}

TEST_F(Remeshing, SaysHowItHandlesAnInputThatIsNoManifold) {
  mesh_ = folder_.write("fin.off",
                        "OFF\n6 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n9 9 9\n"
                        "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 2 1\n");
  const Outcome outcome = remesh("-n 60 --report " + file("r.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  expect_text(outcome, "1 vertices of no triangle: left out");
  expect_text(outcome, "1 duplicate triangles: left out");
  expect_text(outcome, "1 non-manifold edges: cut apart");
  expect_text(outcome,
              "of the topology of the input, which is no manifold and was cut apart at 2 vertices");
  const auto told = nlohmann::json::parse(read_file(file("r.json")))["remesh"];
  EXPECT_EQ(told["is_manifold"], true);
  EXPECT_EQ(told["input_is_manifold"], false);
  EXPECT_EQ(told["input_vertices_cut"], 2);
  EXPECT_EQ(told["input_topology"]["components"], 3);
}

// A component has vertices enough for its topology, however few were asked for.
TEST_F(Remeshing, SaysHowManyMoreVerticesTheTopologyNeeds) {
  const Outcome outcome = remesh("-n 4 --report " + file("r.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const std::size_t count = read(file("r.ply")).mesh.vertex_count();
  ASSERT_GE(count, 7U);  // no torus has fewer
  expect_text(outcome, std::to_string(count - 4) +
                           " vertices more than asked for, which the topology "
                           "needs\n");
  const auto told = nlohmann::json::parse(read_file(file("r.json")))["remesh"];
  EXPECT_EQ(told["surplus_vertices"], count - 4);
  EXPECT_EQ(told["has_input_topology"], true);
}

TEST_F(Remeshing, IsSilentAboutProgressInAPipe) {
  const Outcome outcome = remesh("-n 100");
  EXPECT_EQ(outcome.text.find('\r'), std::string::npos);
  EXPECT_EQ(outcome.text.find("iteration 1"), std::string::npos);
}

TEST_F(Remeshing, RefusesAMeshWithoutArea) {
  mesh_ = folder_.write("line.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  expect_complaint(remesh("-n 20"), "line.off: no triangle with an area, so nothing to remesh");
  expect_complaint(geolloyd_with("verify -n 20 " + mesh_.string()), "nothing to remesh");
  EXPECT_FALSE(fs::exists(file("r.ply")));
}

// A picture that cannot be drawn leaves the other files, a report that cannot leaves nothing.
TEST_F(Remeshing, LosesNoResultByALostPicture) {
  ASSERT_EQ(remesh("-n 50", "whole.ply").status, 0);
  const std::string files = " -o r.ply --map r.csv --report r.json --picture r.png --size 800";
  const std::string command = "cd " + folder_.path().string() + "; ulimit -f 200; " +
                              std::string(GEOLLOYD_PROGRAM) + " remesh torus.ply -n 50" + files;
  expect_complaint(run_shell(command), "r.png: cannot write: File too large");
  EXPECT_EQ(read_file(file("r.ply")), read_file(file("whole.ply")));
  EXPECT_TRUE(fs::exists(file("r.csv")));
  EXPECT_TRUE(fs::exists(file("r.json")));
  EXPECT_FALSE(fs::exists(file("r.png")));
}

TEST_F(Remeshing, LosesNoEarlierResultWhereOneFileCannotBeWritten) {
  const std::string files = " -o r.ply --map r.csv --report r.json";
  const std::string command = "cd " + folder_.path().string() + "; %" +
                              std::string(GEOLLOYD_PROGRAM) + " remesh torus.ply" + files + " -n ";
  const auto run = [&](const std::string& before, const std::string& vertices) {
    std::string text = command;
    return run_shell(text.replace(text.find('%'), 1, before) + vertices);
  };
  ASSERT_EQ(run("", "50").status, 0);
  std::map<std::string, std::string> earlier;
  for (const char* name : {"r.ply", "r.csv", "r.json"}) earlier[name] = read_file(file(name));
  expect_complaint(run("ulimit -f 8; ", "100"), "cannot write: File too large");
  for (const auto& [name, bytes] : earlier) EXPECT_EQ(read_file(file(name)), bytes) << name;
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    names.insert(entry.path().filename());
  }
  EXPECT_EQ(names, (std::set<std::string>{"torus.ply", "r.ply", "r.csv", "r.json"}));
}

TEST_F(Remeshing, VerifiesThatTheEnginesAgree) {
  const Outcome outcome = geolloyd_with("verify " + mesh_.string() + " --vertices 150 --threads 3");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  expect_text(outcome, "1,000 vertices, remesh of 150\n  identical   in all ");
  expect_text(outcome, report_of("--vertices 150")["fingerprint"].get<std::string>());
  const std::string more = " --adapt 1 --features 30";
  const Outcome sized = geolloyd_with("verify " + mesh_.string() + " --vertices 150" + more);
  ASSERT_EQ(sized.status, 0) << sized.text;
  expect_text(sized, report_of("--vertices 150" + more)["fingerprint"].get<std::string>());
  const Outcome refused = geolloyd_with("verify " + mesh_.string() + " --seeds 8 --adapt 1");
  EXPECT_EQ(refused.status, 2);
  expect_text(refused, "--adapt is of a remesh: give --vertices, too");
}

}  // namespace
}  // namespace geolloyd

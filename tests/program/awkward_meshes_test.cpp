// Meshes that are hardly surfaces, each with what comes of it. Both engines must agree on every
// one.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

// Twelve by five cells of an open tube about z, radius 1 and height 5, scaled and then moved.
Mesh tube(double scale, double offset = 0) {
  Mesh mesh;
  for (int i = 0; i < 72; ++i) {
    const double angle = 2 * std::numbers::pi * (i % 12) / 12;
    const Vec3 p(std::cos(angle), std::sin(angle), i / 12);
    mesh.positions.push_back((p * scale).array() + offset);
  }
  for (VertexId i = 0; i < 60; ++i) {
    const VertexId next = i % 12 == 11 ? i - 11 : i + 1;
    mesh.triangles.push_back({i, next, i + 12});
    mesh.triangles.push_back({next, next + 12, i + 12});
  }
  return mesh;
}

// A band of n cells, two vertices across, closed after half a turn.
Mesh moebius_strip(VertexId n) {
  Mesh mesh;
  for (VertexId i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(angle / 2);
      mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                  side * std::sin(angle / 2));
    }
    const VertexId a = 2 * i;
    const bool is_last = i + 1 == n;
    mesh.triangles.push_back({a, is_last ? 1 : a + 2, a + 1});
    mesh.triangles.push_back({a + 1, is_last ? 1 : a + 2, is_last ? 0 : a + 3});
  }
  return mesh;
}

Mesh triangles_apart(VertexId n) {
  Mesh mesh;
  for (VertexId i = 0; i < n; ++i) {
    const double x = i % 64;
    const double y = i / 64;  // of the row
    mesh.positions.insert(mesh.positions.end(), {{x, y, 0}, {x + 0.5, y, 0}, {x, y + 0.5, 0}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

const std::vector<Vec3> square_points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Vec3> star_points = {{0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                       {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};

struct OddMesh {
  const char* name;
  Mesh mesh;
  int seeds;
  std::vector<const char*> told;  // by the summary

  friend void PrintTo(const OddMesh& row, std::ostream* out) { *out << row.name; }
};

// clang-format off
const std::vector<OddMesh> odd_meshes = {
    {"SingleTriangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 1, {"1 triangle\n", "3 boundary edges"}},
    {"SingleTriangleASeedEach", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 3, {"energy      0 -> 0"}},
    {"AllPointsEqual", {{4, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}}, 2, {"2 triangles without area", "5 edges without length"}},
    {"Collinear", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}}, 2, {"2 triangles without area"}},
    {"Needles", {{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-200, 0}, {0.5, -1e-200, 0}}, {{0, 1, 2}, {0, 3, 1}}}, 2, {"area 0,"}},
    {"DuplicateVertices", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 5, 4}}}, 2, {"1 component,", "2 vertices in the places of others: welded"}},
    {"DuplicateTriangles", {square_points, {{0, 1, 2}, {0, 1, 2}, {2, 0, 1}, {2, 1, 0}, {0, 2, 3}}}, 2, {"3 duplicate triangles", "area 1,", "NOT OF THE INPUT'S TOPOLOGY", "the input is no manifold"}},
    {"TrianglesNamingAVertexTwice", {square_points, {{0, 0, 1}, {0, 1, 2}, {1, 1, 1}}}, 2, {"2 triangles naming a vertex twice", "1 vertices of no triangle"}},
    {"FlippedOrientation", {square_points, {{0, 1, 2}, {0, 3, 2}}}, 2, {"1 edges between opposite orientations"}},
    {"NonManifoldEdge", {star_points, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}}, 2, {"1 non-manifold edges", "NOT OF THE INPUT'S TOPOLOGY", "the input is no manifold"}},
    {"NonManifoldVertex", {star_points, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}, {0, 4, 5}}}, 2, {"1 vertex where surfaces touch", "NO MANIFOLD"}},
    {"BowTie", {star_points, {{0, 2, 3}, {0, 4, 5}}}, 1, {"1 component,", "1 vertex where surfaces touch"}},
    {"MoebiusStrip", moebius_strip(20), 2, {"1 edges between opposite orientations", "Euler characteristic 0, 1 boundary loop, manifold"}},
    {"MoebiusStripOfThreeCells", moebius_strip(3), 2, {"Euler characteristic 0"}},
    {"ThousandsOfComponents", triangles_apart(3000), 3003, {"3,000 components", "3,003 from auto (farthest)"}},
    {"Huge", tube(1e30), 4, {"diagonal 5.74456e+30", "manifold"}},
    {"Tiny", tube(1e-30), 4, {"diagonal 5.74456e-30", "manifold"}},
    {"LargestCoordinates", tube(2e74), 4, {"diagonal 1.14891e+75", "manifold"}},
    {"SmallestExtent", tube(1e-75), 4, {"diagonal 5.74456e-75", "manifold"}},
    {"FarFromTheOrigin", tube(1, 1e15), 4, {"diagonal 5.74456", "manifold"}},
    {"SwallowedByItsDistance", tube(1, 1e17), 4, {"120 triangles without area"}},
    {"ManyScales", {{{0, 0, 0}, {1e30, 0, 0}, {0, 1e30, 0}, {1e-30, 1e-30, 0}, {0, 0, 1e-30}}, {{0, 1, 2}, {0, 3, 4}, {0, 1, 3}}}, 2, {"area 5e+59"}},
};
// clang-format on

class OddMeshes : public testing::TestWithParam<OddMesh> {
 protected:
  void SetUp() override { write(folder_.path() / "odd.off", GetParam().mesh); }

  // On that mesh, with that many seeds.
  [[nodiscard]] Outcome run(const std::string& command, const std::string& options) const {
    return geolloyd_with(command + " " + path("odd.off") + " -k " +
                         std::to_string(GetParam().seeds) + " " + options);
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  TemporaryFolder folder_;
};

TEST_P(OddMeshes, BecomeWhatTheTableSays) {
  const Outcome outcome =
      run("relax", "--ground-truth --size 99 --picture " + path("p.png") + " -o " + path("out"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  for (const char* told : GetParam().told) {
    EXPECT_NE(outcome.text.find(told), std::string::npos) << told << "\n" << outcome.text;
  }
  for (const char* never : {"nan", "inf,", "inf\n"}) {
    EXPECT_EQ(outcome.text.find(never), std::string::npos) << outcome.text;
  }
  const auto report = nlohmann::json::parse(read_file(path("out/report.json")));
  EXPECT_EQ(report["end"], "converged");
  const auto seeds = lines_of(path("out/seeds.csv"));
  EXPECT_EQ(seeds.size(), static_cast<std::size_t>(GetParam().seeds) + 1);
  EXPECT_EQ(read(path("out/tessellation.ply")).mesh.positions, GetParam().mesh.positions);
  EXPECT_FALSE(read(path("out/dual.ply")).mesh.triangles.empty());

  const Outcome verified = run("verify", "");
  EXPECT_EQ(verified.status, 0) << verified.text;
  const auto fingerprint = report["fingerprint"].get<std::string>();
  EXPECT_NE(verified.text.find(fingerprint), std::string::npos) << verified.text;
}

TEST_P(OddMeshes, AreTheSameToBothEnginesInTheRichestGraph) {
  const Outcome outcome = run("verify", "-g mixed --init random --norm linf");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
}

INSTANTIATE_TEST_SUITE_P(All, OddMeshes, testing::ValuesIn(odd_meshes),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace geolloyd

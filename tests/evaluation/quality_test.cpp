#include "tools/run/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/formats/mesh_io.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "geolloyd/threads.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

// Rows of triangles that are nearly equilateral: as sites, their vertices tile the plane with
// hexagons, but for those at the border.
// However many vertices the original has: the sites alone, two for each site, four, a hundred.
TEST(Quality, OfATriangularGridHasNearlyTheEnergyOfHexagons) {
  const Mesh rhombus{{{0, 0, 0}, {1, 0, 0}, {1.5, std::sqrt(0.75), 0}, {0.5, std::sqrt(0.75), 0}},
                     {{0, 1, 3}, {1, 2, 3}}};
  TemporaryFolder folder;
  const fs::path coarse = folder.path() / "coarse.ply";
  write(coarse, refine(rhombus, 40));
  Threads runtime(2);
  ProgressLine progress{Console()};
  for (const std::uint32_t frequency : {40U, 57U, 80U, 400U}) {
    SCOPED_TRACE(frequency);
    const fs::path original = folder.path() / "original.ply";
    write(original, refine(rhombus, frequency));
    const QualityRecord record = judge({coarse, original, {}, 1'000}, runtime, progress);
    ASSERT_TRUE(record.likeness);
    EXPECT_NEAR(record.likeness->energy / record.likeness->hexagonal, 1, 0.06);
    EXPECT_NEAR(record.likeness->distance.two_sided().largest, 0, 1e-12);
    EXPECT_NEAR(record.quality.mean_quality, 1, 1e-9);
    EXPECT_EQ(record.quality.share_valence_6, 1);
  }
}

nlohmann::json json_in(const fs::path& path) {
  return nlohmann::json::parse(read_file(path));
}

using QualityProgram = Program;

TEST_F(QualityProgram, WritesItsFiguresAsJson) {
  const fs::path coarse = folder_.path() / "coarse.obj";
  ASSERT_EQ(geolloyd_with("generate torus -t 500 -o " + coarse.string()).status, 0);
  const fs::path judged = folder_.path() / "quality.json";
  const std::string options =
      "quality " + coarse.string() + " --original " + mesh_.string() + " --samples 2000";
  const Outcome outcome = geolloyd_with(options + " -o " + judged.string());
  EXPECT_EQ(outcome.status, 0);
  for (const char* word : {"angle", "quality Q", "valence", "Hausdorff", "hexagonal"}) {
    EXPECT_NE(outcome.text.find(word), std::string::npos) << outcome.text;
  }
  const nlohmann::json report = json_in(judged);
  EXPECT_EQ(report["remesh"]["triangles"], 500);
  EXPECT_EQ(report["remesh"]["euler_characteristic"], 0);
  EXPECT_EQ(report["original"]["triangles"], 2000);
  EXPECT_GT(report["quality"]["smallest_angle"], 5);
  EXPECT_GT(report["quality"]["mean_quality"], 0.6);
  const nlohmann::json& likeness = report["likeness"];
  EXPECT_EQ(likeness["samples"], 2000);
  EXPECT_EQ(report["topology"], report["original_topology"]);
  EXPECT_GT(likeness["energy_ratio_hexagonal"], 0.9);
  const nlohmann::json& distance = likeness["two_sided"];
  EXPECT_GT(distance["mean"], 0);
  EXPECT_GE(distance["rms"], distance["mean"]);
  EXPECT_GE(distance["hausdorff"], distance["rms"]);
  const double diagonal = report["original"]["bounding_diagonal"];
  EXPECT_DOUBLE_EQ(distance["mean_percent"], 100 * distance["mean"].get<double>() / diagonal);

  const std::string first = read_file(judged);
  EXPECT_EQ(geolloyd_with(options + " --threads 3 --backend openmp -o " + judged.string()).status,
            0);
  EXPECT_EQ(read_file(judged), first);
}

TEST_F(QualityProgram, CertifiesTheDistance) {
  const fs::path coarse = folder_.path() / "coarse.obj";
  ASSERT_EQ(geolloyd_with("generate torus -t 500 -o " + coarse.string()).status, 0);
  const fs::path judged = folder_.path() / "quality.json";
  const std::string options = "quality " + coarse.string() + " --original " + mesh_.string() +
                              " --samples 2000 --certify -o " + judged.string();
  const Outcome outcome = geolloyd_with(options);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.text.find("certified"), std::string::npos) << outcome.text;
  const nlohmann::json likeness = json_in(judged)["likeness"];
  for (const char* way : {"remesh_to_original", "original_to_remesh", "two_sided"}) {
    const double lower = likeness[way]["hausdorff_lower"];
    const double upper = likeness[way]["hausdorff_upper"];
    EXPECT_LE(upper, 1.01 * lower);
    EXPECT_LE(likeness[way]["hausdorff"], upper);
  }
  const std::string first = read_file(judged);
  EXPECT_EQ(geolloyd_with(options + " --threads 3 --backend openmp").status, 0);
  EXPECT_EQ(read_file(judged), first);
}

TEST_F(QualityProgram, JudgesAnyMesh) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\n";
  const fs::path judged = folder_.path() / "quality.json";
  const auto report_on = [&](const std::string& faces) {
    const fs::path mesh = folder_.write("odd.obj", corners + faces);
    const Outcome outcome = geolloyd_with("quality " + mesh.string() + " -o " + judged.string());
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return json_in(judged);
  };
  const nlohmann::json degenerate = report_on("f 1 2 3\nf 1 1 2\n");
  EXPECT_EQ(degenerate["quality"]["smallest_angle"], 0);
  EXPECT_EQ(degenerate["quality"]["mean_quality"], 0);
  EXPECT_EQ(degenerate["quality"]["share_under_30"], 1);
  EXPECT_TRUE(degenerate["quality"]["share_valence_6"].is_null());
  const nlohmann::json fan = report_on("f 1 2 4\nf 1 2 5\nf 2 1 3\n");
  EXPECT_EQ(fan["remesh"]["non_manifold_edges"], 1);
  EXPECT_EQ(fan["quality"]["smallest_angle"], 0);
}

TEST_F(QualityProgram, AnswersWhatItCannotMeasureWithOneLine) {
  const std::string torus = mesh_.string();
  const auto write = [&](const std::string& name, const std::string& faces) {
    return folder_.write(name, "v 0 0 0\nv 1 0 0\nv 2 0 0\n" + faces).string();
  };
  const std::string line = write("line.obj", "f 1 2 3\n");
  expect_complaint(geolloyd_with("quality " + line + " --original " + torus), "line.obj: no tri");
  expect_complaint(geolloyd_with("quality " + torus + " --original " + line), "line.obj: no tri");
  expect_complaint(geolloyd_with("quality " + write("none.obj", "")), "none.obj");
  expect_complaint(geolloyd_with("quality " + torus + " --original missing.ply"), "missing.ply");
  expect_complaint(geolloyd_with("quality " + torus + " --samples 0"), "--samples");
  expect_complaint(geolloyd_with("quality " + torus + " --certify"), "--original");
  expect_complaint(geolloyd_with("quality " + torus + " -o " + torus), torus);
  expect_complaint(geolloyd_with("quality " + torus + " -o no/such/folder.json"), "no/such");
}

}  // namespace
}  // namespace geolloyd

// The table golden_remeshes.txt: the surface remeshes that must come out everywhere, as the
// tessellations of golden_fingerprints.txt must.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/fields/curvature_field.h"
#include "core/mesh/mesh_edges.h"
#include "core/surface/result/remesh.h"
#include "core/text/file_io.h"
#include "geolloyd/threads.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/sanitizers.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

// In the words of the command line: geolloyd generate SHAPE --triangles N, then
// geolloyd remesh --vertices V, with --vfield FIELD where that is not none.
struct GoldenRemesh {
  std::string shape;
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::string field;
  std::string fingerprint;
};

std::ostream& operator<<(std::ostream& out, const GoldenRemesh& row) {
  return out << row.shape << ' ' << row.triangles << ' ' << row.vertices << ' ' << row.field << ' '
             << row.fingerprint;
}

// Comments and empty lines, or rows.
std::vector<std::string> lines_of_remeshes() {
  std::istringstream text(read_file(GEOLLOYD_GOLDEN_REMESHES));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

bool is_row(const std::string& line) {
  return !line.empty() && line[0] != '#';
}

GoldenRemesh row_of(const std::string& line) {
  GoldenRemesh row;
  std::istringstream words(line);
  words >> row.shape >> row.triangles >> row.vertices >> row.field >> row.fingerprint;
  return row;
}

std::vector<GoldenRemesh> read_remeshes() {
  std::vector<GoldenRemesh> rows;
  for (const std::string& line : lines_of_remeshes()) {
    if (is_row(line)) rows.push_back(row_of(line));
  }
  return rows;
}

// The row with the fingerprint that came out.
std::string outcome_of(GoldenRemesh row, const Mesh& mesh, const MeshEdges& edges,
                       Runtime& runtime) {
  RemeshOptions options;
  options.vertex_count = row.vertices;
  if (row.field == "curvature") options.field = curvature_field(mesh, edges, runtime.executor());
  std::ostringstream digits;
  digits << std::hex << make_remesh(mesh, edges, options, runtime).fingerprint;
  row.fingerprint = std::string(16 - digits.str().size(), '0') + digits.str();
  return testing::PrintToString(row);
}

std::string outcome_in_parallel(const GoldenRemesh& row, const Mesh& mesh, const MeshEdges& edges,
                                Scheduler& scheduler) {
  Threads runtime(scheduler);
  return outcome_of(row, mesh, edges, runtime);
}

Mesh make_shape(const GoldenRemesh& row) {
  return value_of(shape_names, row.shape)(row.triangles, 1);
}

// Where the compiler optimises nothing, a remesh takes a hundred times as long.
#ifdef __OPTIMIZE__
constexpr bool is_optimised = true;
#else
constexpr bool is_optimised = false;
#endif

constexpr std::size_t few_triangles = 4'000;

class GoldenRemeshFingerprint : public testing::TestWithParam<GoldenRemesh> {
 protected:
  void SetUp() override {
    constexpr std::size_t quick = 100'000;
    if (GetParam().triangles > quick && std::getenv("GEOLLOYD_LONG_TESTS") == nullptr) {
      GTEST_SKIP() << "over 100,000 triangles: set GEOLLOYD_LONG_TESTS";
    }
    if (GetParam().triangles > few_triangles && (!is_optimised || under_sanitizer)) {
      GTEST_SKIP() << "over 4,000 triangles, and built without optimisation or with a sanitizer";
    }
  }
};

TEST_P(GoldenRemeshFingerprint, OfTheReference) {
  const Mesh mesh = make_shape(GetParam());
  EXPECT_EQ(outcome_of(GetParam(), mesh, find_edges(mesh), reference_runtime()),
            testing::PrintToString(GetParam()));
}

// Small meshes by each number of threads of each backend, larger ones by each number of threads.
std::vector<std::pair<std::size_t, Backend>> ways_of(const GoldenRemesh& row) {
  using enum Backend;
  if (!is_optimised) return {{3, openmp}};
  if (under_sanitizer) return {{3, tbb}, {3, openmp}};
  if (row.triangles > few_triangles) return {{1, tbb}, {2, openmp}, {3, tbb}, {8, openmp}};
  return {{1, tbb}, {1, openmp}, {2, tbb}, {2, openmp},
          {3, tbb}, {3, openmp}, {8, tbb}, {8, openmp}};
}

TEST_P(GoldenRemeshFingerprint, OfAnyThreadsAndBackend) {
  const Mesh mesh = make_shape(GetParam());
  const MeshEdges edges = find_edges(mesh);
  for (const auto& [threads, backend] : ways_of(GetParam())) {
    Scheduler scheduler(threads, backend);
    EXPECT_EQ(outcome_in_parallel(GetParam(), mesh, edges, scheduler),
              testing::PrintToString(GetParam()))
        << threads << " threads, " << name_of(backend_names, backend);
  }
}

TEST(GoldenRemeshes, HaveARowForEachShape) {
  std::set<std::string> shapes;
  for (const GoldenRemesh& row : read_remeshes()) shapes.insert(row.shape);
  EXPECT_EQ(shapes.size(), shape_names.size());
}

// Not a test: writes the table again, with what comes out here.
TEST(GoldenRemeshes, DISABLED_AreRecorded) {
  Scheduler scheduler;
  std::string text;
  for (const std::string& line : lines_of_remeshes()) {
    if (!is_row(line)) {
      text += line + '\n';
      continue;
    }
    const GoldenRemesh row = row_of(line);
    const Mesh mesh = make_shape(row);
    text += outcome_in_parallel(row, mesh, find_edges(mesh), scheduler) + '\n';
  }
  std::ofstream(GEOLLOYD_GOLDEN_REMESHES) << text;
}

INSTANTIATE_TEST_SUITE_P(Table, GoldenRemeshFingerprint, testing::ValuesIn(read_remeshes()));

}  // namespace
}  // namespace geolloyd

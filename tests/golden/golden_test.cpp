// The table golden_fingerprints.txt: what must come out everywhere, on any machine, by any compiler
// at any level of optimisation, from either engine on any number of threads. A change of the
// canonical definition, or of a generated mesh, changes it, and nothing else may.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/reference_engine.h"
#include "core/text/file_io.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

// In the words of the command line: geolloyd generate SHAPE --triangles N, then
// geolloyd relax --graph G --norm N --init I --seeds K --greedy M.
struct Golden {
  std::string shape;
  std::size_t triangles = 0;
  std::string graph, norm, init;
  std::size_t seeds = 0;
  std::string greedy;
  std::string fingerprint;
};

std::ostream& operator<<(std::ostream& out, const Golden& row) {
  return out << row.shape << ' ' << row.triangles << ' ' << row.graph << ' ' << row.norm << ' '
             << row.init << ' ' << row.seeds << ' ' << row.greedy << ' ' << row.fingerprint;
}

std::vector<Golden> read_table() {
  std::istringstream text(read_file(GEOLLOYD_GOLDEN_TABLE));
  std::vector<Golden> rows;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#') continue;
    Golden row;
    std::istringstream words(line);
    words >> row.shape >> row.triangles >> row.graph >> row.norm >> row.init >> row.seeds >>
        row.greedy >> row.fingerprint;
    rows.push_back(row);
  }
  return rows;
}

Mesh make_shape(const Golden& row) {
  return value_of(shape_names, row.shape)(row.triangles, 1);
}

MeshGraphOptions graph_options(const Golden& row) {
  MeshGraphOptions options;
  options.kind = value_of(graph_kind_names, row.graph);
  options.norm = value_of(norm_names, row.norm);
  return options;
}

std::vector<NodeId> first_seeds(const Golden& row, const Graph& graph) {
  return choose_seeds(graph, connected_components(graph), value_of(seed_init_names, row.init),
                      row.seeds, 1);
}

// The row with the fingerprint that came out.
std::string outcome(Golden row, const Graph& graph, Engine& engine) {
  RelaxationOptions options;
  options.greedy = value_of(greedy_mode_names, row.greedy);
  std::ostringstream digits;
  digits << std::hex << relax(graph, engine, first_seeds(row, graph), options).fingerprint;
  row.fingerprint = std::string(16 - digits.str().size(), '0') + digits.str();
  return testing::PrintToString(row);
}

class GoldenFingerprint : public testing::TestWithParam<Golden> {
 protected:
  void SetUp() override {
    constexpr std::size_t quick = 100'000;
    if (GetParam().triangles > quick && std::getenv("GEOLLOYD_LONG_TESTS") == nullptr) {
      GTEST_SKIP() << "over 100,000 triangles: set GEOLLOYD_LONG_TESTS";
    }
  }
};

TEST_P(GoldenFingerprint, OfTheReference) {
  const Mesh mesh = make_shape(GetParam());
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), graph_options(GetParam()));
  EXPECT_EQ(outcome(GetParam(), made.graph, *make_reference_engine(made.graph)),
            testing::PrintToString(GetParam()));
}

TEST_P(GoldenFingerprint, OfAnyThreadsBackendAndFrontier) {
  const Mesh mesh = make_shape(GetParam());
  const MeshEdges edges = find_edges(mesh);
  for (const Backend backend : {Backend::tbb, Backend::openmp}) {
    for (const std::size_t threads : {1U, 2U, 7U}) {
      Scheduler scheduler(threads, backend);
      const MeshGraph made = make_mesh_graph(mesh, edges, graph_options(GetParam()), scheduler);
      for (const Frontier frontier : {Frontier::delta, Frontier::regions}) {
        const auto engine = make_parallel_engine(scheduler, made.graph, frontier);
        EXPECT_EQ(outcome(GetParam(), made.graph, *engine), testing::PrintToString(GetParam()))
            << threads << " threads, " << name_of(backend_names, backend) << ", "
            << name_of(frontier_names, frontier);
      }
    }
  }
}

TEST(GoldenTable, HasARowForEachShapeAndGraph) {
  std::set<std::string> shapes;
  std::set<std::string> graphs;
  for (const Golden& row : read_table()) {
    shapes.insert(row.shape);
    graphs.insert(row.graph);
  }
  EXPECT_EQ(shapes.size(), shape_names.size());
  EXPECT_EQ(graphs.size(), graph_kind_names.size());
}

INSTANTIATE_TEST_SUITE_P(Table, GoldenFingerprint, testing::ValuesIn(read_table()));

}  // namespace
}  // namespace geolloyd

// How far distances on each kind of graph are from those on the surface, and what a graph costs:
// graph_error [TRIANGLES] prints a table in Markdown.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/support/graph_error.h"
#include "core/base/stopwatch.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/subdivide.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "parallel/engine/parallel_engine.h"

namespace geolloyd {
namespace {

constexpr std::size_t usual_triangles = 200'000;
constexpr std::uint64_t source_seed = 1;
constexpr std::size_t source_count = 16;
constexpr double nearest_edges = 10;  // pairs that are nearer, in mean edges, do not count
constexpr std::size_t vertices_per_region = 100;
constexpr std::size_t turns = 5;

struct Surface {
  const char* name;
  Mesh mesh;
  ExactDistance exact;
};

double on_plane(const Vec3& a, const Vec3& b) {
  return norm(a - b);
}

double on_sphere(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

Mesh grid(std::size_t triangles) {
  const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  return refine(square, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 2)));
}

// Squares cut along one diagonal, an irregular plane, a refined icosahedron.
std::vector<Surface> surfaces(std::size_t triangles) {
  return {{"grid", grid(triangles), on_plane},
          {"plane", irregular_plane(triangles, source_seed), on_plane},
          {"sphere", icosphere(triangles), on_sphere}};
}

constexpr std::array<std::pair<const char*, GraphKind>, 6> kinds = {{
    {"vertex", GraphKind::vertex},
    {"vertex-dense", GraphKind::vertex_dense},
    {"triangle", GraphKind::triangle},
    {"triangle-dense", GraphKind::triangle_dense},
    {"mixed", GraphKind::mixed},
    {"vertex-far", GraphKind::vertex_far},
}};

double mean_length(const Mesh& mesh, const MeshEdges& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges.ends) sum += norm(mesh.positions[a] - mesh.positions[b]);
  return sum / static_cast<double>(edges.size());
}

// As many for each graph, evenly over its nodes, which are in spatial order.
std::vector<NodeId> spread_seeds(const Graph& graph, std::size_t count) {
  std::vector<NodeId> seeds;
  for (std::size_t i = 0; i < count; ++i) {
    seeds.push_back(static_cast<NodeId>(i * graph.node_count() / count));
  }
  return seeds;
}

// What one kind of graph costs, turn by turn, and the graph.
struct Row {
  const char* name;
  GraphKind kind;
  MeshGraph made;
  std::vector<double> graph_seconds;
  std::vector<double> partition_seconds;
};

void take_turn(Row& row, Scheduler& scheduler, const Mesh& mesh, const MeshEdges& edges) {
  const Stopwatch watch;
  row.made = make_mesh_graph(mesh, edges, {row.kind, Norm::geodesic, {}}, scheduler);
  row.graph_seconds.push_back(watch.seconds());
  const Graph& graph = row.made.graph;
  const std::vector<NodeId> seeds =
      spread_seeds(graph, mesh.vertex_count() / vertices_per_region + 1);
  const Stopwatch partitioning;
  make_parallel_engine(scheduler, graph)->partition(seeds);
  row.partition_seconds.push_back(partitioning.seconds());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_row(const char* surface, const Row& row, const Row& vertex, const GraphError& error) {
  const Graph& graph = row.made.graph;
  std::printf("| %s | %s | %.2f | %.2f | %.2f | %.1f | %.1f | %.1f |\n", surface, row.name,
              100 * error.mean, 100 * std::sqrt(error.rms * error.rms - error.mean * error.mean),
              100 * error.largest,
              static_cast<double>(graph.arc_count()) / static_cast<double>(graph.node_count()),
              median(row.graph_seconds) / median(vertex.graph_seconds),
              median(row.partition_seconds) / median(vertex.partition_seconds));
  std::fflush(stdout);
}

// The kinds take turns, so that what slows the machine slows all of them.
void print_rows(const Surface& surface) {
  Scheduler scheduler;
  const MeshEdges edges = find_edges(surface.mesh, scheduler);
  std::vector<Row> rows;
  rows.reserve(kinds.size());
  for (const auto& [name, kind] : kinds) rows.push_back({name, kind, {}, {}, {}});
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (Row& row : rows) take_turn(row, scheduler, surface.mesh, edges);
  }
  const double nearest = nearest_edges * mean_length(surface.mesh, edges);
  for (const Row& row : rows) {
    print_row(surface.name, row, rows.front(),
              measure_graph_error(row.made, source_count, source_seed, nearest, surface.exact));
  }
}

std::size_t parse_count(std::string_view text) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw InvalidInput(std::string(text) + ": not a number of triangles");
  }
  return count;
}

void print_table(std::size_t triangles) {
  std::puts(
      "| surface | graph | mean error, % | standard deviation, % | largest, % | arcs per node | "
      "building, of vertex | partition, of vertex |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |");
  for (const Surface& surface : surfaces(triangles)) print_rows(surface);
}

}  // namespace
}  // namespace geolloyd

int main(int argc, char** argv) {
  try {
    geolloyd::print_table(argc > 1 ? geolloyd::parse_count(argv[1]) : geolloyd::usual_triangles);
  } catch (const geolloyd::Error& error) {
    std::fprintf(stderr, "graph_error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graph_error: %s\n", error.what());
    return 1;
  }
  return 0;
}

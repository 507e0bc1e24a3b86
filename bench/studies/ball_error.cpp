// How far the balls of each norm on each kind of graph are from squares, diamonds and discs:
// ball_error [TRIANGLES] prints a table in Markdown.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/vec3.h"
#include "core/graph/arc_length.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "core/voronoi/ball_error.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

constexpr std::size_t usual_triangles = 20'000;
constexpr std::uint64_t random_seed = 1;
constexpr double radius = 0.3;
constexpr double pi = 3.14159265358979323846;
constexpr int turns = 4;  // of the axes, from 0 to 45 degrees

constexpr std::array<std::pair<const char*, GraphKind>, 6> kinds = {{
    {"vertex", GraphKind::vertex},
    {"vertex-dense", GraphKind::vertex_dense},
    {"triangle", GraphKind::triangle},
    {"triangle-dense", GraphKind::triangle_dense},
    {"mixed", GraphKind::mixed},
    {"vertex-far", GraphKind::vertex_far},
}};
constexpr std::array<std::pair<const char*, Norm>, 3> norms = {{
    {"linf: square", Norm::linf},
    {"manhattan: diamond", Norm::manhattan},
    {"geodesic: disc", Norm::geodesic},
}};

NodeId nearest_node(const MeshGraph& made, const Vec3& place) {
  NodeId nearest = 0;
  for (NodeId v = 0; v < made.position.size(); ++v) {
    if (norm(made.position[v] - place) < norm(made.position[nearest] - place)) nearest = v;
  }
  return nearest;
}

TangentSpace axes_at(double angle) {
  return {{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, 1, 1};
}

void print_row(const Mesh& mesh, const MeshEdges& edges, const char* ball, Norm norm_kind,
               const char* graph, GraphKind kind, Scheduler& scheduler) {
  double area = 0;
  double difference = 0;
  double most = 0;
  for (int turn = 0; turn < turns; ++turn) {
    const TangentSpace axes = axes_at(turn * pi / 4 / (turns - 1));
    const MeshGraph made = make_mesh_graph(
        mesh, edges, {kind, norm_kind, std::vector<TangentSpace>(mesh.vertex_count(), axes)},
        scheduler);
    const BallError error = measure_ball_error(
        mesh, made, nearest_node(made, {0.5, 0.5, 0}), radius,
        [&](const Vec3& a, const Vec3& b) { return measure(Vec3(b - a), axes, norm_kind); });
    area += 100 * error.area / turns;
    difference += 100 * error.symmetric_difference / turns;
    most = std::max(most, 100 * error.symmetric_difference);
  }
  std::printf("| %s | %s | %.2f | %.2f | %.2f |\n", ball, graph, area, difference, most);
  std::fflush(stdout);
}

void print_table(std::size_t triangles) {
  Scheduler scheduler;
  const Mesh mesh = irregular_plane(triangles, random_seed);
  const MeshEdges edges = find_edges(mesh, scheduler);
  std::puts(
      "| ball | graph | area error, % | symmetric difference, % | largest of all turns, % |\n"
      "| --- | --- | --- | --- | --- |");
  for (const auto& [ball, norm_kind] : norms) {
    for (const auto& [graph, kind] : kinds) {
      print_row(mesh, edges, ball, norm_kind, graph, kind, scheduler);
    }
  }
}

}  // namespace
}  // namespace geolloyd

int main(int argc, char** argv) try {
  std::size_t triangles = geolloyd::usual_triangles;
  if (argc > 1) {
    const std::string_view text = argv[1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), triangles);
    if (argc > 2 || error != std::errc() || end != text.data() + text.size() || triangles < 100) {
      std::fprintf(stderr, "usage: ball_error [TRIANGLES], at least 100\n");
      return 2;
    }
  }
  geolloyd::print_table(triangles);
} catch (const std::exception& error) {
  std::fprintf(stderr, "ball_error: %s\n", error.what());
  return 1;
}

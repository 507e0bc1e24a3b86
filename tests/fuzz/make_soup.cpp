#include <algorithm>
#include <utility>

#include "core/base/bounding_box.h"
#include "core/mesh/subdivide.h"
#include "tests/fuzz/choices.h"
#include "tests/fuzz/soup.h"

namespace geolloyd::fuzz {
namespace {

constexpr std::size_t most_vertices = 24;
constexpr std::size_t most_triangles = 40;

constexpr std::size_t team_sizes[] = {1, 1, 2, 3};
constexpr double scales[] = {1, 1, 1, 1.0 / 3, 1e-12, 1e12, 1e-74, 1e74};
constexpr double odd_coordinates[] = {1e-3, -1e-9, 1e-30, 1e-74, 1.0 / 3, -0.0, 1e6, -1e9};
constexpr double magnitudes[] = {1, 2, 0.5, 0, 1e-6, 1e6, 1e75, 1e-75};

// Mostly 0 to 7.
double make_coordinate(Choices& choices) {
  const std::uint8_t byte = choices.next();
  return byte < 240 ? byte % 8 : odd_coordinates[byte % 8];
}

Vec3 make_position(Choices& choices, double scale) {
  Vec3 position;
  for (double& coordinate : position) {
    coordinate =
        std::clamp(scale * make_coordinate(choices), -largest_coordinate, largest_coordinate);
  }
  return position;
}

// A file could not hold a smaller mesh (mesh_io.cpp).
bool is_too_small(const Mesh& mesh) {
  const double widest = bounding_box(mesh.positions).extent().maxCoeff();
  return widest > 0 && widest < 1 / largest_coordinate;
}

Mesh make_mesh(Choices& choices, std::size_t vertices, double scale) {
  Mesh mesh;
  for (std::size_t v = 0; v < vertices; ++v)
    mesh.positions.push_back(make_position(choices, scale));
  while (!choices.at_end() && mesh.triangle_count() < most_triangles) {
    Triangle t{};
    for (VertexId& corner : t) corner = static_cast<VertexId>(choices.below(vertices));
    mesh.triangles.push_back(t);
  }
  return mesh;
}

Vec3 make_direction(Choices& choices) {
  const Vec3 direction(static_cast<double>(choices.below(5)) - 2,
                       static_cast<double>(choices.below(3)) - 1,
                       static_cast<double>(choices.below(3)) - 1);
  return normalized(direction);
}

// A few spaces, in turn.
std::vector<TangentSpace> make_field(Choices& choices, std::size_t vertex_count) {
  std::vector<TangentSpace> few;
  for (int i = 0; i < 3; ++i) {
    few.push_back({make_direction(choices), make_direction(choices), choices.of(magnitudes),
                   choices.of(magnitudes)});
  }
  std::vector<TangentSpace> field;
  for (std::size_t v = 0; v < vertex_count; ++v) field.push_back(few[v % few.size()]);
  return field;
}

}  // namespace

Soup make_soup(std::span<const std::uint8_t> bytes) {
  Choices choices(bytes);
  Soup soup;
  soup.graph.kind = static_cast<GraphKind>(choices.below(5));
  soup.graph.norm = static_cast<Norm>(choices.below(3));
  const std::uint8_t field = choices.next();
  soup.seeds = choices.next();
  soup.init = static_cast<SeedInit>(choices.below(4));
  soup.random_seed = choices.next();
  soup.relaxation.greedy = static_cast<GreedyMode>(choices.below(3));
  soup.relaxation.microstep_skip = choices.coin();
  soup.relaxation.macrostep_skip = choices.coin();
  const std::size_t limit = choices.below(8);
  if (limit > 4) soup.relaxation.max_macrosteps = static_cast<std::uint32_t>(limit - 5);
  const std::uint8_t team = choices.next();
  soup.threads = team_sizes[team % 4];
  soup.backend = team / 4 % 2 == 0 ? Backend::tbb : Backend::openmp;
  soup.frontier = static_cast<Frontier>(team / 8 % 4);
  soup.relaxation.improvement_rounds = team / 32 % 4;
  const double scale = choices.of(scales);
  const auto frequency = static_cast<std::uint32_t>(1 + choices.below(3));
  const std::size_t vertices = 3 + choices.below(most_vertices - 2);
  Mesh mesh = make_mesh(choices, vertices, scale);
  if (is_too_small(mesh)) return soup;
  soup.mesh = frequency == 1 ? std::move(mesh) : refine(mesh, frequency);
  if (field % 4 == 3) {
    // A field has no bytes of its own, so that the mesh has the same ones with it and without.
    Choices again(bytes.subspan(std::min<std::size_t>(bytes.size(), 2)));
    soup.graph.vertex_space = make_field(again, soup.mesh.vertex_count());
  }
  return soup;
}

}  // namespace geolloyd::fuzz

#include <cmath>
#include <vector>

#include "core/fields/tangent_field_file.h"
#include "core/graph/mesh_graph.h"
#include "tests/fuzz/target.h"

namespace geolloyd::fuzz {
namespace {

struct Ground {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  MeshEdges edges = find_edges(mesh);
};

bool is_direction(const Vec3& direction) {
  const double length = norm(direction);
  return length == 0 || std::abs(length - 1) < 1e-9;
}

void require_sound(const std::vector<TangentSpace>& spaces, std::size_t vertex_count) {
  require(spaces.size() == vertex_count, "each vertex has its space");
  for (const TangentSpace& s : spaces) {
    require(is_direction(s.tangent) && is_direction(s.bitangent), "directions have length 1 or 0");
    require(is_usable(s.tangent_magnitude) && s.tangent_magnitude >= 0 &&
                is_usable(s.bitangent_magnitude) && s.bitangent_magnitude >= 0,
            "magnitudes are usable and not negative");
  }
}

// Whatever the field, there is a graph with lengths that are numbers.
void require_graphs(const Ground& ground, const std::vector<TangentSpace>& spaces) {
  for (const GraphKind kind : {GraphKind::vertex_dense, GraphKind::mixed}) {
    const MeshGraph made =
        make_mesh_graph(ground.mesh, ground.edges, {kind, Norm::geodesic, spaces});
    require(std::isfinite(made.graph.tick_length) && made.graph.tick_length > 0,
            "a tick of length is a number");
    for (const std::uint32_t length : made.graph.length) {
      require(length >= 1 && length <= std::uint32_t{1} << 30, "lengths are in range");
    }
  }
}

}  // namespace
}  // namespace geolloyd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace geolloyd::fuzz;
  static const Ground ground;
  const std::size_t vertex_count = ground.mesh.vertex_count();
  const auto spaces = if_accepted(
      [&] { return geolloyd::parse_tangent_field(text_of(data, size), input_name, vertex_count); });
  if (!spaces) return 0;
  require_sound(*spaces, vertex_count);
  require_graphs(ground, *spaces);
  return 0;
}

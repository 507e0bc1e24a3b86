#include <array>
#include <set>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/seeds/seed_file.h"
#include "tests/fuzz/target.h"

namespace geolloyd::fuzz {
namespace {

// A unit square of two triangles, a vertex of no triangle (4), a triangle apart (5, 6, 7), one that
// names a vertex twice.
const Mesh mesh{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 2}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
    {{0, 1, 2}, {0, 2, 3}, {5, 6, 7}, {5, 5, 6}}};

struct Ground {
  explicit Ground(GraphKind kind)
      : mesh_graph(make_mesh_graph(mesh, find_edges(mesh), {kind, Norm::geodesic, {}})),
        components(connected_components(mesh_graph.graph)) {}

  MeshGraph mesh_graph;
  Components components;
};

void require_sound(const Ground& ground, const std::vector<NodeId>& seeds) {
  std::set<NodeId> different;
  std::set<std::uint32_t> reached;
  for (const NodeId s : seeds) {
    require(s < ground.mesh_graph.graph.node_count(), "seeds are nodes");
    different.insert(s);
    reached.insert(ground.components.component_of[s]);
  }
  require(different.size() == seeds.size(), "seeds are different");
  require(reached.size() == ground.components.size(), "each component has a seed");
}

}  // namespace
}  // namespace geolloyd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace geolloyd::fuzz;
  static const std::array grounds = {Ground(geolloyd::GraphKind::vertex),
                                     Ground(geolloyd::GraphKind::triangle),
                                     Ground(geolloyd::GraphKind::mixed)};
  for (const Ground& ground : grounds) {
    for (const auto by : {geolloyd::SeedsBy::id, geolloyd::SeedsBy::position}) {
      const auto seeds = if_accepted([&] {
        return geolloyd::parse_seeds(text_of(data, size), input_name, by, ground.mesh_graph,
                                     ground.components);
      });
      if (seeds) require_sound(ground, seeds->nodes);
    }
  }
  return 0;
}

#include "core/regions/graph_dual.h"

#include <algorithm>
#include <utility>

#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_quality.h"
#include "core/regions/dual_places.h"
#include "core/regions/dual_repair.h"
#include "core/regions/region_borders.h"
#include "core/repair/crossings.h"

namespace geolloyd {
namespace {

Roundness measure_roundness(const GraphDualInput& input, const MeshEdges& edges,
                            const RegionSurface& surface) {
  std::vector<double> perimeter;
  double area = 0;
  parallel_invoke(
      input.executor, [&] { perimeter = border_lengths(input.mesh, surface); },
      [&] {
        for (const double a : triangle_areas(input.mesh, edges.duplicates)) area += a;
      });
  const Graph& graph = input.mesh_graph.graph;
  const std::vector<Key>& key = input.partition.key;
  std::vector<double> mass(perimeter.size(), 0);
  double total_mass = 0;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    if (key[v] == unreached) continue;
    mass[region_of(key[v])] += graph.mass[v];
    total_mass += graph.mass[v];
  }
  Roundness roundness{0, perimeter.empty() ? 0.0 : 1.0};
  for (std::size_t r = 0; r < perimeter.size(); ++r) {
    const double ratio =
        total_mass > 0 ? isoperimetric_ratio(mass[r] * (area / total_mass), perimeter[r]) : 0;
    roundness.mean += ratio / static_cast<double>(perimeter.size());
    roundness.min = std::min(roundness.min, ratio);
  }
  return roundness;
}

ViolationsLeft why_left(const GraphDual& remesh, const GraphDualOptions& options) {
  if (!any_removable(remesh.violations_left)) return ViolationsLeft::none;
  if (!options.manifold) return ViolationsLeft::not_asked;
  if (remesh.interrupted) return ViolationsLeft::stopped;
  const std::size_t asked_for = remesh.seeds.size() - remesh.seeds_added;
  const bool is_bounded = remesh.input_topology.non_manifold_edges > 0 &&
                          remesh.seeds_added == most_seeds_added(asked_for);
  return is_bounded ? ViolationsLeft::bounded : ViolationsLeft::no_room;
}

std::vector<Vec3> find_sites(const GraphDualInput& input, const std::vector<NodeId>& seeds,
                             const GraphDualOptions& options) {
  if (!options.sites) return positions_of(input.mesh_graph, seeds);
  const bool is_unchanged = seeds == input.seeds;
  return options.sites(seeds, is_unchanged ? input.partition : partition_of(input.engine, seeds));
}

void fill_in(GraphDual& remesh, const GraphDualInput& input, DualisedSeeds dualised,
             const GraphDualOptions& options) {
  remesh.seeds = std::move(dualised.seeds);
  remesh.seeds_added = remesh.seeds.size() - input.seeds.size();
  remesh.reassigned_points = dualised.surface.reassigned_points.size();
  remesh.violations_left = dualised.dual.violations;
  remesh.repeated = dualised.dual.repeated;
  remesh.back_to_back = dualised.dual.back_to_back;
  remesh.why_left = why_left(remesh, options);
  remesh.mesh.positions = place_dual(input.mesh, dualised.surface, dualised.dual,
                                     find_sites(input, remesh.seeds, options));
  remesh.flipped =
      count_flipped(input.mesh, dualised.surface, dualised.dual, remesh.mesh.positions);
  remesh.mesh.triangles = std::move(dualised.dual.triangles);
  const MeshEdges edges = find_edges(remesh.mesh, input.executor);
  remesh.topology = find_topology(remesh.mesh, edges);
  remesh.flat = count_flat(remesh.mesh);
  remesh.folds = count_folds(remesh.mesh, edges);
  remesh.self_intersections = find_crossings(remesh.mesh, input.executor);
}

}  // namespace

bool GraphDual::is_manifold() const {
  return !mesh.triangles.empty() && topology.is_manifold();
}

bool GraphDual::has_input_topology() const {
  if (input_topology.is_manifold()) {
    return is_manifold() && topology.parts == input_topology.parts;
  }
  return violations_left.empty() && topology == input_topology;
}

GraphDual make_graph_dual(const GraphDualInput& input, const GraphDualOptions& options) {
  if (input.surface == nullptr) {
    InputSurface surface{{}, find_edges(input.mesh, input.executor)};
    surface.topology = find_topology(input.mesh, surface.edges, input.executor);
    return make_graph_dual({input.mesh, input.mesh_graph, input.seeds, input.partition,
                            input.engine, input.executor, &surface},
                           options);
  }
  const MeshEdges& edges = input.surface->edges;
  const DualInput dual_input{input.mesh, edges, input.mesh_graph, input.executor};
  DualisedSeeds dualised = dualise(dual_input, input.partition, input.seeds);
  GraphDual remesh;
  remesh.input_topology = input.surface->topology;
  remesh.roundness = measure_roundness(input, edges, dualised.surface);
  remesh.violations_found = dualised.dual.violations;
  if (options.manifold && !remesh.violations_found.empty()) {
    dualised = repair_dual(dual_input, input.engine, std::move(dualised), [&] {
      remesh.interrupted = remesh.interrupted || (options.keep_going && !options.keep_going());
      return !remesh.interrupted;
    });
  }
  fill_in(remesh, input, std::move(dualised), options);
  return remesh;
}

}  // namespace geolloyd

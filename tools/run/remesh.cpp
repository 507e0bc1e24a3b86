#include "tools/run/remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/remesh/dual_mesh.h"
#include "core/remesh/dual_places.h"
#include "core/remesh/dual_repair.h"
#include "core/remesh/region_borders.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/system/interrupt.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

Roundness measure_roundness(const RemeshInput& input, const MeshEdges& edges,
                            const RegionSurface& surface) {
  const std::vector<double> perimeter = border_lengths(input.mesh, surface);
  const Graph& graph = input.mesh_graph.graph;
  const std::vector<Key>& key = input.engine.current().key;
  std::vector<double> mass(perimeter.size(), 0);
  double total_mass = 0;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    if (key[v] == unreached) continue;
    mass[region_of(key[v])] += graph.mass[v];
    total_mass += graph.mass[v];
  }
  double area = 0;
  for (const double a : triangle_areas(input.mesh, edges.duplicates)) area += a;
  Roundness roundness{0, perimeter.empty() ? 0.0 : 1.0};
  for (std::size_t r = 0; r < perimeter.size(); ++r) {
    const double ratio =
        total_mass > 0 ? isoperimetric_ratio(mass[r] * (area / total_mass), perimeter[r]) : 0;
    roundness.mean += ratio / static_cast<double>(perimeter.size());
    roundness.min = std::min(roundness.min, ratio);
  }
  return roundness;
}

std::string describe(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::region:
      return "is no disc";
    case ViolationKind::contact:
      return "meet in several places";
    case ViolationKind::triple:
      return "meet at several corners";
    case ViolationKind::isolation:
      return "touches no corner of three";
  }
  return "";
}

std::string name(const ClosedBallViolation& violation) {
  std::string regions;
  std::size_t count = 0;
  for (const RegionId r : violation.regions) {
    if (r == no_id) continue;
    regions += (count++ == 0 ? " " : ", ") + std::to_string(r);
  }
  return (count == 1 ? "region" : "regions") + regions + " " + describe(violation.kind);
}

// Why the remesh is no manifold of the input's topology.
std::string find_flaw(const Remesh& remesh, bool manifold) {
  const MeshTopology& input = remesh.input_topology;
  if (!input.is_manifold()) {
    const bool is_alike = remesh.violations_left.empty() && remesh.topology == input;
    return "the input is none" + std::string(is_alike ? ", and the remesh is like it" : "") + ": " +
           describe(input);
  }
  if (!remesh.violations_left.empty()) {
    const std::string first = name(remesh.violations_left.front());
    if (!manifold) return first + ", and seeds were not to be added (--no-manifold)";
    if (interrupted()) return first + ", and the work was interrupted";
    return first + ", and no further seed there helps: use a finer mesh";
  }
  if (!remesh.topology.is_manifold() || remesh.topology.parts != input.parts) {
    return "its topology differs from the input's";
  }
  return "";
}

std::vector<Vec3> find_sites(const RemeshInput& input, const std::vector<NodeId>& seeds,
                             RemeshVertices vertices, Scheduler& scheduler) {
  if (vertices == RemeshVertices::centroids) {
    input.engine.partition(seeds);
    return make_ground_truth(scheduler, input.mesh, input.mesh_graph, input.engine.current(), seeds)
        .surface_centroid;
  }
  return positions_of(input.mesh_graph, seeds);
}

}  // namespace

Remesh make_remesh(const RemeshInput& input, const RemeshOptions& options, Scheduler& scheduler) {
  const MeshEdges edges = find_edges(input.mesh, scheduler);
  const auto dualise_current = [&](std::vector<NodeId> seeds) {
    DualisedSeeds dualised{std::move(seeds), {}, {}};
    dualised.surface = make_region_surface(input.mesh, edges, input.mesh_graph,
                                           input.engine.current(), dualised.seeds.size());
    dualised.dual = make_dual(dualised.surface, scheduler);
    return dualised;
  };
  DualisedSeeds dualised = dualise_current(input.seeds);
  Remesh remesh;
  parallel_invoke(
      scheduler, [&] { remesh.input_topology = find_topology(input.mesh, edges); },
      [&] { remesh.roundness = measure_roundness(input, edges, dualised.surface); });
  remesh.violations_found = dualised.dual.violations;
  if (options.manifold && !remesh.violations_found.empty()) {
    dualised = repair_dual(input.mesh_graph, input.engine, dualise_current, std::move(dualised),
                           [] { return !interrupted(); });
  }
  remesh.seeds = std::move(dualised.seeds);
  remesh.seeds_added = remesh.seeds.size() - input.seeds.size();
  remesh.reassigned_points = dualised.surface.reassigned_points.size();
  remesh.violations_left = dualised.dual.violations;
  remesh.repeated = dualised.dual.repeated;
  remesh.folded = dualised.dual.folded;

  remesh.mesh.positions = place_dual(input.mesh, dualised.surface, dualised.dual,
                                     find_sites(input, remesh.seeds, options.vertices, scheduler));
  remesh.flipped =
      count_flipped(input.mesh, dualised.surface, dualised.dual, remesh.mesh.positions);
  remesh.mesh.triangles = std::move(dualised.dual.triangles);
  remesh.topology = find_topology(remesh.mesh, find_edges(remesh.mesh, scheduler));
  remesh.flaw = find_flaw(remesh, options.manifold);
  return remesh;
}

}  // namespace geolloyd

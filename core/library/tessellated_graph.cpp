#include "core/library/tessellated_graph.h"

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/kernel_seconds.h"
#include "core/base/random.h"
#include "core/regions/tessellation.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

[[noreturn]] void refuse_seed(std::size_t index, InputId id, const std::string& what) {
  throw InvalidInput("first_seeds[" + std::to_string(index) + "] = " + std::to_string(id) + ": " +
                     what);
}

bool has_usable_values(const TangentSpace& space) {
  const auto all = [](const Vec3& v) {
    return is_usable(v.x()) && is_usable(v.y()) && is_usable(v.z());
  };
  return all(space.tangent) && all(space.bitangent) && is_usable(space.tangent_magnitude) &&
         is_usable(space.bitangent_magnitude) && space.tangent_magnitude >= 0 &&
         space.bitangent_magnitude >= 0;
}

// What has length 1 but for rounding keeps its bits, so the surface's own fields do.
Vec3 unit_direction(const Vec3& direction) {
  constexpr double rounding = 1e-14;
  const bool is_unit = std::abs(direction.squaredNorm() - 1) <= rounding;
  return is_unit ? direction : normalized(direction);
}

}  // namespace

std::vector<NodeId> nodes_of_seeds(const MeshGraph& mesh_graph, std::span<const InputId> seeds) {
  std::vector<NodeId> nodes;
  nodes.reserve(seeds.size());
  std::vector<bool> is_taken(mesh_graph.graph.node_count(), false);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (seeds[i] >= mesh_graph.node_of.size()) {
      refuse_seed(i, seeds[i],
                  "input ids go from 0 to " + std::to_string(mesh_graph.node_of.size() - 1));
    }
    const NodeId node = mesh_graph.node_of[seeds[i]];
    if (node == no_id) {
      refuse_seed(i, seeds[i],
                  "a vertex of no triangle, or a triangle naming a vertex twice, cannot be a seed");
    }
    if (is_taken[node]) refuse_seed(i, seeds[i], "is a seed already");
    is_taken[node] = true;
    nodes.push_back(node);
  }
  return nodes;
}

std::vector<TangentSpace> checked_field(std::span<const TangentSpace> field,
                                        std::size_t vertex_count) {
  if (field.empty()) return {};
  if (field.size() != vertex_count) {
    throw InvalidInput("field: " + std::to_string(field.size()) + " tangent spaces for " +
                       std::to_string(vertex_count) + " vertices: give one per vertex, or none");
  }
  std::vector<TangentSpace> checked(field.begin(), field.end());
  for (std::size_t v = 0; v < field.size(); ++v) {
    checked[v].tangent = unit_direction(field[v].tangent);
    checked[v].bitangent = unit_direction(field[v].bitangent);
    if (has_usable_values(field[v])) continue;
    throw InvalidInput("field[" + std::to_string(v) +
                       "]: directions must be finite, magnitudes finite and not negative");
  }
  return checked;
}

std::uint64_t digest(const Mesh& mesh) {
  std::uint64_t all = mix_bits(mesh.vertex_count());
  for (const Vec3& p : mesh.positions) {
    for (const double x : p) all = mix_bits(all ^ std::bit_cast<std::uint64_t>(x));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) all = mix_bits(all ^ v);
  }
  return all;
}

const TessellatedGraph& internals_of(const Tessellation& tessellation, const Mesh& mesh) {
  validate(mesh);
  if (!tessellation.internals) {
    throw InvalidInput("tessellation: empty: make one with relax()");
  }
  if (tessellation.internals->mesh_digest != digest(mesh)) {
    throw InvalidInput("tessellation: of another mesh");
  }
  return *tessellation.internals;
}

Tessellation describe(TessellatedGraph tessellated) {
  const auto internals = std::make_shared<const TessellatedGraph>(std::move(tessellated));
  const MeshGraph& made = internals->mesh_graph;
  const Relaxation& relaxation = internals->relaxation;
  Tessellation result;
  for (const RegionSummary& region : summarise_regions(made.graph, relaxation.partition,
                                                       relaxation.seeds, relaxation.region_score)) {
    result.regions.push_back(
        {made.input_id[region.seed], region.node_count, region.area, region.energy});
  }
  const std::size_t ids = made.node_of.size();
  result.region.assign(ids, no_id);
  result.distance.assign(ids, std::numeric_limits<double>::infinity());
  result.parent.assign(ids, no_id);
  for (NodeId v = 0; v < made.graph.node_count(); ++v) {
    const Key key = relaxation.partition.key[v];
    if (key == unreached) continue;
    const InputId id = made.input_id[v];
    result.region[id] = region_of(key);
    result.distance[id] = distance_of(key) * made.graph.tick_length;
    const NodeId parent = relaxation.partition.parent[v];
    if (parent != no_id) result.parent[id] = made.input_id[parent];
  }
  result.initial_energy =
      relaxation.steps.empty() ? relaxation.energy : relaxation.steps.front().energy;
  result.energy = relaxation.energy;
  result.stop_reason = relaxation.stop_reason;
  result.fingerprint = relaxation.fingerprint;
  result.trace.reserve(relaxation.steps.size());
  for (const Step& step : relaxation.steps) {
    result.trace.push_back(
        {step.phase, step.energy, step.seeds_moved, step.node_visits, total(step.seconds)});
  }
  result.internals = internals;
  return result;
}

}  // namespace geolloyd

#include "core/surface/surface_remesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/random.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_topology.h"
#include "core/surface/edge_flips.h"
#include "core/surface/outer_chains.h"
#include "core/surface/pinholes.h"
#include "core/surface/site_budget.h"
#include "core/surface/site_levels.h"
#include "core/surface/site_places.h"
#include "core/surface/site_relaxer.h"
#include "core/surface/surface_input.h"
#include "core/surface/surface_repair.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

std::vector<PartTopology> parts_of(const SurfaceInput& input, const OuterChains& outer) {
  std::vector<PartTopology> parts;
  for (const SurfacePart& part : find_surface_parts(input, outer)) {
    parts.push_back({part.euler_characteristic, 0});
  }
  for (const VertexId v : outer.loops) ++parts[input.part[v]].boundary_loops;
  for (const auto& loop : outer.pinholes) --parts[input.part[loop.front()]].euler_characteristic;
  std::sort(parts.begin(), parts.end());
  return parts;
}

class SurfaceRemesher {
 public:
  SurfaceRemesher(const Mesh& mesh, const SurfaceInput& input, const SurfaceRemeshOptions& options,
                  const MakeSurfaceEngine& make_engine, Executor& executor)
      : mesh_(mesh),
        input_(input),
        options_(options),
        relaxer_(make_engine, options, input.fine.whole_area, 1 / input.frame.scale, executor),
        executor_(executor) {}

  // Where there is no room for all pinholes among triangles of an ordinary size, they get vertices.
  SurfaceRemesh run() {
    for (const bool may_have_pinholes : {true, false}) {
      const auto count = static_cast<double>(options_.vertex_count);
      const double spacing = std::sqrt(2 * input_.fine.whole_area / (root_3 * count));
      outer_ = find_outer_chains(input_, spacing, may_have_pinholes);
      RestingSites resting = rest_sites(input_, outer_, options_.vertex_count, relaxer_, executor_);
      dualised_ = repair_dual(input_, outer_, std::move(resting), relaxer_, executor_);
      if (open_pinholes(input_, outer_, dualised_.state.sites, dualised_.dual.triangles)) break;
    }
    return remesh();
  }

 private:
  static constexpr double root_3 = 1.7320508075688772;

  SurfaceRemesh remesh() {
    const SurfaceSites& sites = dualised_.state.sites;
    SurfaceRemesh result;
    result.vertices_asked_for = options_.vertex_count;
    result.boundary_sites = sites.outer;
    result.pinholes = outer_.pinholes.size();
    result.interrupted = relaxer_.is_interrupted();
    result.steps = relaxer_.steps();
    result.places = place_sites(mesh_, input_, sites.positions, dualised_.state.labels, executor_);
    for (const SurfacePoint& place : result.places) {
      result.mesh.positions.push_back(position_of(mesh_, place));
    }
    result.mesh.triangles = std::move(dualised_.dual.triangles);
    result.topology = find_topology(result.mesh, find_edges(result.mesh));
    if (result.is_manifold()) result.edges_flipped = flip_edges(result.mesh);
    result.surface_parts = parts_of(input_, outer_);
    result.vertices_cut = input_.vertices_cut;
    result.violations_left = dualised_.dual.violations.size();
    result.fingerprint = fingerprint_with(result.mesh);
    measure_energy(result);
    return result;
  }

  void measure_energy(SurfaceRemesh& result) const {
    const MomentUnit unit(input_.fine.whole_area);
    double energy = 0;
    for (std::size_t r = 0; r < result.mesh.vertex_count(); ++r) {
      energy += unit.energy(dualised_.cells[r], input_.frame.to_unit(result.mesh.positions[r]));
    }
    const double square = 1 / (input_.frame.scale * input_.frame.scale);
    result.energy = energy * square * square;
    result.energy_of_hexagonal_tiling =
        energy_of_hexagonal_tiling(input_.fine.whole_area * square, result.mesh.vertex_count());
  }

  [[nodiscard]] std::uint64_t fingerprint_with(const Mesh& remesh) const {
    std::uint64_t fingerprint = relaxer_.fingerprint();
    for (const Vec3& p : remesh.positions) {
      for (const double x : p)
        fingerprint = mix_bits(fingerprint ^ std::bit_cast<std::uint64_t>(x));
    }
    for (const Triangle& t : remesh.triangles) {
      for (const VertexId v : t) fingerprint = mix_bits(fingerprint ^ v);
    }
    return fingerprint;
  }

  const Mesh& mesh_;
  const SurfaceInput& input_;
  const SurfaceRemeshOptions& options_;
  SiteRelaxer relaxer_;
  Executor& executor_;
  OuterChains outer_;
  DualisedSites dualised_;
};

// Edges are short enough that each cell has vertices: 0.6 times the root of a cell's area. The
// limit of vertices is for needles.
SurfaceInput make_fine_input(const Mesh& mesh, const MeshEdges& edges, std::size_t vertex_count,
                             Executor& executor) {
  double area = 0;
  for (const double a : triangle_areas(mesh, edges.duplicates, executor)) area += a;
  if (!(area > 0)) throw InvalidInput("mesh: no triangle with an area, so nothing to remesh");
  const auto count = static_cast<double>(vertex_count);
  const std::size_t limit = 1'000'000 + 20 * vertex_count + 4 * mesh.vertex_count();
  return make_surface_input(mesh, edges.duplicates, 0.6 * std::sqrt(area / count), limit, executor);
}

}  // namespace

bool SurfaceRemesh::is_manifold() const {
  return !mesh.triangles.empty() && topology.is_manifold();
}

bool SurfaceRemesh::has_input_topology() const {
  return is_manifold() && topology.parts == surface_parts;
}

SurfaceRemesh make_surface_remesh(const Mesh& mesh, const MeshEdges& edges,
                                  const SurfaceRemeshOptions& options,
                                  const MakeSurfaceEngine& make_engine, Executor& executor) {
  if (options.vertex_count < 4) {
    throw InvalidInput("vertex_count: " + std::to_string(options.vertex_count) +
                       ": a remesh has at least 4 vertices");
  }
  const SurfaceInput input = make_fine_input(mesh, edges, options.vertex_count, executor);
  return SurfaceRemesher(mesh, input, options, make_engine, executor).run();
}

}  // namespace geolloyd

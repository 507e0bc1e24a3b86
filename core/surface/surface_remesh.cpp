#include "core/surface/surface_remesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/random.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_topology.h"
#include "core/surface/creases.h"
#include "core/surface/edge_flips.h"
#include "core/surface/patches.h"
#include "core/surface/pinholes.h"
#include "core/surface/site_budget.h"
#include "core/surface/site_levels.h"
#include "core/surface/site_places.h"
#include "core/surface/site_relaxer.h"
#include "core/surface/surface_fit.h"
#include "core/surface/surface_input.h"
#include "core/surface/surface_repair.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

std::vector<PartTopology> parts_of(const SurfaceInput& input, const Chains& chains) {
  std::vector<PartTopology> parts;
  for (const std::int64_t characteristic : euler_characteristics(input)) {
    parts.push_back({characteristic, 0});
  }
  for (const VertexId v : chains.loops) ++parts[input.part[v]].boundary_loops;
  std::sort(parts.begin(), parts.end());
  return parts;
}

// At which so many sites cover an area.
double spacing_of(double area, std::size_t sites) {
  constexpr double root_3 = 1.7320508075688772;
  return std::sqrt(2 * area / (root_3 * static_cast<double>(sites)));
}

// Of edges on chains: those that are no boundary of the remesh.
std::vector<std::array<VertexId, 2>> edges_along_features(
    const Mesh& remesh, const std::vector<std::array<VertexId, 2>>& on_chains) {
  const MeshEdges edges = find_edges(remesh);
  std::vector<std::array<VertexId, 2>> found;
  for (const auto& edge : on_chains) {
    const auto at = std::lower_bound(edges.ends.begin(), edges.ends.end(), edge);
    if (at == edges.ends.end() || *at != edge) continue;
    if (edges.corners(static_cast<std::size_t>(at - edges.ends.begin())).size() == 2) {
      found.push_back(edge);
    }
  }
  return found;
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
    const bool has_count = options_.vertex_count > 0;
    const double spacing = has_count ? spacing_of(input_.fine.whole_area, options_.vertex_count)
                                     : options_.edge_length * input_.frame.scale;
    for (const bool may_have_pinholes : {true, false}) {
      surface_.emplace(input_, spacing, may_have_pinholes, executor_);
      count_ =
          has_count ? options_.vertex_count : SiteBudgeter(*surface_).at_spacing(spacing).total();
      RestingSites resting = rest_sites(*surface_, count_, relaxer_, executor_);
      dualised_ = repair_dual(*surface_, std::move(resting), relaxer_, executor_);
      if (open_pinholes(*surface_, dualised_.state.sites, dualised_.dual.triangles)) break;
    }
    return remesh();
  }

 private:
  SurfaceRemesh remesh() {
    relaxer_.release_engine();
    const SurfaceSites& sites = dualised_.state.sites;
    SurfaceRemesh result;
    result.vertices_asked_for = count_;
    result.chain_vertices = sites.on_chains;
    result.pinholes = surface_->chains.pinholes.size();
    result.interrupted = relaxer_.is_interrupted();
    result.steps = relaxer_.steps();
    result.places = place_sites(mesh_, input_, sites.positions, dualised_.state.labels, executor_);
    place_corners(mesh_, input_, surface_->chains.corners, result.places);
    for (const SurfacePoint& place : result.places) {
      result.mesh.positions.push_back(position_of(mesh_, place));
    }
    result.mesh.triangles = std::move(dualised_.dual.triangles);
    result.topology = find_topology(result.mesh, find_edges(result.mesh));
    const auto on_chains = edges_on_chains();
    if (result.is_manifold()) result.edges_flipped = flip_edges(result.mesh, on_chains);
    result.feature_edges = edges_along_features(result.mesh, on_chains);
    measure_energy(result);
    if (options_.fit && result.is_manifold()) {
      result.vertices_fitted =
          fit_to_surface(input_, dualised_.state.labels, sites.on_chains, result.mesh, executor_)
              .moved;
    }
    result.surface_parts = parts_of(input_, surface_->chains);
    result.vertices_cut = input_.vertices_cut;
    result.violations_left = dualised_.dual.violations.size();
    result.fingerprint = fingerprint_with(result.mesh);
    return result;
  }

  [[nodiscard]] std::vector<std::array<VertexId, 2>> edges_on_chains() const {
    std::vector<RegionId> label;
    for (const VertexId v : surface_->chains.vertices) label.push_back(dualised_.state.labels[v]);
    return neighbours_on_chains(surface_->chains, label);
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
  std::optional<DividedSurface> surface_;
  std::size_t count_ = 0;
  DualisedSites dualised_;
};

// Of an edge length: but for what boundary and features change.
std::size_t about_how_many(double area, const SurfaceRemeshOptions& options) {
  if (options.vertex_count > 0) return options.vertex_count;
  constexpr double root_3 = 1.7320508075688772;
  constexpr double most = 1e9;
  const double count = 2 * area / (root_3 * options.edge_length * options.edge_length);
  if (!(count < most)) {
    throw InvalidInput("edge_length: " + std::to_string(options.edge_length) +
                       ": so short that the remesh would have more than 1,000,000,000 vertices");
  }
  return std::max<std::size_t>(4, static_cast<std::size_t>(count));
}

// Edges are short enough that each cell has vertices: 0.6 times the root of a cell's area; with
// features 0.42 spacings, so that cells follow them. The limit of vertices is for needles.
SurfaceInput make_fine_input(const Mesh& mesh, const MeshEdges& edges,
                             const SurfaceRemeshOptions& options, Executor& executor) {
  double area = 0;
  for (const double a : triangle_areas(mesh, edges.duplicates, executor)) area += a;
  if (!(area > 0)) throw InvalidInput("mesh: no triangle with an area, so nothing to remesh");
  const std::size_t count = about_how_many(area, options);
  for (const VertexId v : options.features.fixed_vertices) {
    if (v >= mesh.vertex_count()) {
      throw InvalidInput("fixed vertex " + std::to_string(v) + ": the mesh has no such vertex");
    }
  }
  const double spacing = spacing_of(area, count);
  const std::vector<TrianglePair> features =
      find_features(mesh, edges, options.features, spacing, executor);
  SurfaceInputOptions input;
  input.duplicates = edges.duplicates;
  input.longest_edge =
      features.empty() ? 0.6 * std::sqrt(area / static_cast<double>(count)) : 0.42 * spacing;
  input.vertex_limit = 1'000'000 + 20 * count + 4 * mesh.vertex_count();
  input.features = features;
  input.fixed_vertices = options.features.fixed_vertices;
  return make_surface_input(mesh, input, executor);
}

}  // namespace

double SurfaceRemesh::feature_length() const {
  double length = 0;
  for (const auto& [a, b] : feature_edges) length += norm(mesh.positions[a] - mesh.positions[b]);
  return length;
}

bool SurfaceRemesh::is_manifold() const {
  return !mesh.triangles.empty() && topology.is_manifold();
}

bool SurfaceRemesh::has_input_topology() const {
  return is_manifold() && topology.parts == surface_parts;
}

SurfaceRemesh make_surface_remesh(const Mesh& mesh, const MeshEdges& edges,
                                  const SurfaceRemeshOptions& options,
                                  const MakeSurfaceEngine& make_engine, Executor& executor) {
  if (options.edge_length != 0 && options.vertex_count != 0) {
    throw InvalidInput("vertex_count and edge_length: a remesh has one of them");
  }
  if (options.edge_length != 0) {
    if (!(options.edge_length > 0)) {
      throw InvalidInput("edge_length: " + std::to_string(options.edge_length) +
                         ": a length is above 0");
    }
  } else if (options.vertex_count < 4) {
    throw InvalidInput("vertex_count: " + std::to_string(options.vertex_count) +
                       ": a remesh has at least 4 vertices");
  }
  const SurfaceInput input = make_fine_input(mesh, edges, options, executor);
  return SurfaceRemesher(mesh, input, options, make_engine, executor).run();
}

}  // namespace geolloyd

#include "core/surface/result/remesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/base/hexagonal_energy.h"
#include "core/base/random.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/mesh_topology.h"
#include "core/surface/features/curve_sites.h"
#include "core/surface/features/patches.h"
#include "core/surface/flips/edge_flips.h"
#include "core/surface/result/remesh_fit.h"
#include "core/surface/result/site_places.h"
#include "core/surface/result/sized_surface.h"
#include "core/surface/result/subresolution_holes.h"
#include "core/surface/result/surface_repair.h"
#include "core/surface/sites/site_levels.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/substrate/surface_input.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

std::vector<PartTopology> parts_of(const SurfaceInput& input, const FeatureCurves& curves) {
  std::vector<PartTopology> parts;
  for (const std::int64_t characteristic : euler_characteristics(input)) {
    parts.push_back({characteristic, 0});
  }
  for (const VertexId v : curves.loops) ++parts[input.part[v]].boundary_loops;
  std::sort(parts.begin(), parts.end());
  return parts;
}

// Of edges on curves: those that are no boundary of the remesh.
std::vector<std::array<VertexId, 2>> edges_along_features(
    const Mesh& remesh, const std::vector<std::array<VertexId, 2>>& on_curves) {
  const MeshEdges edges = find_edges(remesh);
  std::vector<std::array<VertexId, 2>> found;
  for (const auto& edge : on_curves) {
    const auto at = std::lower_bound(edges.ends.begin(), edges.ends.end(), edge);
    if (at == edges.ends.end() || *at != edge) continue;
    if (edges.corners(static_cast<std::size_t>(at - edges.ends.begin())).size() == 2) {
      found.push_back(edge);
    }
  }
  return found;
}

class Remesher {
 public:
  Remesher(const Mesh& mesh, const SizedSurface& surface, const RemeshOptions& options,
           Runtime& runtime)
      : mesh_(mesh),
        sized_(surface),
        input_(surface.input),
        sizing_(surface.sizing),
        shape_(surface.shape),
        options_(options),
        relaxer_(input_, options, runtime),
        executor_(runtime.executor()),
        keep_going_([this] { return relaxer_.ask(dualised_.state.sites); }) {}

  // None where it may give up, and needs several times as many vertices as there are to be. Where
  // there is no room for all sub-resolution holes among triangles of an ordinary size, they get
  // vertices.
  std::optional<Remesh> run(bool may_give_up) {
    constexpr std::size_t few = 1000;
    const bool has_count = options_.vertex_count > 0;
    const double spacing = has_count ? spacing_of(input_.fine.whole_sized_area,
                                                  static_cast<double>(options_.vertex_count))
                                     : sizing_.spacing * input_.frame.scale;
    for (const bool may_have_subresolution_holes : {true, false}) {
      surface_.emplace(input_, spacing, may_have_subresolution_holes, executor_);
      const SiteBudgeter budgeter(*surface_);
      count_ = has_count ? options_.vertex_count : budgeter.at_spacing(spacing).total();
      spacing_ = has_count ? budgeter.of_size(count_).spacing : spacing;
      RestingSites resting = rest_sites(*surface_, count_, relaxer_, effort(), executor_);
      const std::size_t most_sites =
          may_give_up ? 2 * count_ + few : std::numeric_limits<std::size_t>::max();
      dualised_ = repair_dual(*surface_, std::move(resting), most_sites, relaxer_, executor_);
      if (dualised_.state.sites.size() > most_sites && !relaxer_.is_interrupted()) return {};
      if (open_subresolution_holes(*surface_, dualised_.state.sites, dualised_.dual.triangles))
        break;
    }
    return remesh();
  }

 private:
  // Glides and the fit mend what few iterations leave.
  [[nodiscard]] RestEffort effort() const {
    RestEffort effort;
    if (options_.fit && shape_.empty()) effort.fewest_iterations = 15;
    return effort;
  }

  Remesh remesh() {
    relaxer_.release_engine();
    const SurfaceSites& sites = dualised_.state.sites;
    Remesh result;
    result.vertices_asked_for = count_;
    result.curve_vertices = sites.on_curves;
    result.subresolution_holes = surface_->curves.subresolution_holes.size();
    result.steps = relaxer_.steps();
    result.places = place_sites(mesh_, input_, sites.positions, dualised_.state.labels, executor_);
    place_corners(mesh_, input_, surface_->curves.corners, result.places);
    for (const SurfacePoint& place : result.places) {
      result.mesh.positions.push_back(position_of(mesh_, place));
    }
    result.mesh.triangles = std::move(dualised_.dual.triangles);
    result.topology = find_topology(result.mesh, find_edges(result.mesh));
    const auto on_curves = edges_on_curves();
    const std::vector<Metric> shape = shapes_at(mesh_, shape_, result.places);
    if (result.is_manifold()) result.edges_flipped = flip_edges(result.mesh, on_curves, shape);
    result.feature_edges = edges_along_features(result.mesh, on_curves);
    measure_energy(result);
    if (options_.fit && result.is_manifold() && keep_going_()) {
      // Where most vertices are because the topology needs them, there is no lattice to glide in.
      const bool is_lattice = result.mesh.vertex_count() <= 2 * count_;
      fit_remesh({mesh_, input_, surface_->curves, shape, on_curves, shape.empty() && is_lattice},
                 dualised_.state.labels, result, executor_, keep_going_);
    }
    result.interrupted = relaxer_.is_interrupted();
    find_edge_lengths(result);
    result.surface_parts = parts_of(input_, surface_->curves);
    result.vertices_cut = input_.vertices_cut;
    result.small_feature_share = sized_.small.share;
    result.small_features_limited = sized_.small.is_limited;
    result.was_cut_short = input_.was_cut_short;
    if (sizing_.sizes.empty()) result.small_parts = count_small_parts();
    result.violations_left = dualised_.dual.violations.size();
    result.fingerprint = fingerprint_with(result.mesh);
    return result;
  }

  // A remesh has about twice as many triangles as vertices.
  [[nodiscard]] std::size_t count_small_parts() const {
    if (input_.parts < 2) return 0;
    std::vector<double> area(input_.parts, 0);
    for (TriangleId t = 0; t < input_.fine.triangle_count(); ++t) {
      area[input_.part[input_.fine.triangles[t][0]]] += input_.fine.area(t);
    }
    const double least = input_.fine.whole_area / (2 * static_cast<double>(count_));
    return static_cast<std::size_t>(
        std::count_if(area.begin(), area.end(), [&](double a) { return a < least; }));
  }

  [[nodiscard]] std::vector<std::array<VertexId, 2>> edges_on_curves() const {
    std::vector<RegionId> label;
    for (const VertexId v : surface_->curves.vertices) label.push_back(dualised_.state.labels[v]);
    return neighbours_on_curves(surface_->curves, label);
  }

  void measure_energy(Remesh& result) const {
    const CellEnergies energies(input_.fine, dualised_.cells);
    double energy = 0;
    for (std::size_t r = 0; r < result.mesh.vertex_count(); ++r) {
      energy += energies.at(r, input_.frame.to_unit(result.mesh.positions[r]));
    }
    const double square = 1 / (input_.frame.scale * input_.frame.scale);
    const double area = input_.fine.whole_sized_area * square;
    result.energy = energy * square * square;
    result.energy_of_hexagonal_tiling = hexagonal_energy(area, area, result.mesh.vertex_count());
  }

  void find_edge_lengths(Remesh& result) const {
    if (sizing_.sizes.empty()) return;
    result.edge_lengths.reserve(result.places.size());
    for (const SurfacePoint& place : result.places) {
      double size = place.triangle == no_id ? 1 : 0;
      for (std::size_t c = 0; c < 3 && place.triangle != no_id; ++c) {
        size += place.barycentric[c] * sizing_.sizes[mesh_.triangles[place.triangle][c]];
      }
      result.edge_lengths.push_back(size * spacing_ / input_.frame.scale);
    }
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
  const SizedSurface& sized_;
  const SurfaceInput& input_;
  const Sizing& sizing_;
  std::span<const Metric> shape_;
  const RemeshOptions& options_;
  SiteRelaxer relaxer_;
  Executor& executor_;
  std::function<bool()> keep_going_;
  std::optional<DividedSurface> surface_;
  std::size_t count_ = 0;
  double spacing_ = 0;  // unit frame
  DualisedSites dualised_;
};

void check_options(const Mesh& mesh, const RemeshOptions& options) {
  const auto fail = [](const std::string& message) { throw InvalidInput(message); };
  if (options.edge_length != 0 && options.vertex_count != 0) {
    fail("vertex_count and edge_length: a remesh has one of them");
  }
  if (options.edge_length != 0 && !(options.edge_length > 0)) {
    fail("edge_length: " + std::to_string(options.edge_length) + ": a length is above 0");
  }
  const bool has_lengths = options.edge_length != 0 || !options.sizing.edge_lengths.empty();
  if (options.vertex_count < 4 && !(has_lengths && options.vertex_count == 0)) {
    fail("vertex_count: " + std::to_string(options.vertex_count) +
         ": a remesh has at least 4 vertices");
  }
  if (!options.field.empty() && options.field.size() != mesh.vertex_count()) {
    fail("field: " + std::to_string(options.field.size()) + " tangent spaces for " +
         std::to_string(mesh.vertex_count()) + " vertices");
  }
  for (const VertexId v : options.features.fixed_vertices) {
    if (v < mesh.vertex_count()) continue;
    fail("fixed vertex " + std::to_string(v) + ": the mesh has no such vertex");
  }
}

}  // namespace

double Remesh::feature_length() const {
  double length = 0;
  for (const auto& [a, b] : feature_edges) length += norm(mesh.positions[a] - mesh.positions[b]);
  return length;
}

bool Remesh::is_manifold() const {
  return !mesh.triangles.empty() && topology.is_manifold();
}

bool Remesh::has_input_topology() const {
  return is_manifold() && topology.parts == surface_parts;
}

Remesh make_remesh(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
                   Runtime& runtime, const std::function<void()>& release_edges) {
  check_options(mesh, options);
  SurfaceSizer sizer(mesh, edges, options, release_edges, runtime);
  {
    const SizedSurface surface = sizer.run();
    const bool may_give_up = sizer.has_chosen_creases();
    if (auto remesh = Remesher(mesh, surface, options, runtime).run(may_give_up)) {
      return *std::move(remesh);
    }
  }
  const SizedSurface surface = sizer.run_without_creases();
  Remesh remesh = Remesher(mesh, surface, options, runtime).run(false).value();
  remesh.creases_left_out = true;
  return remesh;
}

}  // namespace geolloyd

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
#include "core/repair/crossings.h"
#include "core/surface/creases/creases.h"
#include "core/surface/features/curve_sites.h"
#include "core/surface/features/patches.h"
#include "core/surface/features/small_features.h"
#include "core/surface/fit/curve_fit.h"
#include "core/surface/fit/surface_fit.h"
#include "core/surface/flips/edge_flips.h"
#include "core/surface/flips/glides.h"
#include "core/surface/result/quick_remesh.h"
#include "core/surface/result/site_places.h"
#include "core/surface/result/subresolution_holes.h"
#include "core/surface/result/surface_repair.h"
#include "core/surface/sites/site_levels.h"
#include "core/surface/sizing/curvature.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/recipe.h"
#include "core/surface/sizing/sizing.h"
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

struct SizedSurface {
  SurfaceInput input;
  SmallFeatures small;
  Sizing sizing;
  std::vector<Metric> shape;  // per vertex of the mesh; empty: cells are round
};

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
    if (options_.fit && result.is_manifold() && !relaxer_.is_interrupted()) {
      fit_curves(shape, result);
      fit_and_glide(shape, on_curves, result);
      place_fitted(mesh_, input_, result.mesh.positions, dualised_.state.labels,
                   surface_->curves.vertices, sites.on_curves, result.places, executor_);
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

  void fit_curves(std::span<const Metric> shape, Remesh& result) const {
    const auto moved = fit_to_curves(input_, surface_->curves, dualised_.state.labels, shape,
                                     result.mesh, executor_);
    place_on_curves(mesh_, input_, moved, dualised_.state.labels, result.places, executor_);
    result.vertices_fitted = moved.size();
  }

  void fit_and_glide(std::span<const Metric> shape,
                     std::span<const std::array<VertexId, 2>> on_curves, Remesh& result) {
    // Where most vertices are because the topology needs them, there is no lattice to glide in.
    const bool is_lattice = result.mesh.vertex_count() <= 2 * count_;
    const FitResult fitted =
        shape.empty() && is_lattice
            ? glide(on_curves, result)
            : fit(dualised_.state.labels, shape, {.keep_going = keep_going_}, result.mesh);
    const auto distance = [&](const FitError& error) {
      return std::sqrt(error.mean_square) / input_.frame.scale;
    };
    result.vertices_fitted += fitted.moved;
    result.distance_before_fit = distance(fitted.before);
    result.distance_after_fit = distance(fitted.moved > 0 ? fitted.after : fitted.before);
  }

  [[nodiscard]] FitResult fit(std::span<const RegionId> labels, std::span<const Metric> shape,
                              const FitEffort& effort, Mesh& remesh) const {
    return fit_to_surface(input_, labels, dualised_.state.sites.on_curves, shape, remesh, executor_,
                          effort);
  }

  // A fit, glides, and a fit anew. Of many vertices the first fit is short, which saves time and
  // changes little, and the other one is made in any case. Where a point is much farther than all
  // were before any fit, or triangles pass through each other and none did, glides are tried again
  // without those about there. There are none if the mean distance grows.
  [[nodiscard]] FitResult glide(std::span<const std::array<VertexId, 2>> on_curves,
                                Remesh& result) {
    constexpr double farther = 1.05;    // times: in the mean
    constexpr double farthest = 1.125;  // times: the farthest point
    constexpr double close = 4;         // times what is negligible: the root, on mechanical parts
    constexpr int attempts = 2;
    constexpr std::size_t many = 10'000;
    constexpr int few_rounds = 3;
    const FitEffort full = {.keep_going = keep_going_};
    const bool is_short = result.mesh.vertex_count() >= many;
    FitResult fitted = fit(dualised_.state.labels, {},
                           is_short ? FitEffort{few_rounds, keep_going_} : full, result.mesh);
    const double root =
        std::max(farther * std::sqrt(fitted.after.mean_square), close * fitted.negligible);
    const double largest = std::max(farthest * fitted.before.largest, fitted.negligible);
    const auto take = [&](Mesh mesh, std::size_t glides, const FitResult& anew) {
      result.mesh = std::move(mesh);
      result.glides = glides;
      fitted.after = anew.after;
      fitted.moved = std::max(fitted.moved, anew.moved);
    };
    const bool may_cross = !find_crossings(result.mesh, executor_).empty();
    std::vector<std::uint8_t> barred(result.mesh.vertex_count(), 0);
    for (int attempt = 0; attempt < attempts; ++attempt) {
      Mesh gliding = result.mesh;
      std::vector<RegionId> labels = dualised_.state.labels;
      const std::size_t glides =
          glide_irregular(input_, labels, dualised_.state.sites.on_curves, on_curves, barred,
                          gliding, executor_, keep_going_);
      if (glides == 0) break;
      const FitResult anew = fit(labels, {}, full, gliding);
      if (relaxer_.is_interrupted()) return fitted;
      const auto crossing =
          may_cross ? std::vector<TrianglePair>() : find_crossings(gliding, executor_);
      if (anew.after.largest <= largest && crossing.empty()) {
        if (anew.after.mean_square > root * root) break;
        take(std::move(gliding), glides, anew);
        dualised_.state.labels = std::move(labels);
        return fitted;
      }
      for (std::size_t v = 0; v < barred.size(); ++v) {
        if (anew.far_at[v] > largest) barred[v] = 1;
      }
      mark_corners(gliding, crossing, barred);
    }
    if (is_short) {
      Mesh mesh = result.mesh;
      const FitResult anew = fit(dualised_.state.labels, {}, full, mesh);
      take(std::move(mesh), 0, anew);
    }
    return fitted;
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

// Makes the surface on which sites move, and finds out how far apart they are to be.
class SurfaceSizer {
 public:
  SurfaceSizer(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
               const std::function<void()>& release_edges, Runtime& runtime)
      : mesh_(mesh),
        edges_(edges),
        options_(options),
        release_edges_(release_edges),
        runtime_(runtime),
        executor_(runtime.executor()) {
    for (const double a : triangle_areas(mesh, edges.duplicates, executor_)) area_ += a;
    if (!(area_ > 0)) throw InvalidInput("mesh: no triangle with an area, so nothing to remesh");
  }

  SizedSurface run() {
    shape_ = shapes_of(options_.field);
    sizing_ = find_sizing(mesh_, edges_, options_, executor_);
    features_ = find_features(options_.features);
    if (has_creases_to_choose()) {
      FeatureOptions without_creases = options_.features;
      without_creases.creases = Creases::none;
      other_features_ = find_features(without_creases);
    }
    if (!needs_edges()) release_edges();
    SurfaceInput input = make_input();
    if (options_.sizing.adapt > 0) {
      const double spacing = sizing_.spacing * input.frame.scale;
      const std::vector<double> lengths = lengths_of_curvatures(
          relative_curvatures(mesh_, input, spacing, executor_), options_.sizing.adapt);
      input = {};
      sizing_ = find_sizing(mesh_, edges_, lengths, options_, executor_);
      release_edges();
      input = make_input();
    }
    SizedSurface surface = sized(std::move(input));
    if (options_.sizing.equal_error) surface = with_equal_error(std::move(surface));
    return surface;
  }

  /// Whether creases were looked for, and found.
  [[nodiscard]] bool has_chosen_creases() const {
    return has_creases_to_choose() && features_ != other_features_;
  }

  /// After run(): the same without creases.
  SizedSurface run_without_creases() {
    features_ = std::move(other_features_);
    return sized(make_input());
  }

 private:
  [[nodiscard]] bool needs_edges() const {
    return options_.sizing.adapt > 0 || options_.sizing.equal_error;
  }

  // With sizes that a quick remesh asks for, or as it is where it asks for none.
  SizedSurface with_equal_error(SizedSurface surface) {
    const std::vector<double> lengths = lengths_by_quick_remesh(
        mesh_, surface.input, shape_, count_at(sizing_.spacing), options_, runtime_);
    if (!lengths.empty()) {
      sizing_ = find_sizing(mesh_, edges_, lengths, options_, executor_);
      std::vector<double> sizes = at_fine_vertices(mesh_, surface.input, sizing_.sizes, executor_);
      surface =
          sized(with_sizes(std::move(surface.input), std::move(sizes), input_options(), executor_));
    }
    release_edges();
    return surface;
  }

  void release_edges() const {
    if (release_edges_) release_edges_();
  }

  [[nodiscard]] std::size_t count_at(double spacing) const {
    return options_.vertex_count > 0 ? options_.vertex_count : expected_sites(area_, spacing);
  }

  [[nodiscard]] bool has_creases_to_choose() const {
    return options_.features.creases == Creases::automatic;
  }

  [[nodiscard]] std::vector<TrianglePair> find_features(const FeatureOptions& features) const {
    return geolloyd::find_features(mesh_, edges_, features, sizing_.spacing, executor_);
  }

  [[nodiscard]] SurfaceInput make_input() const {
    return make_surface_input(mesh_, input_options(), executor_);
  }

  // With sizes for what is small.
  [[nodiscard]] SizedSurface sized(SurfaceInput input) const {
    SmallFeatures small;
    if (options_.features.small) {
      small =
          find_small_features(input, sizing_.spacing * input.frame.scale, growth_at_small_features);
    }
    if (!small.sizes.empty()) {
      input = with_sizes(std::move(input), std::move(small.sizes), input_options(), executor_);
    }
    return {std::move(input), std::move(small), sizing_, shape_};
  }

  [[nodiscard]] SurfaceInputOptions input_options() const {
    const std::size_t count = count_at(sizing_.spacing);
    SurfaceInputOptions input;
    input.duplicates = edges_.duplicates;
    input.longest_edge =
        features_.empty() ? longest_edge(area_, count) : longest_edge_at_features(area_, count);
    input.sizes = sizing_.sizes;
    input.metric = shape_;
    input.vertex_limit = vertex_limit_of_remesh(mesh_, count);
    input.most_pieces = most_pieces_of_remesh(mesh_, count);
    input.features = features_;
    input.fixed_vertices = options_.features.fixed_vertices;
    return input;
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const RemeshOptions& options_;
  const std::function<void()>& release_edges_;
  Runtime& runtime_;
  Executor& executor_;
  double area_ = 0;
  Sizing sizing_;
  std::vector<TrianglePair> features_;
  std::vector<TrianglePair> other_features_;  // without creases that were found
  std::vector<Metric> shape_;
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

#include "core/surface/result/sized_surface.h"

#include <utility>

#include "core/mesh/mesh_measure.h"
#include "core/surface/creases/creases.h"
#include "core/surface/result/quick_remesh.h"
#include "core/surface/sizing/curvature.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/recipe.h"
#include "geolloyd/errors.h"

namespace geolloyd {

SurfaceSizer::SurfaceSizer(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
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

SizedSurface SurfaceSizer::run() {
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

SizedSurface SurfaceSizer::run_without_creases() {
  features_ = std::move(other_features_);
  return sized(make_input());
}

bool SurfaceSizer::needs_edges() const {
  return options_.sizing.adapt > 0 || options_.sizing.equal_error;
}

// With sizes that a quick remesh asks for, or as it is where it asks for none.
SizedSurface SurfaceSizer::with_equal_error(SizedSurface surface) {
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

void SurfaceSizer::release_edges() const {
  if (release_edges_) release_edges_();
}

std::size_t SurfaceSizer::count_at(double spacing) const {
  return options_.vertex_count > 0 ? options_.vertex_count : expected_sites(area_, spacing);
}

std::vector<TrianglePair> SurfaceSizer::find_features(const FeatureOptions& features) const {
  return geolloyd::find_features(mesh_, edges_, features, sizing_.spacing, executor_);
}

SurfaceInput SurfaceSizer::make_input() const {
  return make_surface_input(mesh_, input_options(), executor_);
}

// With sizes for what is small.
SizedSurface SurfaceSizer::sized(SurfaceInput input) const {
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

SurfaceInputOptions SurfaceSizer::input_options() const {
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

}  // namespace geolloyd

#include <pybind11/stl.h>

#include <optional>
#include <utility>

#include "geolloyd/evaluation.h"
#include "geolloyd/fields.h"
#include "geolloyd/remesh.h"
#include "geolloyd/threads.h"
#include "tools/python/arrays.h"
#include "tools/python/module.h"
#include "tools/python/watch.h"

namespace geolloyd {
namespace {

// How fine: one of three is above 0, or lengths are given.
struct Fineness {
  std::size_t count = 0;
  double edge_length = 0;
  double tolerance = 0;
};

ToleranceRemesh make_graph_dual(const Mesh& mesh, const Fineness& fineness, RemeshOptions options,
                                bool by_curvature, std::size_t threads) {
  Threads runtime(threads);
  const HeedInterrupts heed(runtime.executor());
  if (by_curvature) options.field = curvature_field(mesh, runtime);
  if (fineness.tolerance != 0) {
    return remesh_within(mesh, fineness.tolerance, std::move(options), runtime);
  }
  options.vertex_count = fineness.count;
  options.edge_length = fineness.edge_length;
  return {remesh(mesh, options, runtime), {}, {}};
}

py::list trials_of(const std::vector<ToleranceTrial>& trials) {
  py::list list;
  for (const ToleranceTrial& trial : trials) {
    list.append(py::dict(py::arg("vertices") = trial.vertices, py::arg("distance") = trial.distance,
                         py::arg("distance_lower") = trial.lower));
  }
  return list;
}

py::list warnings_of(const std::vector<RemeshWarning>& warnings) {
  py::list list;
  for (const RemeshWarning& warning : warnings) {
    list.append(py::dict(py::arg("kind") = name_of(warning.flaw), py::arg("text") = warning.text));
  }
  return list;
}

py::list trace_of(const std::vector<SurfaceStep>& steps) {
  py::list list;
  for (const SurfaceStep& step : steps) {
    list.append(py::dict(py::arg("sites") = step.sites,
                         py::arg("mesh_vertices") = step.mesh_vertices,
                         py::arg("energy") = step.energy, py::arg("seconds") = step.seconds));
  }
  return list;
}

py::dict report_of(const ToleranceRemesh& made) {
  const Remesh& remesh = made.remesh;
  py::dict report;
  report["fingerprint"] = fingerprint_words(remesh.fingerprint);
  report["vertices"] = remesh.mesh.vertex_count();
  report["triangles"] = remesh.mesh.triangle_count();
  report["is_manifold"] = remesh.is_manifold();
  report["has_input_topology"] = remesh.has_input_topology();
  report["topology"] = words_of(remesh.topology);
  report["input_is_manifold"] = remesh.vertices_cut == 0;
  report["input_vertices_cut"] = remesh.vertices_cut;
  report["surplus_vertices"] = static_cast<std::int64_t>(remesh.mesh.vertex_count()) -
                               static_cast<std::int64_t>(remesh.vertices_asked_for);
  report["curve_vertices"] = remesh.curve_vertices;
  report["feature_length"] = remesh.feature_length();
  report["subresolution_holes"] = remesh.subresolution_holes;
  report["creases_left_out"] = remesh.creases_left_out;
  report["small_feature_share"] = remesh.small_feature_share;
  report["small_features_limited"] = remesh.small_features_limited;
  report["edges_flipped"] = remesh.edges_flipped;
  report["glides"] = remesh.glides;
  report["vertices_fitted"] = remesh.vertices_fitted;
  report["distance_before_fit"] = remesh.distance_before_fit;
  report["distance_after_fit"] = remesh.distance_after_fit;
  report["self_intersections"] = remesh.self_intersections.size();
  report["closed_ball_violations_left"] = remesh.violations_left;
  report["interrupted"] = remesh.interrupted;
  report["iterations"] = remesh.steps.size();
  report["energy"] = remesh.energy;
  report["energy_ratio_hexagonal"] = remesh.energy / remesh.energy_of_hexagonal_tiling;
  report["warnings"] = warnings_of(remesh.warnings);
  report["trials"] = trials_of(made.trials);
  if (!made.trials.empty()) report["certified"] = words_of(made.bounds);
  report["trace"] = trace_of(remesh.steps);
  return report;
}

FeatureOptions features_of(const std::string& creases, double angle, bool small,
                           const std::optional<IdArray>& edges,
                           const std::optional<IdArray>& groups,
                           const std::optional<IdArray>& fixed) {
  static const std::vector<Named<Creases>> names = {
      {"auto", Creases::automatic}, {"angle", Creases::by_angle}, {"off", Creases::none}};
  FeatureOptions features;
  features.creases = choice_of("features", names, creases);
  features.crease_angle = angle;
  features.small = small;
  features.edges = pairs_of("feature_edges", edges);
  features.groups = ids_of("labels", groups);
  features.fixed_vertices = ids_of("fixed", fixed);
  return features;
}

py::tuple remesh_arrays(const NumberArray& vertices, const IdArray& faces, std::size_t count,
                        double edge_length, double tolerance,
                        const std::optional<NumberArray>& lengths,
                        const std::optional<NumberArray>& densities, double adapt, bool equal_error,
                        double growth, const std::optional<NumberArray>& field, bool by_curvature,
                        const std::string& creases, double crease_angle, bool small_features,
                        const std::optional<IdArray>& feature_edges,
                        const std::optional<IdArray>& groups, const std::optional<IdArray>& fixed,
                        bool fit, const py::object& progress, std::size_t threads) {
  const Mesh mesh = mesh_of(vertices, faces);
  RemeshOptions options;
  options.sizing = {numbers_of(lengths), numbers_of(densities), adapt, growth, equal_error};
  options.field = spaces_of(field);
  options.features =
      features_of(creases, crease_angle, small_features, feature_edges, groups, fixed);
  options.fit = fit;
  Watch watch(progress);
  options.progress = [&watch](const RemeshProgress& p) {
    return watch.keep_going(p.sites, p.wanted_sites, p.iteration, p.energy_ratio);
  };
  ToleranceRemesh made;
  {
    const py::gil_scoped_release working;
    made = make_graph_dual(mesh, {count, edge_length, tolerance}, std::move(options), by_curvature,
                           threads);
  }
  py::dict report = report_of(made);
  auto [made_vertices, made_faces] = arrays_of(std::move(made.remesh.mesh));
  auto [triangle, barycentric] = arrays_of(made.remesh.places);
  auto feature_pairs = static_cast<py::ssize_t>(made.remesh.feature_edges.size());
  py::array edges =
      array_of<std::int32_t>(std::move(made.remesh.feature_edges), {feature_pairs, 2});
  return py::make_tuple(made_vertices, made_faces, triangle, barycentric, edges, report);
}

}  // namespace

void bind_remesh(py::module_& module) {
  module.def("remesh", &remesh_arrays, py::arg("vertices"), py::arg("faces"), py::kw_only(),
             py::arg("count"), py::arg("edge_length"), py::arg("tolerance"), py::arg("lengths"),
             py::arg("densities"), py::arg("adapt"), py::arg("equal_error"), py::arg("growth"),
             py::arg("field"), py::arg("by_curvature"), py::arg("creases"), py::arg("crease_angle"),
             py::arg("small_features"), py::arg("feature_edges"), py::arg("groups"),
             py::arg("fixed"), py::arg("fit"), py::arg("progress"), py::arg("threads"));
}

}  // namespace geolloyd

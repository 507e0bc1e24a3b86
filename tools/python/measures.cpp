#include <pybind11/stl.h>

#include <utility>

#include "geolloyd/evaluation.h"
#include "geolloyd/fields.h"
#include "geolloyd/quality.h"
#include "geolloyd/threads.h"
#include "tools/python/arrays.h"
#include "tools/python/module.h"
#include "tools/python/watch.h"

namespace geolloyd {
namespace {

py::dict words_of(const DistanceFigures& figures) {
  return py::dict(py::arg("mean") = figures.mean, py::arg("rms") = figures.rms,
                  py::arg("hausdorff") = figures.largest);
}

py::dict judge(const NumberArray& vertices, const IdArray& faces, std::size_t threads) {
  const Mesh mesh = mesh_of(vertices, faces);
  MeshQuality figures;
  MeshTopology topology;
  std::size_t crossing_pairs = 0;
  {
    const py::gil_scoped_release working;
    Threads runtime(threads);
    const HeedInterrupts heed(runtime.executor());
    figures = geolloyd::quality(mesh);
    topology = find_topology(mesh);
    crossing_pairs = self_intersections(mesh, runtime).size();
  }
  py::dict words;
  words["quality"] = words_of(figures);
  words["topology"] = words_of(topology);
  words["self_intersections"] = crossing_pairs;
  return words;
}

py::array self_intersections_of_arrays(const NumberArray& vertices, const IdArray& faces,
                                       std::size_t threads) {
  const Mesh mesh = mesh_of(vertices, faces);
  std::vector<std::array<TriangleId, 2>> pairs;
  {
    const py::gil_scoped_release working;
    Threads runtime(threads);
    const HeedInterrupts heed(runtime.executor());
    pairs = self_intersections(mesh, runtime);
  }
  const auto count = static_cast<py::ssize_t>(pairs.size());
  return array_of<std::int32_t>(std::move(pairs), {count, 2});
}

py::dict distance(const NumberArray& first_vertices, const IdArray& first_faces,
                  const NumberArray& second_vertices, const IdArray& second_faces,
                  std::size_t samples, bool certify, std::size_t threads) {
  const Mesh first = mesh_of(first_vertices, first_faces);
  const Mesh second = mesh_of(second_vertices, second_faces);
  SurfaceDistance found;
  SurfaceDistanceBounds bounds;
  {
    const py::gil_scoped_release working;
    Threads runtime(threads);
    const HeedInterrupts heed(runtime.executor());
    found = measure_distance(first, second, samples, runtime);
    if (certify) bounds = certify_distance(first, second, 0, runtime);
  }
  py::dict words;
  words["samples"] = samples;
  const auto add = [&](const char* name, const DistanceFigures& figures,
                       const DistanceBounds& interval) {
    py::dict part = words_of(figures);
    if (certify) part.attr("update")(words_of(interval));
    words[name] = part;
  };
  add("remesh_to_original", found.from_first, bounds.from_first);
  add("original_to_remesh", found.from_second, bounds.from_second);
  add("two_sided", found.two_sided(), bounds.two_sided());
  return words;
}

py::tuple closest(const NumberArray& vertices, const IdArray& faces, const NumberArray& points,
                  std::size_t threads) {
  const Mesh mesh = mesh_of(vertices, faces);
  const std::vector<Vec3> wanted = points_of(points);
  std::vector<SurfacePoint> found;
  {
    const py::gil_scoped_release working;
    Threads runtime(threads);
    const HeedInterrupts heed(runtime.executor());
    found = closest_points(mesh, wanted, runtime);
  }
  auto [triangle, barycentric] = arrays_of(found);
  return py::make_tuple(triangle, barycentric);
}

}  // namespace

py::dict words_of(const DistanceBounds& bounds) {
  return py::dict(py::arg("hausdorff_lower") = bounds.lower,
                  py::arg("hausdorff_upper") = bounds.upper);
}

py::dict words_of(const MeshTopology& topology) {
  const PartTopology total = topology.total();
  return py::dict(py::arg("components") = topology.parts.size(),
                  py::arg("euler_characteristic") = total.euler_characteristic,
                  py::arg("boundary_loops") = total.boundary_loops,
                  py::arg("non_manifold_edges") = topology.non_manifold_edges,
                  py::arg("non_manifold_vertices") = topology.non_manifold_vertices,
                  py::arg("inconsistent_edges") = topology.inconsistent_edges);
}

py::dict words_of(const MeshQuality& q) {
  return py::dict(
      py::arg("smallest_angle") = q.smallest_angle,
      py::arg("mean_smallest_angle") = q.mean_smallest_angle,
      py::arg("share_under_30") = q.share_under_30, py::arg("share_obtuse") = q.share_obtuse,
      py::arg("smallest_quality") = q.smallest_quality, py::arg("mean_quality") = q.mean_quality,
      py::arg("inner_vertices") = q.inner_vertices, py::arg("share_valence_6") = q.share_valence_6,
      py::arg("share_valence_5_to_7") = q.share_valence_5_to_7);
}

void bind_measures(py::module_& module) {
  module.def("quality", &judge, py::arg("vertices"), py::arg("faces"), py::arg("threads"));
  module.def("self_intersections", &self_intersections_of_arrays, py::arg("vertices"),
             py::arg("faces"), py::arg("threads"));
  module.def("distance", &distance, py::arg("first_vertices"), py::arg("first_faces"),
             py::arg("second_vertices"), py::arg("second_faces"), py::arg("samples"),
             py::arg("certify"), py::arg("threads"));
  module.def("closest_points", &closest, py::arg("vertices"), py::arg("faces"), py::arg("points"),
             py::arg("threads"));
}

}  // namespace geolloyd

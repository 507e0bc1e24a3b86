#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>

#include "geolloyd/dual.h"
#include "geolloyd/evaluation.h"
#include "geolloyd/fields.h"
#include "geolloyd/relax.h"
#include "geolloyd/remesh.h"
#include "geolloyd/threads.h"
#include "tools/python/arrays.h"
#include "tools/python/module.h"
#include "tools/python/watch.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

// A tessellation whose arrays Python has, with all that its dual is made from.
struct Tessellated {
  Mesh mesh;
  Tessellation tessellation;
};

enum class SurfaceField { given, curvature, cross };

// What all functions of this file take.
struct Request {
  Mesh mesh;
  RelaxOptions options;
  SurfaceField field = SurfaceField::given;
  std::size_t threads = 0;

  Request(const NumberArray& vertices, const IdArray& faces, const py::dict& given)
      : mesh(mesh_of(vertices, faces)) {
    const auto text = [&](const char* name) { return given[name].cast<std::string>(); };
    options.seed_count = given["count"].cast<std::size_t>();
    options.first_seeds = ids_of("seeds", given["seeds"].cast<std::optional<IdArray>>());
    if (const auto positions = given["positions"].cast<std::optional<NumberArray>>()) {
      options.first_positions = points_of(*positions);
    }
    options.init = choice_of("init", seed_init_names, text("init"));
    options.random_seed = given["random_seed"].cast<std::uint64_t>();
    options.graph = choice_of("graph", graph_kind_names, text("graph"));
    options.norm = choice_of("norm", norm_names, text("norm"));
    options.averaging = choice_of("averaging", averaging_choice_names, text("averaging"));
    options.field = spaces_of(given["field"].cast<std::optional<NumberArray>>());
    const std::string of_surface = text("surface_field");
    if (of_surface == "curvature") field = SurfaceField::curvature;
    if (of_surface == "cross") field = SurfaceField::cross;
    threads = given["threads"].cast<std::size_t>();
  }

  void find_field(Runtime& runtime) {
    if (field == SurfaceField::curvature) options.field = curvature_field(mesh, runtime);
    if (field == SurfaceField::cross) options.field = cross_field(mesh, runtime);
  }
};

py::list trace_of(const std::vector<TessellationStep>& steps) {
  py::list list;
  for (const TessellationStep& step : steps) {
    list.append(py::dict(py::arg("phase") = name_of(phase_names, step.phase),
                         py::arg("energy") = step.energy, py::arg("seeds_moved") = step.seeds_moved,
                         py::arg("node_visits") = step.node_visits,
                         py::arg("seconds") = step.seconds));
  }
  return list;
}

// The arrays and figures, by their names in Python.
py::dict words_of(Tessellation& tessellation) {
  std::vector<InputId> seeds;
  std::vector<double> areas;
  std::vector<double> energies;
  for (const Region& region : tessellation.regions) {
    seeds.push_back(region.seed);
    areas.push_back(region.area);
    energies.push_back(region.energy);
  }
  py::dict words;
  words["region"] = id_array(std::move(tessellation.region));
  words["distance"] = array_of<double>(std::move(tessellation.distance));
  words["parent"] = id_array(std::move(tessellation.parent));
  words["seeds"] = id_array(std::move(seeds));
  words["region_area"] = array_of<double>(std::move(areas));
  words["region_energy"] = array_of<double>(std::move(energies));
  words["energy"] = tessellation.energy;
  words["initial_energy"] = tessellation.initial_energy;
  words["fingerprint"] = fingerprint_words(tessellation.fingerprint);
  words["end"] = name_of(stop_reason_names, tessellation.stop_reason);
  words["trace"] = trace_of(tessellation.trace);
  return words;
}

// Without Python's lock, and on the threads that are asked for.
template <class Work>
auto work_on(Request& request, Work&& work) {
  const py::gil_scoped_release working;
  Threads runtime(request.threads);
  const HeedInterrupts heed(runtime.executor());
  request.find_field(runtime);
  return work(runtime);
}

py::tuple tessellate_arrays(const NumberArray& vertices, const IdArray& faces,
                            const py::dict& given, const std::string& greedy,
                            std::uint32_t max_greedy_steps, std::uint32_t max_macrosteps,
                            std::uint32_t improvement_rounds, const py::object& progress) {
  Request request(vertices, faces, given);
  RelaxOptions& options = request.options;
  options.greedy = choice_of("greedy", greedy_choice_names, greedy);
  options.max_greedy_steps = max_greedy_steps;
  options.max_macrosteps = max_macrosteps;
  options.improvement_rounds = improvement_rounds;
  Watch watch(progress);
  options.progress = [&watch](const Progress& p) {
    return watch.keep_going(name_of(phase_names, p.phase), p.step, p.seeds_moving, p.energy);
  };
  auto made = std::make_shared<Tessellated>();
  made->tessellation =
      work_on(request, [&](Runtime& runtime) { return relax(request.mesh, options, runtime); });
  made->mesh = std::move(request.mesh);
  py::dict words = words_of(made->tessellation);
  return py::make_tuple(words, made);
}

py::array first_seeds_of_arrays(const NumberArray& vertices, const IdArray& faces,
                                const py::dict& given) {
  Request request(vertices, faces, given);
  return id_array(work_on(request, [&](Runtime& runtime) {
    return first_seeds(request.mesh, request.options, runtime);
  }));
}

py::array distances_of_arrays(const NumberArray& vertices, const IdArray& faces,
                              const py::dict& given) {
  Request request(vertices, faces, given);
  return array_of<double>(work_on(request, [&](Runtime& runtime) {
    return distances(request.mesh, request.options, runtime);
  }));
}

py::tuple dual_arrays(const Tessellated& made, bool manifold, std::size_t threads) {
  Watch watch{py::none()};
  DualOptions options;
  options.manifold = manifold;
  options.keep_going = [&watch] { return watch.keep_going(); };
  Dual made_dual;
  std::vector<SurfacePoint> places;
  {
    const py::gil_scoped_release working;
    Threads runtime(threads);
    const HeedInterrupts heed(runtime.executor());
    made_dual = geolloyd::dual(made.mesh, made.tessellation, options, runtime);
    places = closest_points(made.mesh, made_dual.mesh.positions, runtime);
  }
  py::dict report;
  report["vertices"] = made_dual.mesh.vertex_count();
  report["triangles"] = made_dual.mesh.triangle_count();
  report["seeds_added"] = made_dual.seeds_added;
  report["is_manifold"] = made_dual.is_manifold;
  report["has_input_topology"] = made_dual.has_input_topology;
  report["input_is_manifold"] = made_dual.is_input_manifold;
  report["closed_ball_violations_left"] = made_dual.violations_left;
  report["flipped_triangles"] = made_dual.flipped;
  report["triangles_without_area"] = made_dual.flat;
  report["folded_edges"] = made_dual.folds;
  report["self_intersections"] = made_dual.self_intersections.size();
  report["interrupted"] = made_dual.interrupted;
  auto [vertices, faces] = arrays_of(std::move(made_dual.mesh));
  auto [triangle, barycentric] = arrays_of(places);
  return py::make_tuple(vertices, faces, triangle, barycentric,
                        id_array(std::move(made_dual.seeds)), report);
}

py::dict ground_truth(const Tessellated& made, std::size_t threads) {
  Evaluation found;
  {
    const py::gil_scoped_release working;
    Threads runtime(threads);
    const HeedInterrupts heed(runtime.executor());
    found = evaluate(made.mesh, made.tessellation, runtime);
  }
  py::dict words;
  const auto regions = static_cast<py::ssize_t>(found.centroid.size());
  words["region"] = id_array(std::move(found.region));
  words["centroid"] = array_of<double>(std::move(found.centroid), {regions, 3});
  words["node_agreement"] = found.node_agreement;
  words["area_agreement"] = found.area_agreement;
  words["mean_distance_in_radii"] = found.mean_distance_in_radii;
  words["energy"] = found.energy;
  words["energy_ratio_hexagonal"] = found.energy / found.energy_of_hexagonal_tiling;
  words["graph_energy"] = found.graph_energy;
  words["graph_energy_ratio_hexagonal"] = found.graph_energy / found.energy_of_hexagonal_tiling;
  return words;
}

}  // namespace

void bind_tessellation(py::module_& module) {
  py::class_<Tessellated, std::shared_ptr<Tessellated>>(module, "Tessellated")
      .def("dual", &dual_arrays, py::arg("manifold"), py::arg("threads"))
      .def("ground_truth", &ground_truth, py::arg("threads"));
  module.def("relax", &tessellate_arrays, py::arg("vertices"), py::arg("faces"), py::arg("options"),
             py::kw_only(), py::arg("greedy"), py::arg("max_greedy_steps"),
             py::arg("max_macrosteps"), py::arg("improvement_rounds"), py::arg("progress"));
  module.def("first_seeds", &first_seeds_of_arrays, py::arg("vertices"), py::arg("faces"),
             py::arg("options"));
  module.def("distances", &distances_of_arrays, py::arg("vertices"), py::arg("faces"),
             py::arg("options"));
}

}  // namespace geolloyd

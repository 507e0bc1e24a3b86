// Surface remeshes, stage by stage: core's functions with the reference engine, and the same with
// threads and the parallel engine.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "bench/suites/suites.h"
#include "bench/support/run.h"
#include "bench/support/same_bytes.h"
#include "core/base/random.h"
#include "core/dual/seed_insertion.h"
#include "core/surface/cells/cell_labels.h"
#include "core/surface/creases/creases.h"
#include "core/surface/features/curve_sites.h"
#include "core/surface/fit/surface_fit.h"
#include "core/surface/result/remesh.h"
#include "core/surface/result/surface_repair.h"
#include "core/surface/sites/site_descent.h"
#include "core/surface/sites/site_refinement.h"
#include "core/surface/sizing/curvature.h"
#include "core/surface/sizing/sizing.h"
#include "geolloyd/threads.h"
#include "parallel/threads/scheduler.h"

namespace geolloyd {
namespace {

// Who works: the calling thread with the reference engine, or threads with the parallel one.
struct Workers {
  Runtime& runtime;
  bool are_reference;

  [[nodiscard]] Executor& executor() const { return runtime.executor(); }
};

void with_workers(Run& run, void (*body)(Run&, const Workers&)) {
  if (run.threads() == Setting::sequential) {
    body(run, {reference_runtime(), true});
    return;
  }
  Threads threads(run.threads());
  body(run, {threads, false});
}

bool same_mesh_bytes(const FineMesh& a, const FineMesh& b) {
  return same_bytes(a.positions, b.positions) && same_bytes(a.triangles, b.triangles) &&
         same_bytes(a.across_open, b.across_open) && same_bytes(a.neighbour, b.neighbour) &&
         same_bytes(a.triangle_at, b.triangle_at);
}

// The triangles of the mesh with other corners: as much area, and no edge too long.
bool is_fine_surface(const SurfaceInput& input, const SurfaceFineness& fineness) {
  const double square = input.frame.scale * input.frame.scale;
  if (std::abs(input.fine.whole_area - fineness.area * square) > 1e-9 * input.fine.whole_area) {
    return false;
  }
  if (input.fine.vertex_count() > fineness.options.vertex_limit / 2) return true;
  const double longest = fineness.options.longest_edge * input.frame.scale;
  for (const Triangle& t : input.fine.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 edge = input.fine.positions[t[(c + 1) % 3]] - input.fine.positions[t[c]];
      if (edge.norm() > longest * (1 + 1e-9)) return false;
    }
  }
  return true;
}

void make_input(Run& run, const Workers& workers) {
  Inputs& in = run.inputs();
  const SurfaceInput& expected = in.surface(run.seeds()).input();
  const SurfaceFineness fineness = surface_fineness(in.mesh(), in.edges(), run.seeds());
  const auto work = [&] {
    return make_surface_input(in.mesh(), fineness.options, workers.executor());
  };
  run.verify("not the surface of the mesh", [&] {
    const SurfaceInput made = work();
    return is_fine_surface(made, fineness) && same_mesh_bytes(made.fine, expected.fine) &&
           made.origin == expected.origin && made.boundary_edges == expected.boundary_edges &&
           made.part == expected.part;
  });
  run.measure(work);
  run.rate("triangles/s", expected.fine.triangle_count());
}

// Each vertex of the fine mesh has one that stands for it, in the same part.
bool stand_for_all(const LevelMeshes& levels, std::size_t spacing) {
  const LevelMesh& coarse = levels.at(spacing);
  if (&coarse == &levels.fine()) return true;
  const std::vector<VertexId> stands_for = levels.map(levels.fine(), coarse);
  for (std::size_t v = 0; v < stands_for.size(); ++v) {
    if (coarse.patch[stands_for[v]] != levels.fine().patch[v]) return false;
  }
  return stands_for.size() == levels.fine().patch.size();
}

bool are_levels(const LevelMeshes& levels, const LevelMeshes& expected, std::size_t count) {
  for (std::size_t s = 0; s < count; ++s) {
    if (!stand_for_all(levels, s)) return false;
    if (!same_mesh_bytes(*levels.at(s).mesh, *expected.at(s).mesh)) return false;
  }
  return true;
}

void make_levels(Run& run, const Workers& workers) {
  const RestedSurface& start = run.inputs().surface(run.seeds());
  const auto work = [&] {
    return LevelMeshes(start.surface(), start.spacings, workers.executor());
  };
  run.verify("not the levels of the calling thread", [&] {
    const LevelMeshes expected(start.surface(), start.spacings);
    return are_levels(work(), expected, start.spacings.size());
  });
  run.measure(work);
  run.rate("vertices/s", start.input().fine.vertex_count());
  run.count("levels", start.spacings.size());
}

// All free sites a tenth of a spacing away, which is farther than most steps of a descent.
std::vector<Vec3> shifted_sites(const RestedSurface& start) {
  const SurfaceSites& sites = start.resting.state.sites;
  std::vector<Vec3> shifted = sites.positions;
  for (std::size_t r = 0; r < shifted.size(); ++r) {
    if (sites.is_fixed[r] != 0) continue;
    Vec3 way;
    for (int axis = 0; axis < 3; ++axis) {
      way[axis] = 2 * random_unit(1, 3 * r + static_cast<std::size_t>(axis)) - 1;
    }
    shifted[r] += 0.1 * start.spacings.front() / std::max(way.norm(), 0.1) * way;
  }
  return shifted;
}

std::unique_ptr<SurfaceEngine> engine_at_rest(const RestedSurface& start, Runtime& runtime) {
  auto engine = runtime.make_surface_engine(start.input().fine);
  engine->assign(start.resting.state.labels, fine_level(start.surface()).is_on_curve);
  return engine;
}

bool evaluate_alike(SurfaceEngine& engine, SurfaceEngine& expected, std::span<const Vec3> sites) {
  const bool are_moments_alike = engine.evaluate(sites) == expected.evaluate(sites);
  return are_moments_alike && engine.labels() == expected.labels();
}

// There and back, so that all sites have moved in each turn.
void evaluate(Run& run, const Workers& workers) {
  const RestedSurface& start = run.inputs().surface(run.seeds());
  std::vector<Vec3> from = start.resting.state.sites.positions;
  std::vector<Vec3> to = shifted_sites(start);
  const auto engine = engine_at_rest(start, workers.runtime);
  run.verify("not the labels or moments of the reference", [&] {
    const auto reference = engine_at_rest(start, reference_runtime());
    return evaluate_alike(*engine, *reference, from) && evaluate_alike(*engine, *reference, to) &&
           evaluate_alike(*engine, *reference, from);
  });
  engine->evaluate(from);
  run.measure([&] {
    std::swap(from, to);
    engine->evaluate(from);
  });
  run.rate("vertices/s", start.input().fine.vertex_count());
}

struct Descended {
  std::vector<Vec3> sites;
  double energy;
};

// From sites that do not rest, so that all iterations take place.
Descended descend_ten(const RestedSurface& start, SurfaceEngine& engine, Executor& executor) {
  Descended result{shifted_sites(start), 0};
  DescentOptions options;
  options.is_fixed = start.resting.state.sites.is_fixed;
  options.most_iterations = 10;
  options.longest_move = 0.5 * start.spacings.front();
  result.energy = descend(start.input().fine, engine, result.sites, options, executor);
  return result;
}

// Within a thousandth of the energy that the sites were shaken from.
bool went_down(const RestedSurface& start, const Descended& descended) {
  return descended.energy < 1.001 * start.energy;
}

void descend(Run& run, const Workers& workers) {
  const RestedSurface& start = run.inputs().surface(run.seeds());
  const auto engine = workers.runtime.make_surface_engine(start.input().fine);
  const LevelMesh level = fine_level(start.surface());
  const auto prepare = [&] { engine->assign(start.resting.state.labels, level.is_on_curve); };
  const auto work = [&] { return descend_ten(start, *engine, workers.executor()); };
  run.verify("not the way down of the reference", [&] {
    prepare();
    const Descended found = work();
    if (workers.are_reference) return went_down(start, found);
    const auto reference = engine_at_rest(start, reference_runtime());
    const Descended expected = descend_ten(start, *reference, sequential());
    return same_bytes(found.sites, expected.sites) && same_bytes(found.energy, expected.energy);
  });
  run.measure(prepare, work);
  run.count("iterations", 10);
}

struct Refined {
  Refinement refinement;
  std::vector<RegionId> labels;
};

Refined refine_at_rest(const RestedSurface& start, const CurveSites& finer,
                       std::span<const std::array<RegionId, 2>> on_curves,
                       std::span<const VertexId> itself, Executor& executor) {
  const LabelledSites& state = start.resting.state;
  const LevelMesh level = fine_level(start.surface());
  const auto adjacent = adjacent_cells(level, state.labels);
  Refined refined{refine_sites(state.sites, adjacent, on_curves, finer), {}};
  refined.labels = inherit_labels(level, refined.refinement, state.labels, itself, executor);
  return refined;
}

// No heir of a vertex's old site is nearer to it than that of its new label.
bool inherit_nearest(const RestedSurface& start, const Refined& refined) {
  for (std::size_t v = 0; v < refined.labels.size(); ++v) {
    const Vec3& p = start.input().fine.positions[v];
    const auto distance = [&](RegionId r) {
      return (p - refined.refinement.sites.positions[r]).squaredNorm();
    };
    for (const RegionId heir : refined.refinement.child_sites[start.resting.state.labels[v]]) {
      if (refined.labels[v] == no_id) return false;
      if (distance(heir) < distance(refined.labels[v]) * (1 - 1e-12)) return false;
    }
  }
  return true;
}

void refine(Run& run, const Workers& workers) {
  const RestedSurface& start = run.inputs().surface(run.seeds());
  const CurveSites old =
      place_curve_sites(start.input(), start.surface().curves, start.spacings.front());
  const CurveSites finer =
      place_curve_sites(start.input(), start.surface().curves, start.spacings.front() / 2);
  const auto on_curves = neighbours_on_curves(start.surface().curves, old.label);
  std::vector<VertexId> itself(start.input().fine.vertex_count());
  std::iota(itself.begin(), itself.end(), VertexId{0});
  const auto work = [&] {
    return refine_at_rest(start, finer, on_curves, itself, workers.executor());
  };
  run.verify("not the nearest of the child_sites", [&] {
    const Refined found = work();
    const Refined expected = refine_at_rest(start, finer, on_curves, itself, sequential());
    return inherit_nearest(start, found) && same_bytes(found.labels, expected.labels);
  });
  run.measure(work);
  run.rate("vertices/s", itself.size());
}

struct Repaired {
  DualisedSites dualised;
  std::uint64_t fingerprint = 0;
};

Repaired repair_at_rest(const RestedSurface& start, RestingSites resting, std::size_t sites,
                        Runtime& runtime) {
  RemeshOptions options;
  options.vertex_count = sites;
  SiteRelaxer relaxer(start.input(), options, runtime);
  DualisedSites dualised =
      repair_dual(start.surface(), std::move(resting), 4 * sites, relaxer, runtime.executor());
  return {std::move(dualised), relaxer.fingerprint()};
}

// The dual of sites at rest, in mesh units.
struct LabelledDual {
  Mesh mesh;
  std::vector<RegionId> labels;
  std::size_t on_curves = 0;
};

LabelledDual dual_at_rest(const RestedSurface& start, std::size_t sites) {
  DualisedSites dualised =
      repair_at_rest(start, start.resting, sites, reference_runtime()).dualised;
  LabelledDual dual;
  for (const Vec3& site : dualised.state.sites.positions) {
    dual.mesh.positions.push_back(start.input().frame.to_mesh(site));
  }
  dual.mesh.triangles = std::move(dualised.dual.triangles);
  dual.labels = std::move(dualised.state.labels);
  dual.on_curves = dualised.state.sites.on_curves;
  return dual;
}

void repair(Run& run, const Workers& workers) {
  const RestedSurface& start = run.inputs().surface(run.seeds());
  const std::size_t sites = run.seeds();
  RestingSites resting;
  const auto prepare = [&] { resting = start.resting; };
  const auto work = [&] {
    return repair_at_rest(start, std::move(resting), sites, workers.runtime);
  };
  run.verify("not the dual of the reference", [&] {
    prepare();
    const Repaired found = work();
    if (workers.are_reference) return !any_removable(found.dualised.dual.violations);
    const Repaired expected = repair_at_rest(start, start.resting, sites, reference_runtime());
    return found.fingerprint == expected.fingerprint &&
           found.dualised.dual.triangles == expected.dualised.dual.triangles;
  });
  run.measure(prepare, work);
  run.rate("vertices/s", start.input().fine.vertex_count());
}

void fit(Run& run, const Workers& workers) {
  const RestedSurface& start = run.inputs().surface(run.seeds());
  const LabelledDual dual = dual_at_rest(start, run.seeds());
  Mesh mesh;
  const auto prepare = [&] { mesh = dual.mesh; };
  const auto work = [&] {
    return fit_to_surface(start.input(), dual.labels, dual.on_curves, {}, mesh, workers.executor());
  };
  run.verify("not closer, or not the fit of the calling thread", [&] {
    prepare();
    const FitResult found = work();
    Mesh expected = dual.mesh;
    fit_to_surface(start.input(), dual.labels, dual.on_curves, {}, expected);
    return found.after.mean_square <= found.before.mean_square &&
           same_bytes(mesh.positions, expected.positions);
  });
  run.measure(prepare, work);
  run.rate("vertices/s", dual.mesh.vertex_count());
}

void find_creases(Run& run, const Workers& workers) {
  Inputs& in = run.inputs();
  FeatureOptions options;
  options.creases = Creases::by_angle;
  const auto work = [&] {
    return find_features(in.mesh(), in.edges(), options, 0, workers.executor());
  };
  run.verify("not the features of the calling thread",
             [&] { return work() == find_features(in.mesh(), in.edges(), options, 0); });
  run.measure(work);
  run.rate("triangles/s", in.mesh().triangle_count());
}

void find_sizes(Run& run, const Workers& workers) {
  Inputs& in = run.inputs();
  const RestedSurface& start = run.inputs().surface(run.seeds());
  RemeshOptions options;
  options.vertex_count = run.seeds();
  options.sizing.adapt = 1;
  const auto sizes = [&](Executor& executor) {
    const std::vector<double> curvature =
        relative_curvatures(in.mesh(), start.input(), start.spacings.front(), executor);
    const std::vector<double> lengths = lengths_of_curvatures(curvature, 1);
    return find_sizing(in.mesh(), in.edges(), lengths, options, executor).sizes;
  };
  run.verify("not the sizes of the calling thread",
             [&] { return same_bytes(sizes(workers.executor()), sizes(sequential())); });
  run.measure([&] { return sizes(workers.executor()); });
  run.rate("vertices/s", in.mesh().vertex_count());
}

void remesh(Run& run, const Workers& workers) {
  Inputs& in = run.inputs();
  RemeshOptions options;
  options.vertex_count = run.seeds();
  const Remesh& expected = in.surface_remesh(run.seeds());
  const auto work = [&] { return make_remesh(in.mesh(), in.edges(), options, workers.runtime); };
  // Of the reference verified when its result was made, once for all.
  if (!workers.are_reference) {
    run.verify("not the course of the reference", [&] {
      const Remesh found = work();
      return found.fingerprint == expected.fingerprint &&
             same_bytes(found.mesh.positions, expected.mesh.positions) &&
             same_bytes(found.mesh.triangles, expected.mesh.triangles);
    });
  }
  run.measure(work);
  run.count("iterations", expected.steps.size());
}

constexpr std::pair<const char*, void (*)(Run&, const Workers&)> stages[] = {
    {"input", make_input}, {"levels", make_levels},    {"evaluation", evaluate},
    {"descent", descend},  {"refinement", refine},     {"repair", repair},
    {"fit", fit},          {"features", find_creases}, {"sizes", find_sizes},
    {"remesh", remesh},
};

}  // namespace

void add_surface_benchmarks(const BenchMesh& mesh) {
  std::vector<std::size_t> threads = thread_ladder();
  threads.insert(threads.begin(), Setting::sequential);
  for (const auto& [name, stage] : stages) {
    for (const std::size_t count : threads) {
      add_benchmark(std::string("surface/") + name, mesh, {mesh.usual_seeds, count, {}},
                    [stage = stage](Run& run) { with_workers(run, stage); });
    }
  }
}

}  // namespace geolloyd

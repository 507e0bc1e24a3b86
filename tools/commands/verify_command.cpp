#include <fmt/format.h>
#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/course/paired_surfaces.h"
#include "core/course/remesh_course.h"
#include "core/library/reference_runtime.h"
#include "core/lloyd/paired_engine.h"
#include "geolloyd/errors.h"
#include "geolloyd/threads.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/report/report_parts.h"
#include "tools/run/remesh.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_limit.h"
#include "tools/words/facts_text.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

struct VerifyArguments {
  RunRequest start;
  RelaxationArguments relaxation;
  EngineArguments engine;
  ThreadArguments threads;
  RemeshRequest request;  ///< of a surface remesh; without vertices: a relaxation
};

void print_times(double reference, double parallel, const Scheduler& scheduler) {
  fmt::print("  {:<12}reference {:.3f} s, parallel {:.3f} s with {} of {}: {:.1f} times as fast\n",
             "time", reference, parallel, counted(scheduler.threads(), "thread", "threads"),
             name_of(backend_names, scheduler.backend()), reference / parallel);
}

Json seconds_part(double reference, double parallel) {
  return {{"reference", reference}, {"parallel", parallel}};
}

// The beginning of what --json prints. There is nothing else than agreement to tell of.
Json begin_agreement(const Input& input, const Scheduler& scheduler, bool was_interrupted,
                     std::uint64_t fingerprint) {
  Json result = begin_result("verify", input);
  result["equal"] = true;
  result["interrupted"] = was_interrupted;
  result["threads"] = scheduler.threads();
  result["backend"] = name_of(backend_names, scheduler.backend());
  result["fingerprint"] = fingerprint_text(fingerprint);
  return result;
}

Json agreement(const VerifyArguments& a, const LoadedInput& loaded, const Remesh& remesh,
               const SurfaceComparison& comparison, const Scheduler& scheduler) {
  Json result = begin_agreement(loaded.input, scheduler, remesh.interrupted, remesh.fingerprint);
  result["options"] = {{"vertices", a.request.options.vertex_count}};
  result["vertices"] = remesh.mesh.vertex_count();
  result["compared"] = {{"labels", comparison.labels},
                        {"cells", comparison.cells},
                        {"evaluations", comparison.evaluations},
                        {"meshes", comparison.meshes}};
  result["seconds"] = seconds_part(comparison.expected_seconds, comparison.tested_seconds);
  return result;
}

Json agreement(const VerifyArguments& a, const PreparedInput& start, const Relaxation& relaxation,
               const PairedEngine& pair, const Scheduler& scheduler) {
  Json result =
      begin_agreement(start.input, scheduler, relaxation.stop_reason == StopReason::interrupted,
                      relaxation.fingerprint);
  result["options"] =
      options_part(a.start, relaxation_options(a.start.seeds, a.start.seed_file, a.relaxation),
                   start.seeds.size());
  result["graph"] = graph_part(start.mesh_graph.graph, start.components);
  result["seed_fit"] = seed_fit_part(start.seed_fit);
  result["steps"] = steps_part(count_steps(relaxation));
  result["seconds"] = seconds_part(pair.expected_seconds(), pair.tested_seconds());
  return result;
}

void print_agreement(const LoadedInput& loaded, const Remesh& remesh,
                     const SurfaceComparison& comparison) {
  fmt::print("{}: {}, remesh of {}\n", loaded.input.file.string(),
             counted(loaded.input.facts.vertices, "vertex", "vertices"),
             grouped(remesh.mesh.vertex_count()));
  fmt::print("  {:<12}in all {} and {} of {}, on {}\n", "identical",
             counted(comparison.labels, "label", "labels"),
             counted(comparison.cells, "cell's moments", "cells' moments"),
             counted(comparison.evaluations, "evaluation", "evaluations"),
             counted(comparison.meshes, "mesh", "meshes"));
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(remesh.fingerprint));
}

void print_agreement(const PreparedInput& start, const Relaxation& relaxation,
                     const PairedEngine& pair, const Scheduler& scheduler) {
  const StepCounts steps = count_steps(relaxation);
  fmt::print("{}: {} graph, {}, {}\n", start.input.file.string(),
             name_of(graph_kind_names, start.mesh_graph.kind),
             counted(start.mesh_graph.graph.node_count(), "node", "nodes"),
             counted(relaxation.seeds.size(), "seed", "seeds"));
  if (start.seed_fit) fmt::print("{}", describe(*start.seed_fit, start.input.facts));
  fmt::print("  {:<12}in every node of {}, {} of {}\n", "identical",
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
  if (steps.improvement > 0) {
    fmt::print("  {:<12}in {} of improvement\n", "identical",
               counted(steps.improvement, "round", "rounds"));
  }
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(relaxation.fingerprint));
  print_times(pair.expected_seconds(), pair.tested_seconds(), scheduler);
}

std::string describe(const Disagreement& difference, const MeshGraph& mesh_graph) {
  std::string text = "the engines differ ";
  text += difference.what();
  if (difference.node != no_id) {
    text += fmt::format(", at node {} (input id {})", difference.node,
                        mesh_graph.input_id[difference.node]);
  }
  return text;
}

void verify_relaxation(const VerifyArguments& a, const Console& console) {
  check_seeds(a.start.seeds, a.start.seed_file);
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(a.threads);
  Threads threads(scheduler, a.engine.frontier);
  const PreparedInput start = prepare(a.start, {}, threads, progress);
  catch_interrupts();
  const Graph& graph = start.mesh_graph.graph;
  const auto reference = reference_runtime().make_engine(graph);
  const auto parallel = threads.make_engine(graph);
  PairedEngine pair(*reference, *parallel);
  Relaxation relaxation;
  try {
    relaxation = relax(graph, pair, start.seeds,
                       relaxation_options(a.start.seeds, a.start.seed_file, a.relaxation),
                       [&](const Progress& p) {
                         progress.show(p, start.seeds.size());
                         return !interrupted();
                       });
  } catch (const Disagreement& difference) {
    throw std::runtime_error(describe(difference, start.mesh_graph));
  }
  progress.clear();
  if (console.wants_json())
    console.print_json(json_text(agreement(a, start, relaxation, pair, scheduler)));
  print_agreement(start, relaxation, pair, scheduler);
  if (relaxation.stop_reason == StopReason::interrupted) throw InterruptedExit{};
}

void verify_remesh(const VerifyArguments& a, const Console& console) {
  check_has_magnitudes(a.start.graph);
  RemeshRequest request = a.request;
  request.mesh = a.start.mesh;
  request.reading = a.start.reading;
  request.field = a.start.graph;
  request.carries_properties = false;
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(a.threads);
  const LoadedInput loaded = load_surface(request, scheduler, progress);
  const auto budget = [&](std::uint64_t bytes) {
    progress.announce_memory(request.mesh.string(), bytes);
  };
  SurfaceComparison comparison;
  ReferenceRuntime reference(scheduler);
  Threads parallel(scheduler);
  PairedSurfaces pairs(reference, parallel, comparison);
  Remesh remesh;
  try {
    remesh = run(remesh_course(loaded, read_options(request, loaded, scheduler), pairs, progress,
                               budget))
                 .remesh;
  } catch (const Disagreement& difference) {
    throw std::runtime_error(std::string("the engines differ ") + difference.what());
  }
  progress.clear();
  if (console.wants_json())
    console.print_json(json_text(agreement(a, loaded, remesh, comparison, scheduler)));
  print_agreement(loaded, remesh, comparison);
  print_times(comparison.expected_seconds, comparison.tested_seconds, scheduler);
  if (remesh.interrupted) throw InterruptedExit{};
}

// Nothing that concerns seeds, graphs or the relaxation has a meaning for a remesh, and the other
// way round.
void refuse_others(const CLI::App& command, bool is_remesh) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    const std::string& group = option->get_group();
    const bool is_of_both = option->check_lname("vfield");
    const bool is_of_relaxation =
        !is_of_both && (group == "Seeds" || group == "Graph" || group == "Relaxation" ||
                        option->check_lname("frontier"));
    if (is_of_relaxation && is_remesh) {
      throw InvalidInput("--vertices and " + option->get_name() + " exclude each other");
    }
    const bool is_of_remesh = group == sizing_group || group == feature_group;
    if (is_of_remesh && !is_remesh) {
      throw InvalidInput(option->get_name() + " is of a remesh: give --vertices, too");
    }
  }
}

}  // namespace

void add_verify_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "verify", "Run both engines side by side and compare them at every step, node by node");
  const auto arguments = std::make_shared<VerifyArguments>();
  add_mesh_argument(*command, arguments->start.mesh);
  add_json_option(*command, console);
  add_vertices_option(*command, arguments->request.options.vertex_count,
                      "Verify a remesh with so many vertices instead of a relaxation");
  add_seed_options(*command, arguments->start.seeds, arguments->start.seed_file);
  add_graph_options(*command, arguments->start.graph);
  add_relaxation_options(*command, arguments->relaxation);
  add_frontier_option(*command, arguments->engine);
  add_size_file_options(*command, arguments->request);
  add_adapt_options(*command, arguments->request);
  add_feature_options(*command, arguments->request);
  add_feature_file_options(*command, arguments->request);
  add_thread_options(*command, arguments->threads);
  add_reading_options(*command, arguments->start.reading);
  command->footer(
      "If the engines differ, the first step, node and value is named, and the exit status is 1.\n"
      "Times are those of the engines' work.");
  command->callback([command, arguments, &console] {
    refuse_others(*command, arguments->request.options.vertex_count > 0);
    if (arguments->request.options.vertex_count > 0) {
      verify_remesh(*arguments, console);
    } else {
      verify_relaxation(*arguments, console);
    }
  });
}

}  // namespace geolloyd

#include "tools/cli/relax_arguments.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "geolloyd/errors.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/system/memory_limit.h"
#include "tools/words/mesh_files.h"
#include "tools/words/numbers.h"

namespace geolloyd {

void add_mesh_argument(CLI::App& command, std::filesystem::path& mesh) {
  command.add_option("MESH", mesh, input_mesh_text)->type_name("")->required();
}

namespace {

constexpr std::uint64_t most_32_bits = std::numeric_limits<std::uint32_t>::max();
constexpr const char* seed_group = "Seeds";
constexpr const char* graph_group = "Graph";
constexpr const char* relaxation_group = "Relaxation";
constexpr const char* thread_group = "Threads (they never change a result)";

Improvement parse_improvement(const std::string& text) {
  if (text.ends_with('s')) {
    const auto seconds = parse_number<double>(std::string_view(text).substr(0, text.size() - 1));
    if (seconds && std::isfinite(*seconds) && *seconds > 0) {
      return {RelaxationOptions::no_limit, *seconds};
    }
  } else if (const auto rounds = parse_number<std::uint32_t>(text)) {
    return {*rounds, std::numeric_limits<double>::infinity()};
  }
  throw InvalidInput("--improve " + text +
                     ": give a whole number of rounds, or seconds above 0 with an s, as 30s");
}

}  // namespace

void add_seed_options(CLI::App& command, SeedPlan& seeds, SeedFile& file) {
  whole_number(
      command.add_option("-k,--seeds", seeds.count, "Number of seeds; each has one region"), 1,
      most_32_bits)
      ->group(seed_group);
  CLI::Option* const file_option =
      command.add_option("--seeds-file", file.path,
                         "File of seeds to start from instead: one input id or three\n"
                         "coordinates per line, the seeds.csv of another run, or a mesh");
  file_option->type_name("FILE")->group(seed_group);
  add_choice(command, "--by", file.by, seeds_by_names,
             "Which columns of a seeds.csv count: id, or position for the nodes\n"
             "nearest to seeds of another mesh or graph; position for a mesh")
      ->needs(file_option)
      ->group(seed_group);
  add_init_options(command, seeds);
}

void add_init_options(CLI::App& command, SeedPlan& seeds) {
  add_choice(command, "--init", seeds.init, seed_init_names,
             "How to choose the first seeds. auto: coarse for few, surface for many,\n"
             "farthest for many on few nodes")
      ->group(seed_group);
  whole_number(command.add_option("--random-seed", seeds.random_seed,
                                  "Number that varies the choice of first seeds"),
               0)
      ->capture_default_str()
      ->group(seed_group);
}

void add_graph_options(CLI::App& command, GraphPlan& graph) {
  add_choice(command, "-g,--graph", graph.kind, graph_kind_names,
             "Nodes of the graph; dense graphs join more of them, and\n"
             "vertex-far adds geodesic shortcuts across up to five edges")
      ->group(graph_group);
  add_metric_options(command, graph);
}

namespace {

void check_averaging(const GraphPlan& graph) {
  if (graph.averaging && graph.vfield.empty()) {
    throw InvalidInput(
        "--averaging: of which tangent field? Give --vfield FILE, or --vfield curvature");
  }
  if (graph.averaging == Averaging::metric && graph.norm != Norm::geodesic) {
    throw InvalidInput(
        "--averaging metric: a metric knows lengths, but no axes for this --norm: give pairwise, "
        "or --norm geodesic");
  }
}

}  // namespace

void add_metric_options(CLI::App& command, GraphPlan& graph) {
  add_choice(command, "--norm", graph.norm, norm_names,
             "Norm of displacements; manhattan and linf use the axes of the\n"
             "tangent field or, without a field, of the coordinates")
      ->group(graph_group);
  command
      .add_option("--vfield", graph.vfield,
                  "Anisotropic metric: curvature, for the field of the surface's own\n"
                  "curvatures; cross, for smooth axes without magnitudes, as --norm\n"
                  "linf and manhattan want them; or a file: a line of column names,\n"
                  "then k1, k2 and two vectors per vertex")
      ->type_name("FILE|curvature|cross")
      ->group(graph_group);
  add_choice(command, "--averaging", graph.averaging, averaging_choice_names,
             "How tangent spaces of the field become one: as metrics, or by pairs\n"
             "of directions (the thesis). auto: metric with --norm geodesic")
      ->group(graph_group);
  command.parse_complete_callback([&graph] { check_averaging(graph); });
}

void add_relaxation_options(CLI::App& command, RelaxationArguments& relaxation) {
  add_choice(command, "--greedy", relaxation.greedy, greedy_choice_names,
             "Greedy phase before the precise phase: off, or its heuristic for\n"
             "neighbours. auto: extended from random and kmeans++ seeds and from\n"
             "files, else off")
      ->group(relaxation_group);
  command
      .add_flag("--no-microstep-skip", relaxation.no_microstep_skip,
                "Search regions again even if their seed stayed; slower, same result")
      ->group(relaxation_group);
  command
      .add_flag("--no-macrostep-skip", relaxation.no_macrostep_skip,
                "Move seeds even if the score of their region did not change")
      ->group(relaxation_group);
  command
      .add_option_function<std::string>(
          "--improve",
          [&relaxation](const std::string& text) {
            relaxation.improvement = parse_improvement(text);
          },
          "Then leave the local minimum for a lower one: so many rounds, as 20,\n"
          "or rounds for so many seconds, as 30s. The energy never rises")
      ->type_name("ROUNDS|SECONDSs")
      ->group(relaxation_group);
  add_limit_options(command, relaxation);
}

void add_limit_options(CLI::App& command, RelaxationArguments& relaxation) {
  whole_number(command.add_option("--max-greedy-steps", relaxation.max_greedy_steps,
                                  "Limit of steps in the greedy phase"),
               0, most_32_bits)
      ->group(relaxation_group);
  whole_number(command.add_option("--max-macrosteps", relaxation.max_macrosteps,
                                  "Limit of macrosteps in the precise phase"),
               0, most_32_bits)
      ->group(relaxation_group);
}

void add_engine_option(CLI::App& command, EngineKind& engine) {
  add_choice(command, "--engine", engine, engine_names,
             "parallel, or the sequential reference, which is slow and gives the\n"
             "same result");
}

void add_frontier_option(CLI::App& command, EngineArguments& engine) {
  add_choice(command, "--frontier", engine.frontier, frontier_names,
             "Search of the parallel engine: heap and delta start from scratch,\n"
             "regions repairs what has changed")
      ->group(thread_group);
}

void add_thread_options(CLI::App& command, ThreadArguments& threads) {
  whole_number(command.add_option("--threads", threads.count,
                                  "Number of threads (default: as many as can run at once)"),
               1, most_threads)
      ->group(thread_group);
  add_choice(command, "--backend", threads.backend, backend_names,
             "Threading library: oneTBB or OpenMP")
      ->group(thread_group);
}

void add_picture_options(CLI::App& command, PictureLook& picture) {
  const char* group = "Pictures";
  command
      .add_option_function<std::string>(
          "--view", [&picture](const std::string& text) { picture.view = parse_view(text); },
          "Camera direction: front, back, left, right, top, bottom, or\n"
          "AZIMUTH,ELEVATION in degrees; front looks along the shortest side")
      ->type_name("VIEW")
      ->default_str(fmt::format("{},{}", picture.view.azimuth, picture.view.elevation))
      ->group(group);
  command
      .add_option_function<std::string>(
          "--size", [&picture](const std::string& text) { picture.size = parse_size(text); },
          "WIDTH or WIDTHxHEIGHT in pixels; WIDTH alone is as high as the mesh\n"
          "needs")
      ->type_name("SIZE")
      ->default_str(std::to_string(picture.size.width))
      ->group(group);
}

void add_drop_option(CLI::App& command, bool& carries_properties) {
  command.add_flag("!--drop", carries_properties,
                   "Leave out colours, normals, texture coordinates, labels and all\n"
                   "other properties of the mesh, instead of carrying them over");
}

void add_dual_options(CLI::App& command, bool& manifold, DualVertices& vertices, bool& quads) {
  const char* group = "Dual";
  command
      .add_flag("--manifold,!--no-manifold", manifold,
                "Add vertices until the dual is a manifold with the input's\n"
                "topology (default: yes)")
      ->group(group);
  add_choice(command, "--dual-vertices", vertices, dual_vertices_names,
             "Places of the dual's vertices: the seeds, or the surface points\n"
             "nearest to the centroids of the ground truth's regions")
      ->group(group);
  command
      .add_flag("--quads", quads,
                "Join triangles of the dual to quadrilaterals, where their corners\n"
                "have 30 to 150 degrees; best with --norm linf --vfield cross")
      ->group(group);
}

void check_seeds(const SeedPlan& seeds, const SeedFile& file) {
  if (seeds.count == 0 && file.path.empty()) {
    throw InvalidInput("how many regions? Give --seeds N, or --seeds-file FILE");
  }
  if (seeds.count != 0 && !file.path.empty()) {
    throw InvalidInput("--seeds and --seeds-file exclude each other: the file says how many");
  }
}

RelaxationOptions relaxation_options(const SeedPlan& seeds, const SeedFile& file,
                                     const RelaxationArguments& a) {
  return {greedy_mode(a.greedy, !file.path.empty(), seeds.init),
          !a.no_microstep_skip,
          !a.no_macrostep_skip,
          a.max_greedy_steps,
          a.max_macrosteps,
          a.improvement.rounds,
          a.improvement.seconds};
}

Scheduler make_scheduler(const ThreadArguments& threads) {
  make_room_for_threads(threads.count);
  return Scheduler(threads.count, threads.backend);
}

}  // namespace geolloyd

#include <fmt/format.h>

#include <memory>

#include "core/components.h"
#include "core/errors.h"
#include "core/reference_engine.h"
#include "core/seed_file.h"
#include "core/seeds.h"
#include "core/tangent_field_file.h"
#include "tools/choice_option.h"
#include "tools/commands.h"
#include "tools/facts_text.h"
#include "tools/interrupt.h"
#include "tools/labels.h"
#include "tools/names.h"
#include "tools/picture.h"
#include "tools/progress.h"
#include "tools/relax_output.h"
#include "tools/report.h"
#include "tools/run_record.h"

namespace geolloyd {
namespace {

void add_seed_options(CLI::App& command, RelaxArguments& a) {
  const char* group = "Seeds";
  command.add_option("-k,--seeds", a.seeds, "Number of seeds, and so of regions")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("NUMBER")
      ->group(group);
  command
      .add_option("--seeds-file", a.seeds_file,
                  "Start from these seeds instead: an input id or three coordinates\n"
                  "a line, or the seeds.csv of another run")
      ->type_name("FILE")
      ->group(group);
  one_of(command.add_option("--init", a.init, "How to choose the first seeds"), seed_init_names)
      ->capture_default_str()
      ->group(group);
  command.add_option("--random-seed", a.random_seed, "Other numbers give other first seeds")
      ->type_name("NUMBER")
      ->capture_default_str()
      ->group(group);
}

void add_graph_options(CLI::App& command, RelaxArguments& a) {
  const char* group = "Graph";
  one_of(command.add_option("-g,--graph", a.graph,
                            "What the nodes are, and how densely they are joined"),
         graph_kind_names)
      ->capture_default_str()
      ->group(group);
  one_of(command.add_option("--norm", a.norm,
                            "How displacements are measured: manhattan and linf along the\n"
                            "tangent field or, without one, along the axes of the coordinates"),
         norm_names)
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--vfield", a.vfield,
                  "Tangent field for an anisotropic metric: after a line of column\n"
                  "names k1, k2 and two vectors per vertex")
      ->type_name("FILE")
      ->group(group);
}

void add_relaxation_options(CLI::App& command, RelaxArguments& a) {
  const char* group = "Relaxation";
  one_of(
      command.add_option("--greedy", a.greedy, "How the greedy phase judges a seed's neighbours"),
      greedy_mode_names)
      ->capture_default_str()
      ->group(group);
  command
      .add_flag("--no-microstep-skip", a.no_microstep_skip,
                "Search regions again even if their seed stayed: slower, same result")
      ->group(group);
  command
      .add_flag("--no-macrostep-skip", a.no_macrostep_skip,
                "Move seeds even if the score of their region did not change")
      ->group(group);
  command.add_option("--max-greedy-steps", a.max_greedy_steps, "End the greedy phase after these")
      ->type_name("NUMBER")
      ->group(group);
  command.add_option("--max-macrosteps", a.max_macrosteps, "End the precise phase after these")
      ->type_name("NUMBER")
      ->group(group);
}

void check_arguments(const RelaxArguments& a) {
  if (a.seeds == 0 && a.seeds_file.empty()) {
    throw InvalidInput("how many regions? Give --seeds N, or --seeds-file FILE");
  }
  if (a.seeds != 0 && !a.seeds_file.empty()) {
    throw InvalidInput("--seeds and --seeds-file exclude each other: the file says how many");
  }
}

RelaxationOptions relaxation_options(const RelaxArguments& a) {
  return {value_of(greedy_mode_names, a.greedy), !a.no_microstep_skip, !a.no_macrostep_skip,
          a.max_greedy_steps, a.max_macrosteps};
}

// Edges are arcs to be, so finding them counts as building the graph.
MeshEdges load(RunRecord& run) {
  const Stopwatch watch;
  run.input = read_mesh(run.arguments.mesh);
  const Stopwatch finding;
  MeshEdges edges = find_edges(run.input.mesh);
  run.seconds.graph = finding.seconds();
  run.facts = check_mesh(run.input.mesh, edges);
  run.seconds.load = watch.seconds() - run.seconds.graph;
  return edges;
}

void build_graph(RunRecord& run, const MeshEdges& edges) {
  const Stopwatch watch;
  const RelaxArguments& a = run.arguments;
  MeshGraphOptions options{value_of(graph_kind_names, a.graph), value_of(norm_names, a.norm), {}};
  if (!a.vfield.empty()) {
    options.vertex_space = read_tangent_field(a.vfield, run.input.mesh.vertex_count());
  }
  run.mesh_graph = make_mesh_graph(run.input.mesh, edges, options);
  run.seconds.graph += watch.seconds();
}

std::vector<NodeId> first_seeds(RunRecord& run) {
  const Stopwatch watch;
  const RelaxArguments& a = run.arguments;
  const Components components = connected_components(run.mesh_graph.graph);
  run.components = components.size();
  std::vector<NodeId> seeds =
      a.seeds_file.empty() ? choose_seeds(run.mesh_graph.graph, components,
                                          value_of(seed_init_names, a.init), a.seeds, a.random_seed)
                           : read_seed_file(a.seeds_file, run.mesh_graph, components);
  run.seconds.seeds = watch.seconds();
  return seeds;
}

void relax_seeds(RunRecord& run, std::vector<NodeId> seeds, ProgressLine& progress) {
  const Stopwatch watch;
  const Graph& graph = run.mesh_graph.graph;
  const std::size_t count = seeds.size();
  const auto engine = make_reference_engine(graph);
  run.relaxation = relax(graph, *engine, std::move(seeds), relaxation_options(run.arguments),
                         [&](const Progress& p) {
                           progress.show(p, count);
                           return !interrupted();
                         });
  run.seconds.relax = watch.seconds();
}

const char* describe(End end) {
  switch (end) {
    case End::converged:
      return "converged";
    case End::interrupted:
      return "INTERRUPTED, best state so far,";
    case End::limit:
      return "stopped at the limit of macrosteps, best state so far,";
    case End::recurred:
      return "STOPPED, the seeds came back to an earlier state; the best state";
  }
  return "";
}

void print_summary(const RunRecord& run) {
  const Relaxation& result = run.relaxation;
  const StepCounts steps = count_steps(result);
  const Graph& graph = run.mesh_graph.graph;
  const double hexagonal = hexagonal_energy(run);
  const StageSeconds& s = run.seconds;
  fmt::print("{}\n{}", run.arguments.mesh.string(), describe(run.input, run.facts));
  fmt::print("  {:<12}{}: {}, {}, {}\n", "graph", run.arguments.graph,
             counted(graph.node_count(), "node", "nodes"),
             counted(graph.arc_count(), "arc", "arcs"),
             counted(run.components, "component", "components"));
  fmt::print(
      "  {:<12}{} from {}\n", "seeds", grouped(run.regions.size()),
      run.arguments.seeds_file.empty() ? run.arguments.init : run.arguments.seeds_file.string());
  fmt::print("  {:<12}{} after {}, {} of {}\n", "relaxation", describe(result.end),
             counted(steps.greedy, "greedy step", "greedy steps"),
             counted(steps.macro, "macrostep", "macrosteps"),
             counted(steps.micro, "microstep", "microsteps"));
  fmt::print("  {:<12}{:.8g} -> {:.8g}{}\n", "energy", initial_energy(result), result.energy,
             hexagonal > 0
                 ? fmt::format(", {:.5g} of a regular hexagonal tiling", result.energy / hexagonal)
                 : "");
  fmt::print("  {:<12}{}\n", "fingerprint", fingerprint_text(result.fingerprint));
  fmt::print(
      "  {:<12}{:.2f} s: load {:.2f}, graph {:.2f}, seeds {:.2f}, relaxation {:.2f}, write {:.2f}; "
      "{:.0f} MB\n",
      "time", s.total, s.load, s.graph, s.seeds, s.relax, s.write,
      static_cast<double>(run.peak_memory_bytes) * 1e-6);
  fmt::print("  {:<12}{}/: tessellation.ply seeds.csv regions.csv report.json\n", "written",
             run.arguments.output.string());
  if (!run.arguments.picture.empty()) {
    fmt::print("  {:<12}{}\n", "", run.arguments.picture.string());
  }
}

void run_relax(const RelaxArguments& arguments) {
  check_arguments(arguments);
  const Stopwatch total;
  RunRecord run;
  run.arguments = arguments;
  ProgressLine progress;
  progress.stage("reading " + arguments.mesh.string());
  {
    const MeshEdges edges = load(run);
    progress.stage("building the " + arguments.graph + " graph");
    build_graph(run, edges);
  }
  progress.stage("choosing seeds");
  std::vector<NodeId> seeds = first_seeds(run);
  catch_interrupts();  // before the folder appears, which tells others that it is done
  prepare_output(arguments);
  relax_seeds(run, std::move(seeds), progress);

  progress.stage("writing " + arguments.output.string());
  const Stopwatch writing;
  run.regions = summarise_regions(run.mesh_graph.graph, run.relaxation.partition,
                                  run.relaxation.seeds, run.relaxation.region_score);
  run.labels = label_input_ids(run);
  write_results(run);
  run.seconds.write = writing.seconds();
  run.seconds.total = total.seconds();
  run.peak_memory_bytes = peak_memory_bytes();
  write_report(run);
  if (!arguments.picture.empty()) {
    progress.stage("drawing " + arguments.picture.string());
    write_picture(arguments.picture, run);
  }
  progress.clear();
  print_summary(run);
  if (run.relaxation.end == End::interrupted) throw InterruptedExit{};
}

}  // namespace

void add_relax_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "relax", "Tessellate a mesh: move seeds to the centroids of their regions");
  const auto arguments = std::make_shared<RelaxArguments>();
  command->add_option("MESH", arguments->mesh, "PLY, OBJ, OFF or STL file")
      ->type_name("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "Folder for tessellation.ply, seeds.csv, regions.csv, report.json")
      ->type_name("FOLDER")
      ->required();
  command->add_option("--picture", arguments->picture, "PNG file to draw the result into")
      ->type_name("FILE");
  add_seed_options(*command, *arguments);
  add_graph_options(*command, *arguments);
  add_relaxation_options(*command, *arguments);
  command->footer(
      "Ctrl-C ends the work after the current step and writes the best result so far.\n"
      "To go on from there: --seeds-file DIR/seeds.csv");
  command->callback([arguments] { run_relax(*arguments); });
}

}  // namespace geolloyd

#include "tools/cli/relax_arguments.h"

#include "core/base/errors.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/number_option.h"
#include "tools/render/view.h"
#include "tools/words/names.h"

namespace geolloyd {

void add_mesh_argument(CLI::App& command, RelaxArguments& a) {
  command.add_option("MESH", a.mesh, "PLY, OBJ, OFF or STL file")->type_name("")->required();
}

namespace {

constexpr std::uint64_t most_32_bits = std::numeric_limits<std::uint32_t>::max();
constexpr const char* seed_group = "Seeds";
constexpr const char* graph_group = "Graph";
constexpr const char* relaxation_group = "Relaxation";
constexpr const char* thread_group = "Threads (they never change a result)";

}  // namespace

void add_seed_options(CLI::App& command, RelaxArguments& a) {
  whole_number(command.add_option("-k,--seeds", a.seeds, "Number of seeds, and so of regions"), 1,
               most_32_bits)
      ->group(seed_group);
  command
      .add_option("--seeds-file", a.seeds_file,
                  "Start from these seeds instead: an input id or three coordinates\n"
                  "a line, or the seeds.csv of another run")
      ->type_name("FILE")
      ->group(seed_group);
  add_init_options(command, a);
}

void add_init_options(CLI::App& command, RelaxArguments& a) {
  one_of(command.add_option("--init", a.init, "How to choose the first seeds"), seed_init_names)
      ->capture_default_str()
      ->group(seed_group);
  whole_number(
      command.add_option("--random-seed", a.random_seed, "Other numbers give other first seeds"), 0)
      ->capture_default_str()
      ->group(seed_group);
}

void add_graph_options(CLI::App& command, RelaxArguments& a) {
  one_of(command.add_option("-g,--graph", a.graph,
                            "What the nodes are, and how densely they are joined"),
         graph_kind_names)
      ->capture_default_str()
      ->group(graph_group);
  add_metric_options(command, a);
}

void add_metric_options(CLI::App& command, RelaxArguments& a) {
  one_of(command.add_option("--norm", a.norm,
                            "How displacements are measured: manhattan and linf along the\n"
                            "tangent field or, without one, along the axes of the coordinates"),
         norm_names)
      ->capture_default_str()
      ->group(graph_group);
  command
      .add_option("--vfield", a.vfield,
                  "Tangent field for an anisotropic metric: after a line of column\n"
                  "names k1, k2 and two vectors per vertex")
      ->type_name("FILE")
      ->group(graph_group);
}

void add_relaxation_options(CLI::App& command, RelaxArguments& a) {
  one_of(command.add_option("--greedy", a.greedy,
                            "Greedy phase before the precise one: off, or how it judges a seed's\n"
                            "neighbours. auto: off from farthest-point seeds, else extended"),
         greedy_choice_names)
      ->capture_default_str()
      ->group(relaxation_group);
  command
      .add_flag("--no-microstep-skip", a.no_microstep_skip,
                "Search regions again even if their seed stayed: slower, same result")
      ->group(relaxation_group);
  command
      .add_flag("--no-macrostep-skip", a.no_macrostep_skip,
                "Move seeds even if the score of their region did not change")
      ->group(relaxation_group);
  add_limit_options(command, a);
}

void add_limit_options(CLI::App& command, RelaxArguments& a) {
  whole_number(command.add_option("--max-greedy-steps", a.max_greedy_steps,
                                  "End the greedy phase after these"),
               0, most_32_bits)
      ->group(relaxation_group);
  whole_number(
      command.add_option("--max-macrosteps", a.max_macrosteps, "End the precise phase after these"),
      0, most_32_bits)
      ->group(relaxation_group);
}

void add_engine_option(CLI::App& command, RelaxArguments& a) {
  one_of(command.add_option("--engine", a.engine,
                            "parallel, or the sequential reference: slow, the same result"),
         engine_names)
      ->capture_default_str();
}

void add_thread_options(CLI::App& command, RelaxArguments& a) {
  one_of(command.add_option("--frontier", a.frontier,
                            "How the parallel engine finds regions: heap and delta from\n"
                            "scratch, regions only where something changed"),
         frontier_names)
      ->capture_default_str()
      ->group(thread_group);
  add_scheduler_options(command, a);
}

void add_scheduler_options(CLI::App& command, RelaxArguments& a) {
  whole_number(
      command.add_option("--threads", a.threads, "How many (default: all the machine has)"), 1,
      most_threads)
      ->group(thread_group);
  one_of(command.add_option("--backend", a.backend, "Whose threads: oneTBB's or OpenMP's"),
         backend_names)
      ->capture_default_str()
      ->group(thread_group);
}

void add_picture_options(CLI::App& command, RelaxArguments& a) {
  const char* group = "Pictures";
  command
      .add_option("--view", a.view,
                  "From where: front, back, left, right, top, bottom, or\n"
                  "AZIMUTH,ELEVATION in degrees; front is along the shortest side")
      ->type_name("VIEW")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--size", a.size, "WIDTH, as high as the mesh needs it, or WIDTHxHEIGHT, pixels")
      ->type_name("SIZE")
      ->capture_default_str()
      ->group(group);
}

void add_remesh_options(CLI::App& command, RelaxArguments& a) {
  const char* group = "Remesh";
  command
      .add_flag("--manifold,!--no-manifold", a.manifold,
                "Add seeds to it until it is a manifold of the input's topology\n"
                "(default: yes)")
      ->group(group);
  one_of(command.add_option("--remesh-vertices", a.remesh_vertices,
                            "Where its vertices are: at the seeds, or on the surface where the\n"
                            "centroids of the ground truth's regions are nearest"),
         remesh_vertices_names)
      ->capture_default_str()
      ->group(group);
}

void check_arguments(const RelaxArguments& a) {
  if (a.seeds == 0 && a.seeds_file.empty()) {
    throw InvalidInput("how many regions? Give --seeds N, or --seeds-file FILE");
  }
  if (a.seeds != 0 && !a.seeds_file.empty()) {
    throw InvalidInput("--seeds and --seeds-file exclude each other: the file says how many");
  }
  parse_view(a.view);
  parse_size(a.size);
}

namespace {

// Of seeds from a file nobody knows how they were chosen.
GreedyMode greedy_mode(const RelaxArguments& a) {
  const std::optional<GreedyMode> asked = value_of(greedy_choice_names, a.greedy);
  if (asked) return *asked;
  return a.seeds_file.empty() ? suggested_greedy_mode(value_of(seed_init_names, a.init))
                              : GreedyMode::extended;
}

}  // namespace

RelaxationOptions relaxation_options(const RelaxArguments& a) {
  return {greedy_mode(a), !a.no_microstep_skip, !a.no_macrostep_skip, a.max_greedy_steps,
          a.max_macrosteps};
}

}  // namespace geolloyd

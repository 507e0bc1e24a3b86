#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>

#include "core/course/run_plan.h"
#include "core/lloyd/relaxation.h"
#include "parallel/threads/scheduler.h"
#include "tools/cli/cli_fwd.h"
#include "tools/render/view.h"
#include "tools/words/names.h"

namespace geolloyd {

// What the command line of `relax` and of its relatives says, by what it concerns.

/// Which of both limits ends it; by default it takes no round.
struct Improvement {
  std::uint32_t rounds = 0;
  double seconds = std::numeric_limits<double>::infinity();
};

struct RelaxationArguments {
  std::optional<GreedyMode> greedy;  ///< empty: goes by how the first seeds are chosen
  bool no_microstep_skip = false;
  bool no_macrostep_skip = false;
  std::uint32_t max_greedy_steps = RelaxationOptions::no_limit;
  std::uint32_t max_macrosteps = RelaxationOptions::no_limit;
  Improvement improvement;
};

struct EngineArguments {
  EngineKind kind = EngineKind::parallel;
  Frontier frontier = Frontier::automatic;  ///< of the parallel engine
};

struct ThreadArguments {
  std::size_t count = 0;  ///< 0: all the machine has
  Backend backend = Backend::tbb;
};

void add_mesh_argument(CLI::App& command, std::filesystem::path& mesh);
void add_seed_options(CLI::App& command, SeedPlan& seeds, SeedFile& file);  // with the next line's
void add_init_options(CLI::App& command, SeedPlan& seeds);                  // how, not how many
void add_graph_options(CLI::App& command, GraphPlan& graph);  // with those of the next line
/// Options that contradict each other are refused when all are read.
void add_metric_options(CLI::App& command, GraphPlan& graph);
/// Adds the options of the next line, too.
void add_relaxation_options(CLI::App& command, RelaxationArguments& relaxation);
void add_limit_options(CLI::App& command, RelaxationArguments& relaxation);
void add_engine_option(CLI::App& command, EngineKind& engine);
void add_frontier_option(CLI::App& command, EngineArguments& engine);
void add_thread_options(CLI::App& command, ThreadArguments& threads);
void add_dual_options(CLI::App& command, bool& manifold, DualVertices& vertices, bool& quads);
void add_picture_options(CLI::App& command, PictureLook& picture);
/// --drop: then `carries_properties` becomes false.
void add_drop_option(CLI::App& command, bool& carries_properties);

/// Throws InvalidInput where options contradict each other.
void check_seeds(const SeedPlan& seeds, const SeedFile& file);
/// The options in force: --greedy auto goes by the seeds.
RelaxationOptions relaxation_options(const SeedPlan& seeds, const SeedFile& file,
                                     const RelaxationArguments& relaxation);

/// The threads that the command line asks for.
Scheduler make_scheduler(const ThreadArguments& threads);

}  // namespace geolloyd

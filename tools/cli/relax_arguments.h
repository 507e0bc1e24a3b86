#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "tools/cli/cli_fwd.h"
#include "tools/cli/repair_arguments.h"
#include "tools/render/view.h"
#include "tools/words/names.h"

namespace geolloyd {

// What the command line of `relax` and of its relatives says, by what it concerns.

/// The first seeds: a number of them to choose, or a file.
struct SeedArguments {
  std::size_t count = 0;  ///< 0: not given
  std::filesystem::path file;
  SeedsBy by = SeedsBy::id;  ///< of the file
  SeedInit init = SeedInit::automatic;
  std::uint64_t random_seed = 1;
};

/// A tangent field.
struct FieldArguments {
  std::filesystem::path vfield;  ///< or the word for one of the surface's own fields; empty: none

  /// A file of that name is ./curvature, or ./cross.
  [[nodiscard]] bool has_curvature_field() const { return vfield == "curvature"; }
  [[nodiscard]] bool has_cross_field() const { return vfield == "cross"; }
  /// Empty where the field is none or the surface's own.
  [[nodiscard]] std::filesystem::path field_file() const {
    return has_curvature_field() || has_cross_field() ? std::filesystem::path() : vfield;
  }
};

struct GraphArguments : FieldArguments {
  GraphKind kind = GraphKind::vertex;
  Norm norm = Norm::geodesic;
  std::optional<Averaging> averaging;  ///< empty: goes by the norm
};

/// What a tessellation begins with.
struct StartArguments {
  std::filesystem::path mesh;
  RepairArguments repair;
  SeedArguments seeds;
  GraphArguments graph;
  bool has_properties = false;  ///< those of the mesh are read, too

  /// The files that are read, some of them empty: no result may replace one.
  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    return {mesh, graph.field_file(), seeds.file};
  }
};

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

struct DualArguments {
  bool manifold = true;
  DualVertices vertices = DualVertices::seeds;
  bool quads = false;
};

using PictureArguments = PictureLook;

/// All of `relax`.
struct RelaxArguments {
  StartArguments start;
  RelaxationArguments relaxation;
  EngineArguments engine;
  ThreadArguments threads;
  DualArguments dual;
  PictureArguments picture;
  std::filesystem::path output;                                   ///< a folder
  std::vector<RelaxOutput> only = values_of(relax_output_names);  ///< what goes there
  std::filesystem::path picture_file;                             ///< empty: none
  std::filesystem::path frames;                                   ///< a folder; empty: none
  std::filesystem::path page_file;                                ///< empty: none
  std::filesystem::path vtp_file;                                 ///< empty: none
  bool ground_truth = false;
  double checkpoint_seconds = 60;  ///< between two of them
  bool resume = false;

  [[nodiscard]] bool writes(RelaxOutput what) const {
    return std::find(only.begin(), only.end(), what) != only.end();
  }
  /// The report tells of it, too.
  [[nodiscard]] bool makes_dual() const {
    return writes(RelaxOutput::dual) || writes(RelaxOutput::report);
  }
};

void add_mesh_argument(CLI::App& command, StartArguments& start);
void add_seed_options(CLI::App& command, SeedArguments& seeds);    // with those of the next line
void add_init_options(CLI::App& command, SeedArguments& seeds);    // how, not how many
void add_graph_options(CLI::App& command, GraphArguments& graph);  // with those of the next line
/// Options that contradict each other are refused when all are read.
void add_metric_options(CLI::App& command, GraphArguments& graph);
/// Adds the options of the next line, too.
void add_relaxation_options(CLI::App& command, RelaxationArguments& relaxation);
void add_limit_options(CLI::App& command, RelaxationArguments& relaxation);
void add_engine_option(CLI::App& command, EngineKind& engine);
void add_frontier_option(CLI::App& command, EngineArguments& engine);
void add_thread_options(CLI::App& command, ThreadArguments& threads);
void add_dual_options(CLI::App& command, DualArguments& dual);
void add_picture_options(CLI::App& command, PictureArguments& picture);
/// --drop: then `carries_properties` becomes false.
void add_drop_option(CLI::App& command, bool& carries_properties);

/// Throws InvalidInput where options contradict each other.
void check_seeds(const SeedArguments& seeds);
/// For runs that are to be alike. Throws InvalidInput where seconds limit the improvement.
void check_same_course(const RelaxationArguments& relaxation);
/// The options in force: --greedy auto goes by the seeds.
RelaxationOptions relaxation_options(const SeedArguments& seeds,
                                     const RelaxationArguments& relaxation);

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/lloyd/relaxation.h"
#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Of --threads: each has memory of its own to work in.
inline constexpr int most_threads = 1024;

/// What the command line of `relax`, and of its relatives, says, in its own words (names.h).
struct RelaxArguments {
  std::filesystem::path mesh;
  std::filesystem::path output;
  std::filesystem::path picture;
  bool manifold = true;
  std::string remesh_vertices = "seeds";
  std::filesystem::path frames;  ///< a folder
  std::string view = "25,15";
  std::string size = "1280";
  bool ground_truth = false;
  double checkpoint_seconds = 60;  ///< between two of them
  bool resume = false;
  std::size_t seeds = 0;  ///< 0: not given
  std::filesystem::path seeds_file;
  std::string init = "farthest";
  std::uint64_t random_seed = 1;
  std::string graph = "vertex";
  std::string norm = "geodesic";
  std::filesystem::path vfield;
  std::string greedy = "auto";
  bool no_microstep_skip = false;
  bool no_macrostep_skip = false;
  std::uint32_t max_greedy_steps = RelaxationOptions::no_limit;
  std::uint32_t max_macrosteps = RelaxationOptions::no_limit;
  std::string engine = "parallel";
  std::string frontier = "auto";
  std::size_t threads = 0;  ///< 0: all the machine has
  std::string backend = "tbb";
};

void add_mesh_argument(CLI::App& command, RelaxArguments& a);
void add_seed_options(CLI::App& command, RelaxArguments& a);   // with those of the next line
void add_init_options(CLI::App& command, RelaxArguments& a);   // how, not how many
void add_graph_options(CLI::App& command, RelaxArguments& a);  // with those of the next line
void add_metric_options(CLI::App& command, RelaxArguments& a);
void add_relaxation_options(CLI::App& command, RelaxArguments& a);  // with those of the next line
void add_limit_options(CLI::App& command, RelaxArguments& a);
void add_engine_option(CLI::App& command, RelaxArguments& a);
void add_thread_options(CLI::App& command, RelaxArguments& a);  // with those of the next line
void add_scheduler_options(CLI::App& command, RelaxArguments& a);
void add_remesh_options(CLI::App& command, RelaxArguments& a);
void add_picture_options(CLI::App& command, RelaxArguments& a);  // how pictures look

/// Throws InvalidInput where options contradict each other.
void check_arguments(const RelaxArguments& a);
RelaxationOptions relaxation_options(const RelaxArguments& a);

}  // namespace geolloyd

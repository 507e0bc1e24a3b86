#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/relax_arguments.h"
#include "tools/files/json.h"
#include "tools/files/output_folder.h"
#include "tools/system/progress.h"

namespace geolloyd {

// What the commands that measure have in common: NAME.json, NAME.csv and pictures in a folder.

/// Where a command that measures writes its results, and whether it draws them.
struct ExperimentOutput {
  std::filesystem::path folder;  ///< empty: nothing is written
  bool no_plot = false;
};

/// Adds --output, --json and --no-plot to the command that writes NAME.json and NAME.csv.
void add_output_options(CLI::App& command, ExperimentOutput& output, const std::string& name,
                        Console& console);

/// For runs that are to be alike. Throws InvalidInput where seconds limit the improvement.
void check_same_course(const RelaxationArguments& relaxation);

/// Makes sure that the files can be written and would replace no input.
[[nodiscard]] MadeFolders prepare_output(const ExperimentOutput& output, const std::string& name,
                                         const RunRequest& request);

/// Writes NAME.csv, which holds `rows`, and NAME.json. May be called again with more.
void save_result(const ExperimentOutput& output, const std::string& name, const Json& rows,
                 const Json& result);

/// Prints the result where --json asks for it, says what was written and draws it. Says so, too, if
/// an interrupt came.
void finish_experiment(const ExperimentOutput& output, const std::string& name, const Json& result,
                       const Console& console);

/// Leaves the first of equals.
template <class Value>
void drop_repeats(std::vector<Value>& list) {
  std::vector<Value> kept;
  for (const auto& value : list) {
    if (std::find(kept.begin(), kept.end(), value) == kept.end()) kept.push_back(value);
  }
  list = std::move(kept);
}

/// Says on the terminal how far a relaxation is, and ends it when an interrupt came.
ProgressCallback watcher(ProgressLine& progress, std::size_t seeds);

/// "1.35 s", "24.5 ms".
std::string duration_text(double seconds);

}  // namespace geolloyd

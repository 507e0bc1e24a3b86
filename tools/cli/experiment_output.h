#pragma once

#include <filesystem>
#include <string>

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Where a command that measures writes its results, and whether it draws them.
struct ExperimentOutput {
  std::filesystem::path folder;  ///< empty: nothing is written
  bool no_plot = false;
};

/// Adds --output, --json and --no-plot to the command that writes NAME.json and NAME.csv.
void add_output_options(CLI::App& command, ExperimentOutput& output, const std::string& name);

}  // namespace geolloyd

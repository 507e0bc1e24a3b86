#include "tools/cli/experiment_output.h"

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "tools/cli/folder_option.h"
#include "tools/cli/summary_options.h"

namespace geolloyd {

void add_output_options(CLI::App& command, ExperimentOutput& output, const std::string& name) {
  folder_name(command.add_option("-o,--output", output.folder,
                                 fmt::format("Folder for {0}.json, {0}.csv and pictures", name)));
  add_json_option(command);
  command.add_flag("--no-plot", output.no_plot, "Draw no pictures (they need python3-matplotlib)");
}

}  // namespace geolloyd

#include "tools/laboratory/experiment.h"

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <system_error>

#include "geolloyd/errors.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/summary_options.h"
#include "tools/files/csv.h"
#include "tools/files/file_group.h"
#include "tools/laboratory/plot.h"
#include "tools/system/interrupt.h"

namespace geolloyd {

void add_output_options(CLI::App& command, ExperimentOutput& output, const std::string& name,
                        Console& console) {
  folder_name(command.add_option("-o,--output", output.folder,
                                 fmt::format("Folder for {0}.json, {0}.csv and pictures", name)));
  add_json_option(command, console);
  command.add_flag("--no-plot", output.no_plot, "Draw no pictures (they need python3-matplotlib)");
}

void check_same_course(const RelaxationArguments& relaxation) {
  if (std::isfinite(relaxation.improvement.seconds)) {
    throw InvalidInput(
        "--improve with a limit in seconds: runs are compared, and each would end elsewhere: give "
        "a number of rounds");
  }
}

MadeFolders prepare_output(const ExperimentOutput& output, const std::string& name,
                           const RunRequest& request) {
  if (output.folder.empty()) return {};
  const std::string json = name + ".json";
  const std::string csv = name + ".csv";
  const std::array names = {json.c_str(), csv.c_str()};
  return prepare_folder(output.folder, names, request.files());
}

void save_result(const ExperimentOutput& output, const std::string& name, const Json& rows,
                 const Json& result) {
  if (output.folder.empty()) return;
  const std::array texts = {csv_text(rows), json_text(result)};
  const std::string csv = name + ".csv";
  const std::string json = name + ".json";
  FileGroup files(output.folder, std::array{csv.c_str(), json.c_str()});
  for (std::size_t i = 0; i < texts.size(); ++i) files[i].text(texts[i]);
  files.commit();
}

void finish_experiment(const ExperimentOutput& output, const std::string& name, const Json& result,
                       const Console& console) {
  if (console.wants_json()) console.print_json(json_text(result));
  if (interrupted()) fmt::print("\nINTERRUPTED: this is only a part\n");
  const std::filesystem::path json = output.folder / (name + ".json");
  std::error_code error;
  if (output.folder.empty() || !std::filesystem::exists(json, error)) return;
  fmt::print("\n{}\n{}\n", (output.folder / (name + ".csv")).string(), json.string());
  if (!output.no_plot) draw_plot(json);
}

ProgressCallback watcher(ProgressLine& progress, std::size_t seeds) {
  return [&progress, seeds](const Progress& p) {
    progress.show(p, seeds);
    return !interrupted();
  };
}

std::string duration_text(double seconds) {
  if (seconds < 1) return fmt::format("{:.4g} ms", seconds * 1e3);
  return seconds < 1000 ? fmt::format("{:.4g} s", seconds) : fmt::format("{:.0f} s", seconds);
}

}  // namespace geolloyd

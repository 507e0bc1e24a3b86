#include "tools/experiments/experiment.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <system_error>

#include "tools/experiments/plot.h"
#include "tools/files/csv.h"
#include "tools/files/file_group.h"
#include "tools/files/output_folder.h"
#include "tools/system/interrupt.h"
#include "tools/system/machine.h"
#include "tools/system/summary.h"
#include "tools/words/facts_text.h"

namespace geolloyd {

void prepare_output(const ExperimentOutput& output, const std::string& name,
                    const RunRequest& request) {
  if (output.folder.empty()) return;
  const std::string json = name + ".json";
  const std::string csv = name + ".csv";
  const std::array names = {json.c_str(), csv.c_str()};
  prepare_folder(output.folder, names, request.files());
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

void finish_experiment(const ExperimentOutput& output, const std::string& name,
                       const Json& result) {
  if (wants_json()) print_json(json_text(result));
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

void print_heading(const PreparedInput& start) {
  const Graph& graph = start.mesh_graph.graph;
  fmt::print("{}: {} graph, {}, {}, {}\n", start.input.file.string(),
             name_of(graph_kind_names, start.mesh_graph.kind),
             counted(graph.node_count(), "node", "nodes"),
             counted(graph.arc_count(), "arc", "arcs"),
             counted(start.seeds.size(), "seed", "seeds"));
  if (start.seed_fit) fmt::print("{}", describe(*start.seed_fit, start.input.facts));
  print_machine();
}

void print_machine() {
  const Machine machine = this_machine();
  fmt::print("{}, {} at once, {}\n\n", machine.processor,
             counted(machine.threads, "thread", "threads"), machine.compiler);
}

}  // namespace geolloyd

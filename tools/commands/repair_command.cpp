#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_formats.h"
#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "core/properties/properties.h"
#include "core/repair/crossings.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/cli/repair_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/csv.h"
#include "tools/files/file_group.h"
#include "tools/files/mesh_target.h"
#include "tools/files/output_folder.h"
#include "tools/report/issues_output.h"
#include "tools/report/report_parts.h"
#include "tools/run/input.h"
#include "tools/run/memory_need.h"
#include "tools/run/stages.h"
#include "tools/system/build_facts.h"
#include "tools/system/memory_limit.h"
#include "tools/system/progress.h"
#include "tools/words/facts_text.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

struct RepairCommandArguments {
  std::filesystem::path mesh;
  MeshReading reading;
  RepairArguments repair;
  ThreadArguments threads;
  MeshTarget output;
  std::filesystem::path map_file;     // empty: none
  std::filesystem::path issues_file;  // empty: none
  std::filesystem::path report_file;  // empty: none

  // Those beside the repaired mesh.
  [[nodiscard]] std::vector<std::filesystem::path> other_outputs() const {
    std::vector<std::filesystem::path> files;
    for (const auto& file : {map_file, issues_file, report_file}) {
      if (!file.empty()) files.push_back(file);
    }
    return files;
  }
};

void prepare_targets(RepairCommandArguments& arguments, Console& console) {
  std::vector<std::filesystem::path> others = {arguments.mesh};
  prepare_target(arguments.output, arguments.reading.format, others, console);
  others.push_back(arguments.output.file);
  for (const auto& file : arguments.other_outputs()) {
    check_target(file, others);
    others.push_back(file);
  }
}

void write_origins(const RepairedMesh& repaired, FileWriter& out) {
  out.text("vertex,input_vertex\n");
  for (std::size_t v = 0; v < repaired.vertex_origin.size(); ++v)
    write_row(out, v, repaired.vertex_origin[v]);
}

void run_repair(RepairCommandArguments& arguments, Console& console) {
  prepare_targets(arguments, console);
  const Stopwatch total;
  ProgressLine progress(console);
  Scheduler scheduler = make_scheduler(arguments.threads);
  progress.stage("reading " + arguments.mesh.string());
  const Input given = load_input(arguments.mesh, scheduler, {true, arguments.reading}).input;
  progress.announce_memory(arguments.mesh.string(), bytes_to_repair(size_of(given.loaded)));
  progress.stage("repairing");
  const Stopwatch watch;
  RepairedMesh repaired = make_repaired_mesh(given.mesh(), arguments.repair.options, scheduler);
  repaired.repairs = without_welded(repaired.repairs, given.loaded);
  const double seconds = watch.seconds();
  const MeshEdges edges = find_edges(repaired.mesh, scheduler);
  const MeshFacts facts = check_mesh(repaired.mesh, edges, scheduler);
  const MeshTopology topology = find_topology(repaired.mesh, edges);
  const std::vector<TrianglePair> crossings = find_crossings(repaired.mesh, scheduler);

  progress.stage("writing " + arguments.output.name());
  const std::vector<std::filesystem::path> others = arguments.other_outputs();
  FileGroup files(arguments.output, others);
  Properties carried = follow_origins(given.loaded.properties, repaired.mesh,
                                      repaired.vertex_origin, repaired.triangle_origin);
  const MeshFormat format = format_to_write(arguments.output);
  keep_writable(format, carried);
  write(files[0], format, repaired.mesh, carried);
  if (!arguments.map_file.empty()) write_origins(repaired, files[1]);
  if (!arguments.issues_file.empty()) {
    write_issues(repaired.mesh, crossings, files[arguments.map_file.empty() ? 1 : 2]);
  }
  const Json report = {{"command", "repair"},
                       {"program", program_name()},
                       {"machine", machine_part()},
                       {"input", mesh_part(given)},
                       {"options", {{"fill_holes", name_of_hole_size(arguments.repair.options)}}},
                       {"repairs", repairs_part(repaired.repairs)},
                       {"properties", properties_part(carried)},
                       {"vertices", facts.vertices},
                       {"triangles", facts.triangles},
                       {"area", facts.area},
                       {"topology", topology_part(topology)},
                       {"is_manifold", topology.is_manifold()},
                       {"self_intersections", crossings.size()},
                       {"seconds", {{"repair", seconds}, {"total", total.seconds()}}}};
  if (!arguments.report_file.empty()) files[others.size()].text(json_text(report));
  files.commit();
  if (console.wants_json()) console.print_json(json_text(report));
  progress.clear();
  fmt::print("{}\n{}{}", given.file.string(),
             describe(given.loaded, given.facts, HandledBy::repair),
             describe(repaired.repairs) + describe(carried));
  fmt::print("  {:<12}{}, {}, {}, Euler characteristic {}, {}, area {:.6g}\n", "result",
             counted(facts.vertices, "vertex", "vertices"),
             counted(facts.triangles, "triangle", "triangles"),
             counted(facts.components, "component", "components"), facts.euler_characteristic,
             describe(topology), facts.area);
  if (!crossings.empty()) {
    fmt::print("  {:<12}{}\n", "", describe_self_intersections(crossings.size()));
  }
  fmt::print("  {:<12}{:.2f} s: repair {:.2f}\n  {:<11} {}", "time", total.seconds(), seconds,
             "written", arguments.output.name());
  for (const auto& name : others) fmt::print(" {}", name.string());
  fmt::print("\n");
}

}  // namespace

void add_repair_command(CLI::App& program, Console& console) {
  CLI::App* command = program.add_subcommand(
      "repair", "Repair a mesh: duplicates, cracks, slivers, orientations, small holes");
  const auto a = std::make_shared<RepairCommandArguments>();
  command->add_option("MESH", a->mesh, input_mesh_text)->type_name("")->required();
  add_output_option(*command, a->output, "File for the repaired mesh");
  command
      ->add_option("--map", a->map_file,
                   "CSV file that tells which vertex of the input each vertex was")
      ->type_name("FILE");
  add_issues_option(*command, a->issues_file);
  command->add_option("--report", a->report_file, "JSON file for all figures")->type_name("FILE");
  add_hole_option(*command, a->repair);
  add_thread_options(*command, a->threads);
  add_json_option(*command, console);
  add_reading_options(*command, a->reading);
  command->callback([a, &console] { run_repair(*a, console); });
}

}  // namespace geolloyd

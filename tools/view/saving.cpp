#include "tools/view/saving.h"

#include <array>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_io.h"
#include "tools/evaluation/attribute_transfer.h"
#include "tools/files/csv.h"
#include "tools/files/output_folder.h"
#include "tools/report/relax_output.h"
#include "tools/report/report.h"
#include "tools/run/dual.h"
#include "tools/run/result.h"
#include "tools/system/machine.h"
#include "tools/view/command_lines.h"
#include "tools/view/layers.h"
#include "tools/view/page.h"
#include "tools/view/page_contents.h"
#include "tools/view/session_model.h"

namespace geolloyd {
namespace {

constexpr const char* picture_name = "picture.png";
constexpr const char* page_name = "page.html";
constexpr std::array<const char*, 9> saved_names = {
    page_name,     "tessellation.ply", "seeds.csv",      "regions.csv", "dual.ply",
    "report.json", picture_name,       first_seeds_name, remesh_name};

// Those of the command line that gives this result.
RelaxArguments arguments_of(const std::filesystem::path& folder, const SteppedTessellation& t) {
  const RelaxationOptions limits = t.limits();
  RelaxArguments arguments;
  arguments.output = folder;
  arguments.start.mesh = t.start().input.file;
  arguments.start.graph = t.options().graph;
  arguments.start.seeds = t.options().seeds;
  arguments.start.has_properties = true;
  if (t.has_edited_seeds()) {
    arguments.start.seeds = {};
    arguments.start.seeds.file = folder / first_seeds_name;
  }
  arguments.relaxation.greedy = limits.greedy;
  arguments.relaxation.max_greedy_steps = limits.max_greedy_steps;
  arguments.relaxation.max_macrosteps = limits.max_macrosteps;
  return arguments;
}

GraphDual dual_of(SteppedTessellation& t, const std::vector<NodeId>& seeds,
                  const Partition& partition, Scheduler& scheduler) {
  const Start& start = t.start();
  const InputSurface* const surface =
      has_triangles(start.mesh_graph.kind) ? nullptr : &*start.surface;
  GraphDual dual = make_graph_dual(
      {start.input.mesh(), start.mesh_graph, seeds, partition, t.engine(), scheduler, surface},
      DualRequest{}, scheduler);
  t.restore_partition();
  return dual;
}

void write_first_seeds(const std::filesystem::path& path, const Start& start) {
  FileWriter file(path);
  for (const NodeId seed : start.seeds) write_row(file, start.mesh_graph.input_id[seed]);
  file.commit();
}

void write_remesh(const std::filesystem::path& path, const Start& start, const Remesh& remesh,
                  Scheduler& scheduler) {
  Properties properties =
      transfer_properties(start.input.mesh(), start.input.loaded.properties, remesh, scheduler);
  keep_writable(path, properties);
  FileWriter file(path);
  write(file, remesh.mesh, properties);
  file.commit();
}

std::string save_result(const std::filesystem::path& folder, SteppedTessellation& t,
                        Scheduler& scheduler) {
  const Stopwatch watch;
  const Start& start = t.start();
  const RelaxArguments arguments = arguments_of(folder, t);
  Result result;
  result.relaxation = t.result();
  result.threads = scheduler.threads();
  const Relaxation& relaxation = result.relaxation;
  result.dual = dual_of(t, relaxation.seeds, relaxation.partition, scheduler);
  result.dual_properties = transfer_properties(start.input.mesh(), start.input.loaded.properties,
                                               start.mesh_graph, *result.dual, scheduler);
  result.regions = summarise_regions(start.mesh_graph.graph, relaxation.partition, relaxation.seeds,
                                     relaxation.region_score);
  Cost cost;
  ResultFiles files(arguments);
  write_results(start, result, files, scheduler);
  cost.write_seconds = cost.total_seconds = watch.seconds();
  cost.peak_memory_bytes = peak_memory_bytes();
  files.find(RelaxOutput::report)->text(report_text(arguments, start, result, cost));
  write_first_seeds(folder / first_seeds_name, start);
  files.commit();
  std::string names = first_seeds_name;
  for (const std::string& name : names_of_results(arguments)) names += " " + name;
  return names;
}

// The regions as they are, and the surface remesh; where there is none, the dual.
std::string save_page(const std::filesystem::path& folder, SteppedTessellation& t,
                      const std::optional<SessionRemesh>& remesh, Scheduler& scheduler) {
  const Start& start = t.start();
  Result result;
  result.relaxation = t.result();
  const Relaxation& relaxation = result.relaxation;
  const bool has_remesh = remesh && remesh->made;
  if (!has_remesh) {
    result.dual = dual_of(t, relaxation.seeds, relaxation.partition, scheduler);
  }
  result.regions = summarise_regions(start.mesh_graph.graph, relaxation.partition, relaxation.seeds,
                                     relaxation.region_score);
  Bundle bundle = relax_contents(arguments_of(folder, t), start, result, {}, scheduler);
  if (has_remesh) add_remesh(bundle, remesh->made->mesh);
  return write_page(folder / page_name, std::move(bundle));
}

}  // namespace

void prepare_saving(const std::filesystem::path& folder,
                    std::span<const std::filesystem::path> inputs) {
  if (!folder.empty()) prepare_folder(folder, saved_names, inputs);
}

GraphDual dual_of(SteppedTessellation& t, Scheduler& scheduler) {
  const Partition partition = t.partition();
  return dual_of(t, t.seeds(), partition, scheduler);
}

std::string save_into(const std::filesystem::path& folder, Saving what,
                      SteppedTessellation& tessellation, const std::optional<SessionRemesh>& remesh,
                      Scheduler& scheduler) {
  if (what == Saving::picture) {
    write_picture(folder / picture_name, {}, tessellation.start(), tessellation.result(),
                  scheduler);
    return picture_name;
  }
  if (what == Saving::page) return save_page(folder, tessellation, remesh, scheduler);
  std::string names = save_result(folder, tessellation, scheduler);
  if (remesh && remesh->made) {
    write_remesh(folder / remesh_name, tessellation.start(), *remesh->made, scheduler);
    names += std::string(" ") + remesh_name;
  }
  return names;
}

}  // namespace geolloyd

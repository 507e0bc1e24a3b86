#include "tools/view/session/saving.h"

#include <array>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_io.h"
#include "tools/evaluation/attribute_transfer.h"
#include "tools/files/csv.h"
#include "tools/report/relax_output.h"
#include "tools/report/report.h"
#include "tools/run/dual.h"
#include "tools/run/result.h"
#include "tools/system/machine.h"
#include "tools/view/layers.h"
#include "tools/view/page.h"
#include "tools/view/page_contents.h"
#include "tools/view/session/command_lines.h"
#include "tools/view/session/session_model.h"

namespace geolloyd {
namespace {

constexpr const char* picture_name = "picture.png";
constexpr const char* page_name = "page.html";
constexpr std::array<const char*, 9> saved_names = {
    page_name,     "tessellation.ply", "seeds.csv",      "regions.csv", "dual.ply",
    "report.json", picture_name,       first_seeds_name, remesh_name};

// Those of the run that gives this result.
RelaxFacts facts_of(const std::filesystem::path& folder, const SteppedTessellation& t) {
  RelaxFacts facts;
  facts.request.mesh = t.start().input.file;
  facts.request.has_properties = true;
  facts.request.graph = t.options().graph;
  facts.options = t.limits();
  if (t.has_edited_seeds()) {
    facts.request.seed_file.path = folder / first_seeds_name;
  } else {
    facts.request.seeds = t.options().seeds;
    facts.request.seed_file = t.options().seed_file;
  }
  return facts;
}

void write_first_seeds(const std::filesystem::path& path, const PreparedInput& start) {
  FileWriter file(path);
  for (const NodeId seed : start.seeds) write_row(file, start.mesh_graph.input_id[seed]);
  file.commit();
}

void write_remesh(const std::filesystem::path& path, const PreparedInput& start,
                  const Remesh& remesh, Executor& executor) {
  Properties properties =
      transfer_properties(start.input.mesh(), start.input.loaded.properties, remesh, executor);
  keep_writable(path, properties);
  FileWriter file(path);
  write(file, remesh.mesh, properties);
  file.commit();
}

std::string save_result(const std::filesystem::path& folder, SteppedTessellation& t,
                        Executor& executor) {
  const Stopwatch watch;
  const PreparedInput& start = t.start();
  RelaxTargets targets;
  targets.folder = folder;
  Result result;
  result.relaxation = t.result();
  result.threads = executor.threads();
  const Relaxation& relaxation = result.relaxation;
  result.dual =
      make_whole_dual(start, relaxation.seeds, relaxation.partition, t.engine(), {}, executor);
  t.restore_partition();
  result.regions = summarise_regions(start.mesh_graph.graph, relaxation.partition, relaxation.seeds,
                                     relaxation.region_score);
  Cost cost;
  ResultFiles files(targets);
  write_results(start, result, files, executor);
  cost.write_seconds = cost.total_seconds = watch.seconds();
  cost.peak_memory_bytes = peak_memory_bytes();
  files.find(RelaxOutput::report)->text(report_text(facts_of(folder, t), start, result, cost));
  write_first_seeds(folder / first_seeds_name, start);
  files.commit();
  std::string names = first_seeds_name;
  for (const std::string& name : names_of_results(targets)) names += " " + name;
  return names;
}

// The regions as they are, and the surface remesh; where there is none, the dual.
std::string save_page(const std::filesystem::path& folder, SteppedTessellation& t,
                      const std::optional<SessionRemesh>& remesh, Runtime& runtime) {
  const PreparedInput& start = t.start();
  Result result;
  result.relaxation = t.result();
  const Relaxation& relaxation = result.relaxation;
  const bool has_remesh = remesh && remesh->made;
  if (!has_remesh) {
    result.dual = make_dual(start, relaxation.seeds, relaxation.partition, t.engine(), {},
                            runtime.executor());
    t.restore_partition();
  }
  result.regions = summarise_regions(start.mesh_graph.graph, relaxation.partition, relaxation.seeds,
                                     relaxation.region_score);
  Bundle bundle = relax_contents(t.options().graph, start, result, {}, runtime);
  if (has_remesh) add_remesh(bundle, remesh->made->mesh);
  return write_page(folder / page_name, std::move(bundle));
}

}  // namespace

MadeFolders prepare_saving(const std::filesystem::path& folder,
                           std::span<const std::filesystem::path> inputs) {
  if (folder.empty()) return {};
  return prepare_folder(folder, saved_names, inputs);
}

GraphDual dual_of(SteppedTessellation& t, Executor& executor) {
  const Partition partition = t.partition();
  GraphDual dual = make_dual(t.start(), t.seeds(), partition, t.engine(), {}, executor);
  t.restore_partition();
  return dual;
}

std::string save_into(const std::filesystem::path& folder, Saving what,
                      SteppedTessellation& tessellation, const std::optional<SessionRemesh>& remesh,
                      Runtime& runtime) {
  Executor& executor = runtime.executor();
  if (what == Saving::picture) {
    write_picture(folder / picture_name, {}, tessellation.start(), tessellation.result(), executor);
    return picture_name;
  }
  if (what == Saving::page) return save_page(folder, tessellation, remesh, runtime);
  std::string names = save_result(folder, tessellation, executor);
  if (remesh && remesh->made) {
    write_remesh(folder / remesh_name, tessellation.start(), *remesh->made, executor);
    names += std::string(" ") + remesh_name;
  }
  return names;
}

}  // namespace geolloyd

#include "tools/run/remesh_run.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/base/stopwatch.h"
#include "tools/render/picture.h"
#include "tools/run/attribute_transfer.h"
#include "tools/run/memory_need.h"
#include "tools/run/stages.h"

namespace geolloyd {
namespace {

// What the command line asks of a remesh, of one mesh.
class Remesher {
 public:
  Remesher(const RemeshArguments& arguments, LoadedInput& loaded, const MemoryCheck& check_memory,
           Scheduler& scheduler, ProgressLine& progress)
      : arguments_(arguments),
        loaded_(loaded),
        check_memory_(check_memory),
        make_engine_(make_surface_engines(arguments.engine, scheduler)),
        scheduler_(scheduler),
        progress_(progress) {
    options_.sizing = read_sizing(arguments.sizing, loaded);
    options_.field = find_field(arguments.field, loaded.input.mesh(), loaded.edges, scheduler);
    options_.features = read_features(arguments.features, loaded);
    options_.fit = !arguments.no_fit;
  }

  [[nodiscard]] const std::vector<TangentSpace>& field() const { return options_.field; }

  void run(RemeshResult& result) {
    const FinenessArguments& fineness = arguments_.fineness;
    if (fineness.tolerance > 0) {
      search(result);
      return;
    }
    options_.edge_length = fineness.edge_length;
    options_.vertex_count = fineness.vertices;
    check_memory(about_how_many(loaded_, options_, scheduler_), result);
    result.made = time_last_remesh(loaded_, options_, make_engine_, scheduler_, progress_);
  }

 private:
  void search(RemeshResult& result) {
    const FinenessArguments& fineness = arguments_.fineness;
    const double unit = fineness.is_percentage ? loaded_.input.facts.bounding_diagonal / 100 : 1;
    ToleranceSearch found = search_within(
        fineness.tolerance * unit, loaded_,
        [&](std::size_t vertices) {
          check_memory(vertices, result);
          options_.vertex_count = vertices;
          return time_remesh(loaded_, options_, make_engine_, scheduler_, progress_);
        },
        scheduler_, progress_);
    result.made = std::move(found.best);
    result.trials = std::move(found.trials);
  }

  void check_memory(std::size_t vertices, RemeshResult& result) {
    const Mesh& mesh = loaded_.input.mesh();
    WorkSize size = size_of(loaded_.input.loaded);
    size.sites = vertices;
    if (!arguments_.picture_file.empty()) {
      const PictureArguments& picture = arguments_.picture;
      size.samples = count_samples(mesh, picture.view, picture.size, scheduler_);
    }
    const std::uint64_t bytes =
        memory_to_remesh(mesh, loaded_.edges, loaded_.input.facts.area, options_, size, scheduler_);
    check_memory_(bytes);
    result.memory_estimate = std::max(result.memory_estimate, bytes);
  }

  const RemeshArguments& arguments_;
  LoadedInput& loaded_;
  const MemoryCheck& check_memory_;
  MakeSurfaceEngine make_engine_;
  Scheduler& scheduler_;
  ProgressLine& progress_;
  RemeshOptions options_;
};

// Whose numbers a repair would change; empty: none is given.
std::string option_that_names_vertices(const RemeshArguments& arguments) {
  if (!arguments.sizing.lengths_file.empty()) return "--sizing";
  if (!arguments.sizing.densities_file.empty()) return "--density";
  if (!arguments.features.edges_file.empty()) return "--feature-edges";
  if (!arguments.features.fixed_file.empty()) return "--fixed";
  if (!arguments.field.field_file().empty()) return "--vfield";
  return arguments.map_file.empty() ? "" : "--map";
}

}  // namespace

void check_remesh(const RemeshArguments& arguments) {
  check_fineness(arguments.fineness, arguments.sizing);
  check_has_magnitudes(arguments.field);
  check_repair(arguments.repair, option_that_names_vertices(arguments));
}

RemeshedInput remesh_input(const RemeshArguments& arguments, const MemoryCheck& check_memory,
                           Scheduler& scheduler, ProgressLine& progress) {
  RemeshedInput done;
  done.loaded = load_surface(arguments.mesh, scheduler, progress,
                             {arguments.carries_properties || !arguments.features.labels.empty()},
                             arguments.repair);
  RemeshResult& result = done.result;
  result.threads = arguments.engine == EngineKind::reference ? 1 : scheduler.threads();
  Remesher remesher(arguments, done.loaded, check_memory, scheduler, progress);
  remesher.run(result);

  progress.stage("carrying properties over");
  const Input& input = done.loaded.input;
  const Properties none;
  result.properties = transfer_properties(
      input.mesh(), arguments.carries_properties ? input.loaded.properties : none,
      result.made.remesh, scheduler);

  progress.stage("measuring the remesh");
  const Stopwatch judging;
  result.figures = judge_remesh(done.loaded, result.made.remesh, remesher.field(), scheduler);
  result.judge_seconds = judging.seconds();
  return done;
}

}  // namespace geolloyd

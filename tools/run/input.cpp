#include "tools/run/input.h"

#include <system_error>
#include <utility>

#include "core/base/stopwatch.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {

LoadedMesh read_within_limits(const std::filesystem::path& file) {
  std::error_code unknown;  // is for the reader to tell
  const auto file_size = std::filesystem::file_size(file, unknown);
  if (!unknown) require_memory(file.string(), memory_to_read(file_size));
  LoadedMesh loaded = read_mesh(file);
  require_memory(file.string(),
                 memory_to_check(loaded.mesh.vertex_count(), loaded.mesh.triangle_count()));
  return loaded;
}

LoadedInput load_input(const std::filesystem::path& file, Scheduler& scheduler,
                       const RepairArguments& repair) {
  LoadedInput loaded;
  const Stopwatch watch;
  loaded.input.file = file;
  loaded.input.loaded = read_within_limits(file);
  if (repair.is_wanted) {
    Mesh& given = loaded.input.loaded.mesh;
    require_memory(file.string(), memory_to_repair(given.vertex_count(), given.triangle_count()));
    RepairedMesh repaired = make_repaired_mesh(given, repair.options, scheduler);
    given = std::move(repaired.mesh);
    loaded.input.repairs = repaired.repairs;
  }
  const Mesh& mesh = loaded.input.mesh();
  const Stopwatch finding;
  loaded.edges = find_edges(mesh, scheduler);
  loaded.edge_seconds = finding.seconds();
  loaded.input.facts = check_mesh(mesh, loaded.edges, scheduler);
  loaded.seconds = watch.seconds() - loaded.edge_seconds;
  return loaded;
}

}  // namespace geolloyd

#include "tools/run/input.h"

#include <string>
#include <system_error>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/mesh/properties.h"
#include "geolloyd/errors.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {

namespace {

bool is_readable_without_properties(const std::filesystem::path& file) {
  try {
    (void)read_mesh(file);
    return true;
  } catch (const Error&) {
    return false;
  }
}

LoadedMesh read(const std::filesystem::path& file, const ReadOptions& options) {
  try {
    return read_mesh(file, options);
  } catch (const InvalidInput& error) {
    if (!options.properties || !is_readable_without_properties(file)) throw;
    throw InvalidInput(std::string(error.what()) + "; --drop does without properties");
  }
}

}  // namespace

LoadedMesh read_within_limits(const std::filesystem::path& file, const ReadOptions& options) {
  std::error_code unknown;  // is for the reader to tell
  const auto file_size = std::filesystem::file_size(file, unknown);
  if (!unknown) require_memory(file.string(), memory_to_read(file_size));
  LoadedMesh loaded = read(file, options);
  require_memory(file.string(),
                 memory_to_check(loaded.mesh.vertex_count(), loaded.mesh.triangle_count(),
                                 bytes_of(loaded.properties)));
  return loaded;
}

LoadedInput load_input(const std::filesystem::path& file, Scheduler& scheduler,
                       const ReadOptions& options, const RepairArguments& repair) {
  LoadedInput loaded;
  const Stopwatch watch;
  loaded.input.file = file;
  loaded.input.loaded = read_within_limits(file, options);
  if (repair.is_wanted) {
    Mesh& given = loaded.input.loaded.mesh;
    require_memory(file.string(), memory_to_repair(given.vertex_count(), given.triangle_count()));
    RepairedMesh repaired = make_repaired_mesh(given, repair.options, scheduler);
    Properties& properties = loaded.input.loaded.properties;
    properties =
        follow_origins(properties, repaired.mesh, repaired.vertex_origin, repaired.triangle_origin);
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

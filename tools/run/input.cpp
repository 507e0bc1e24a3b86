#include "tools/run/input.h"

#include <string>
#include <system_error>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_readers.h"
#include "core/properties/properties.h"
#include "core/text/compression.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tools/run/memory_need.h"
#include "tools/system/memory_limit.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {

namespace {

// Where the name tells none, the one given.
MeshFormat format_of_input(const std::filesystem::path& file, std::optional<MeshFormat> given) {
  const bool is_told = file != standard_input && known_format(file);
  if (!is_told && given) return *given;
  if (file == standard_input) {
    throw InvalidInput("standard input: say what it is, such as --format ply");
  }
  return format_to_read(file);
}

// The bytes of a mesh file, and what is known of it.
struct MeshBytes {
  MeshFormat format;
  std::string bytes;
  std::string name;                     // for messages
  const std::filesystem::path* folder;  // null: unknown

  [[nodiscard]] LoadedMesh parse(const ReadOptions& options) const {
    return parse_mesh(format, bytes, name, options, folder);
  }
};

bool is_readable_without_properties(const MeshBytes& file, const ReadOptions& options) {
  try {
    (void)file.parse({false, options.most_bytes, options.weld});
    return true;
  } catch (const Error&) {
    return false;
  }
}

LoadedMesh parse(const MeshBytes& file, const ReadOptions& options) {
  try {
    return file.parse(options);
  } catch (const InvalidInput& error) {
    if (!options.properties || !is_readable_without_properties(file, options)) throw;
    throw InvalidInput(std::string(error.what()) + "; --drop does without properties");
  }
}

}  // namespace

LoadedMesh read_within_limits(const std::filesystem::path& file, const InputOptions& options) {
  const MeshFormat format = format_of_input(file, options.reading.format);
  const bool is_file = file != standard_input;
  const std::string name = is_file ? file.string() : "standard input";
  std::error_code unknown;  // is for the reader to tell
  const auto file_size = std::filesystem::file_size(file, unknown);
  if (!unknown && is_file) require_memory(name, file_size);
  std::string bytes = is_file ? read_file(file) : read_standard_input(name);
  bytes = unpack(std::move(bytes), name, allowed_memory());
  const std::filesystem::path folder = file.parent_path();
  LoadedMesh loaded = parse({format, std::move(bytes), name, is_file ? &folder : nullptr},
                            {options.properties, allowed_memory(), options.reading.weld});
  require_memory(name, bytes_to_read(size_of(loaded)));
  return loaded;
}

MeshFacts find_facts(const LoadedMesh& loaded, const MeshEdges& edges, Executor& executor) {
  MeshFacts facts = check_mesh(loaded.mesh, edges, executor);
  if (!loaded.welded_to.empty()) facts.unreferenced_vertices -= loaded.welded_vertices;
  return facts;
}

Repairs without_welded(Repairs repairs, const LoadedMesh& loaded) {
  repairs.unused_vertices -= loaded.welded_vertices;
  return repairs;
}

LoadedInput load_input(const std::filesystem::path& file, Executor& executor,
                       const InputOptions& options, const std::optional<RepairOptions>& repair) {
  LoadedInput loaded;
  const Stopwatch watch;
  loaded.input.file = file;
  loaded.input.reading = options.reading;
  loaded.input.loaded = read_within_limits(file, options);
  if (repair) {
    Mesh& given = loaded.input.loaded.mesh;
    require_memory(file.string(), bytes_to_repair(size_of(loaded.input.loaded)));
    RepairedMesh repaired = make_repaired_mesh(given, *repair, executor);
    Properties& properties = loaded.input.loaded.properties;
    properties =
        follow_origins(properties, repaired.mesh, repaired.vertex_origin, repaired.triangle_origin);
    given = std::move(repaired.mesh);
    loaded.input.repairs = without_welded(repaired.repairs, loaded.input.loaded);
    loaded.input.loaded.welded_to.clear();  // vertices have other numbers now
  }
  const Mesh& mesh = loaded.input.mesh();
  const Stopwatch finding;
  loaded.edges = find_edges(mesh, executor);
  loaded.edge_seconds = finding.seconds();
  loaded.input.facts = find_facts(loaded.input.loaded, loaded.edges, executor);
  loaded.seconds = watch.seconds() - loaded.edge_seconds;
  return loaded;
}

}  // namespace geolloyd

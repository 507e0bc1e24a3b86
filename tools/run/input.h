#pragma once

#include <filesystem>
#include <optional>

#include "core/base/executor.h"
#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/repair/repair.h"
#include "tools/files/mesh_reading.h"

namespace geolloyd {

/// A mesh that was read from a file and perhaps repaired, and what was found in it after that.
struct Input {
  std::filesystem::path file;
  LoadedMesh loaded;
  MeshFacts facts;
  std::optional<Repairs> repairs;  ///< empty: none was asked for
  MeshReading reading = {};

  [[nodiscard]] const Mesh& mesh() const { return loaded.mesh; }
};

/// An input, the edges that were found on the way, and how long both took.
struct LoadedInput {
  Input input;
  MeshEdges edges;
  double seconds = 0;       ///< to read, repair and check the mesh
  double edge_seconds = 0;  ///< to find the edges
};

/// How a mesh file is read.
struct InputOptions {
  bool properties = false;  ///< read them, too: they may take more memory than the mesh
  MeshReading reading = {};
};

/// Reads a mesh. Throws InvalidInput where there is not enough memory (memory_limit.h): judged by
/// the size of the file, then for what comes next in every command, finding its edges. Where only
/// properties are malformed, the message says how to do without.
LoadedMesh read_within_limits(const std::filesystem::path& file, const InputOptions& options = {});

/// What is found in a mesh; welded vertices do not count among those of no triangle.
MeshFacts find_facts(const LoadedMesh& loaded, const MeshEdges& edges,
                     Executor& executor = sequential());
/// What a repair of it did; welded vertices do not count among the unused.
Repairs without_welded(Repairs repairs, const LoadedMesh& loaded);

/// Reads a mesh in the same way, repairs it if that is wanted, finds its edges and checks it.
LoadedInput load_input(const std::filesystem::path& file, Executor& executor,
                       const InputOptions& options = {},
                       const std::optional<RepairOptions>& repair = {});

}  // namespace geolloyd

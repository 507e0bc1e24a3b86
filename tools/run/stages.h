#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/course/prepared_run.h"
#include "core/lloyd/engine.h"
#include "geolloyd/repair.h"
#include "geolloyd/runtime.h"
#include "parallel/threads/scheduler.h"
#include "tools/files/mesh_reading.h"
#include "tools/render/view.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"
#include "tools/words/names.h"

namespace geolloyd {

/// What a run is of.
struct RunRequest {
  std::filesystem::path mesh;
  MeshReading reading;
  std::optional<RepairOptions> repair;  ///< empty: the mesh stays as it is
  bool has_properties = false;          ///< those of the mesh are read, too
  GraphPlan graph;
  SeedPlan seeds;
  SeedFile seed_file;  ///< gives the first seeds, where it is named

  /// The files that are read, some of them empty: no result may replace one.
  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    return {mesh, graph.field_file(), seed_file.path};
  }
};

/// The engines that --engine and --frontier name, on these threads, which must live on.
std::unique_ptr<Runtime> make_runtime(EngineKind kind, Frontier frontier, Scheduler& scheduler);

/// What is made in a run beside its regions: memory goes by it, and what the dual needs is kept.
struct RunWork {
  bool has_ground_truth = false;       ///< of the result or of the dual
  std::optional<PictureLook> picture;  ///< empty: none is drawn
  bool has_dual = false;               ///< its dual is made
};

/// Bytes that a run takes at most. `seeds`: as many as there may be.
std::uint64_t estimate_memory(const GraphPlan& graph, const SeedPlan& seeds, const Input& input,
                              const MeshEdges& edges, const RunWork& work, Executor& executor);

/// A mesh that was read, and all that there is of it before a relaxation begins.
struct PreparedInput : PreparedRun {
  Input input;
  std::uint64_t memory_estimate = 0;  ///< bytes, of the whole run
  double load_seconds = 0;            ///< reading and checking the mesh
};

/// Reads the mesh, builds its graph, and chooses or reads the first seeds. Throws InvalidInput
/// where the whole run needs more memory than there is.
PreparedInput prepare(const RunRequest& request, const RunWork& work, Runtime& runtime,
                      ProgressLine& progress);

/// A partition and the engine that has just found it.
struct EnginePartition {
  std::unique_ptr<Engine> engine;
  Partition partition;
};

EnginePartition partition_seeds(const Graph& graph, std::span<const NodeId> seeds,
                                Runtime& runtime);

}  // namespace geolloyd

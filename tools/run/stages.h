#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/engine.h"
#include "core/regions/graph_dual.h"
#include "geolloyd/runtime.h"
#include "parallel/threads/scheduler.h"
#include "tools/cli/relax_arguments.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// The threads that the command line asks for.
Scheduler make_scheduler(const ThreadArguments& threads);

/// The engines that --engine and --frontier name, on these threads, which must live on.
std::unique_ptr<Runtime> make_runtime(EngineKind kind, Frontier frontier, Scheduler& scheduler);

/// What a command does with a graph, as far as its memory goes by that.
struct Purpose {
  EngineKind engine = EngineKind::parallel;
  bool has_ground_truth = false;            ///< of the result or of the remesh
  std::optional<PictureArguments> picture;  ///< empty: none is drawn
  SeedInit init = SeedInit::farthest;       ///< prepare() knows
  bool has_dual = false;                    ///< its dual is made
};

/// The tangent field that is asked for: none, that of a file, or the surface's own.
std::vector<TangentSpace> find_field(const FieldArguments& arguments, const Mesh& mesh,
                                     const MeshEdges& edges, Executor& executor);

/// Bytes that a run with so many seeds takes at most.
std::uint64_t estimate_memory(const GraphArguments& arguments, const Input& input,
                              const MeshEdges& edges, std::size_t seeds, const Purpose& purpose,
                              Executor& executor);

/// All that there is before a relaxation begins.
struct Start {
  Input input;
  MeshGraph mesh_graph;
  std::size_t components = 0;  ///< of the graph
  /// Of a graph of vertices whose dual is made. Where triangles are nodes, all edges would have to
  /// be kept.
  std::optional<InputSurface> surface;
  std::vector<NodeId> seeds;
  std::optional<PositionFit> seed_fit;  ///< of seeds that a file gives by position
  std::uint64_t memory_estimate = 0;    ///< bytes, of the whole run

  struct Seconds {
    double load = 0;   ///< reading and checking the mesh
    double graph = 0;  ///< finding edges, which are arcs to be, and building the graph
    double seeds = 0;
  } seconds;
};

/// Reads the mesh, builds its graph, and chooses or reads the first seeds. Throws InvalidInput
/// where the whole run needs more memory than there is.
Start prepare(const StartArguments& arguments, Purpose purpose, Runtime& runtime,
              ProgressLine& progress);

/// A partition and the engine that has just found it.
struct EnginePartition {
  std::unique_ptr<Engine> engine;
  Partition partition;
};

EnginePartition partition_seeds(const Graph& graph, std::span<const NodeId> seeds,
                                Runtime& runtime);

}  // namespace geolloyd

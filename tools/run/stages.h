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
#include "parallel/threads/scheduler.h"
#include "tools/cli/relax_arguments.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// The threads that the command line asks for.
Scheduler make_scheduler(const ThreadArguments& threads);

/// What a command does with a graph, as far as its memory goes by that.
struct Purpose {
  bool has_ground_truth = false;            ///< of the result or of the remesh
  std::optional<PictureArguments> picture;  ///< empty: none is drawn
  bool has_dual = false;                    ///< its dual is made
};

/// The tangent field that is asked for: none, that of a file, or the surface's own.
std::vector<TangentSpace> find_field(const FieldArguments& arguments, const Mesh& mesh,
                                     const MeshEdges& edges, Executor& executor);

struct BuiltGraph {
  MeshGraph mesh_graph;
  std::uint64_t memory_estimate = 0;  ///< bytes, of a run on it
};

/// A graph of a mesh of which further ones will be built, for runs with up to so many seeds. Throws
/// InvalidInput where such a run needs more memory than there is.
BuiltGraph build_graph(const GraphArguments& arguments, const LoadedInput& loaded,
                       std::size_t seeds, Scheduler& scheduler);

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
Start prepare(const StartArguments& arguments, const Purpose& purpose, Scheduler& scheduler,
              ProgressLine& progress);

/// A partition and the parallel engine that has just found it.
struct EnginePartition {
  std::unique_ptr<Engine> engine;
  Partition partition;
};

EnginePartition partition_seeds(const Graph& graph, std::span<const NodeId> seeds,
                                Frontier frontier, Scheduler& scheduler);

}  // namespace geolloyd

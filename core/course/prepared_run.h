#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/course/hooks.h"
#include "core/course/run_plan.h"
#include "core/regions/graph_dual.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// All that there is of a mesh before a relaxation begins.
struct PreparedRun {
  MeshGraph mesh_graph;
  std::size_t components = 0;  ///< of the graph
  /// Of a graph of vertices whose dual is made. Where triangles are nodes, all edges would have to
  /// be kept.
  std::optional<InputSurface> surface;
  std::vector<NodeId> seeds;
  std::optional<PositionFit> seed_fit;  ///< of seeds that are given by position

  struct Seconds {
    double graph = 0;  ///< without edges and field, which the caller finds
    double seeds = 0;
  } seconds;
};

/// Builds the graph and finds the first seeds. `edges` are all of the mesh. What takes memory gives
/// it back as soon as nothing needs it. Throws InvalidInput where a graph or the seeds cannot be.
PreparedRun prepare(const Mesh& mesh, MeshEdges edges, const RunPlan& plan, Runtime& runtime,
                    const CourseHooks& hooks = {});

// The same steps for a client that keeps the edges, and changes graph and seeds one by one.

/// What the dual needs of the surface in graphs of vertices.
InputSurface find_surface(const Mesh& mesh, const MeshEdges& edges, Executor& executor);

/// On a graph with this field.
GivenSeeds find_first_seeds(const Mesh& mesh, const MeshEdges& edges,
                            std::span<const TangentSpace> field, const MeshGraph& mesh_graph,
                            const Components& components, const SeedPlan& plan, Runtime& runtime);

/// The dual of regions. `engine` works on the graph; `partition` is that of `seeds`, regions free.
GraphDual make_dual(const Mesh& mesh, const PreparedRun& run, const std::vector<NodeId>& seeds,
                    const Partition& partition, Engine& engine, const GraphDualOptions& options,
                    Executor& executor);

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/seeds/seed_file.h"
#include "core/seeds/seeds.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/threads/scheduler.h"
#include "tools/words/named.h"

namespace geolloyd {

// The words for each choice. Scripts rely on them.

/// Makes a generated mesh (shapes.h).
using Shape = Mesh (*)(std::size_t triangles, std::uint64_t random_seed);
extern const std::vector<Named<Shape>> shape_names;

extern const std::vector<Named<GraphKind>> graph_kind_names;
extern const std::vector<Named<Norm>> norm_names;
extern const std::vector<Named<Averaging>> averaging_names;
/// Those of --averaging: nothing leaves the choice to the program.
extern const std::vector<Named<std::optional<Averaging>>> averaging_choice_names;
extern const std::vector<Named<GreedyMode>> greedy_mode_names;
/// Those of --greedy: nothing leaves the choice to the program.
extern const std::vector<Named<std::optional<GreedyMode>>> greedy_choice_names;
extern const std::vector<Named<SeedInit>> seed_init_names;
extern const std::vector<Named<SeedsBy>> seeds_by_names;
extern const std::vector<Named<StopReason>> stop_reason_names;
extern const std::vector<Named<Frontier>> frontier_names;
extern const std::vector<Named<Backend>> backend_names;
extern const std::vector<Named<Phase>> phase_names;
extern const std::vector<Named<double KernelSeconds::*>> kernel_names;

enum class EngineKind { parallel, reference };
extern const std::vector<Named<EngineKind>> engine_names;

/// The files of a result of `relax`, in the order in which they appear.
enum class RelaxOutput { tessellation, seeds, regions, dual, report };
extern const std::vector<Named<RelaxOutput>> relax_output_names;

/// Where the vertices of a dual are that are not on the boundary.
enum class DualVertices {
  seeds,
  centroids  ///< the surface's points closest to the centroids of the ground truth
};
extern const std::vector<Named<DualVertices>> dual_vertices_names;

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/course/field_source.h"
#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/seeds/seed_file.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// Of which graph a run is.
struct GraphPlan : FieldSource {
  GraphKind kind = GraphKind::vertex;
  Norm norm = Norm::geodesic;
  std::optional<Averaging> averaging;  ///< empty: goes by the norm

  friend bool operator==(const GraphPlan&, const GraphPlan&) = default;
};

/// With the field of the plan, which takes the edges of the mesh.
MeshGraphOptions graph_options(const GraphPlan& plan, const Mesh& mesh, const MeshEdges& edges,
                               Executor& executor);

/// Finds first seeds that somebody gives, by id or position, once there is a graph.
using FindSeeds = std::function<GivenSeeds(const MeshGraph& mesh_graph, const Components&)>;

/// How the first seeds come.
struct SeedPlan {
  std::size_t count = 0;  ///< to be chosen
  SeedInit init = SeedInit::automatic;
  std::uint64_t random_seed = 1;
  FindSeeds given = {};  ///< empty: they are chosen
};

/// What a run begins with.
struct RunPlan {
  MeshGraphOptions graph;
  SeedPlan seeds;
  bool has_dual = false;  ///< the dual will be made: what it needs of the surface is kept
};

/// The mode that is asked for, else the one that suits the first seeds. Of given ones nobody knows
/// how they were chosen.
GreedyMode greedy_mode(std::optional<GreedyMode> asked, bool are_given, SeedInit init);

}  // namespace geolloyd

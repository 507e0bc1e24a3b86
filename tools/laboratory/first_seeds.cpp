#include "tools/laboratory/first_seeds.h"

#include <fmt/format.h>

#include <utility>

#include "core/course/prepared_run.h"
#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/seeds/seed_places.h"
#include "geolloyd/errors.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

void check_count(std::size_t seeds, std::size_t triangles, std::size_t components) {
  if (seeds < components) {
    throw InvalidInput(fmt::format(
        "{}: first seeds are chosen as triangles, and these are in {} parts that no edge "
        "joins: each needs a seed",
        counted(seeds, "seed", "seeds"), grouped(components)));
  }
  if (seeds > triangles) {
    throw InvalidInput(fmt::format("{}: this mesh has only {} to choose first seeds from",
                                   counted(seeds, "seed", "seeds"),
                                   counted(triangles, "triangle", "triangles")));
  }
}

// Before any work: are there enough vertices everywhere?
void check_vertices(const std::vector<FirstSeeds>& all, const Mesh& mesh, const MeshEdges& edges,
                    Executor& executor) {
  const MeshGraph made = make_mesh_graph(mesh, edges, {}, executor);
  for (const FirstSeeds& first : all) seeds_at_triangles(mesh, made, first.places);
}

}  // namespace

std::vector<FirstSeeds> choose_first_seeds(const SeedPlan& how,
                                           const std::vector<std::size_t>& counts,
                                           std::size_t batches, const Mesh& mesh,
                                           const MeshEdges& edges, Runtime& runtime) {
  std::vector<FirstSeeds> all;
  MeshGraphOptions options;
  options.kind = GraphKind::triangle;
  const MeshGraph made = make_mesh_graph(mesh, edges, options, runtime.executor());
  const Components components = connected_components(made.graph);
  for (const std::size_t count : counts) {
    check_count(count, made.graph.node_count(), components.size());
    for (std::size_t batch = 1; batch <= batches; ++batch) {
      FirstSeeds first{count, batch, {}};
      const SeedPlan plan{count, how.init, how.random_seed + batch - 1};
      const GivenSeeds seeds = find_first_seeds(mesh, edges, {}, made, components, plan, runtime);
      for (const NodeId s : seeds.nodes) first.places.push_back(made.input_id[s]);
      all.push_back(std::move(first));
    }
  }
  check_vertices(all, mesh, edges, runtime.executor());
  return all;
}

}  // namespace geolloyd

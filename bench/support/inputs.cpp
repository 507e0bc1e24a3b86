#include "bench/support/inputs.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "core/formats/mesh_io.h"
#include "core/lloyd/reference_engine.h"
#include "core/seeds/seeds.h"
#include "core/shapes/shapes.h"
#include "core/surface/result/remesh.h"
#include "core/voronoi/check_partition.h"
#include "core/voronoi/dijkstra.h"
#include "core/voronoi/forest.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t random_seed = 1;

void require(bool is_right, const std::string& complaint) {
  if (!is_right) throw std::runtime_error("core is wrong: " + complaint);
}

void certify(const Graph& graph, std::span<const NodeId> seeds, const Partition& partition,
             Regions regions) {
  if (const auto defect = check_partition(graph, seeds, partition, regions)) {
    require(false, "node " + std::to_string(defect->node) + " " + defect->what);
  }
}

bool are_whole(const Mesh& mesh, const MeshEdges& edges) {
  const auto usable = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                    [](const Triangle& t) { return has_three_vertices(t); });
  return std::is_sorted(edges.ends.begin(), edges.ends.end()) &&
         edges.corner.size() == 3 * static_cast<std::size_t>(usable);
}

// Whether the arc `a` from `v` also stands at its other end, as long.
bool has_twin(const Graph& graph, NodeId v, ArcId a) {
  const auto back = graph.neighbours(graph.target[a]);
  const auto twin = std::lower_bound(back.begin(), back.end(), v);
  return twin != back.end() && *twin == v &&
         graph.length[static_cast<std::size_t>(&*twin - graph.target.data())] == graph.length[a];
}

bool is_undirected(const Graph& graph) {
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    for (ArcId a = graph.first_arc[v]; a < graph.first_arc[v + 1]; ++a) {
      if (!has_twin(graph, v, a)) return false;
    }
  }
  return true;
}

Solved solve(const Graph& graph, std::vector<NodeId> seeds) {
  Solved solved;
  solved.seeds = std::move(seeds);
  IndexedHeap heap(graph.node_count());
  search_free(graph, solved.seeds, heap, solved.partition.key, solved.settled);
  solved.partition.parent.assign(graph.node_count(), no_id);
  derive_parents(graph, solved.partition.key, solved.settled, solved.partition.parent);
  solved.score.assign(solved.seeds.size(), 0);
  add_scores(graph, solved.partition.key, solved.settled, solved.score);
  certify(graph, solved.seeds, solved.partition, Regions::free);
  return solved;
}

std::vector<NodeId> one_arc_on(const Graph& graph, const Solved& from) {
  std::vector<NodeId> seeds = from.seeds;
  for (NodeId& seed : seeds) {
    const auto around = graph.neighbours(seed);
    const auto next = std::find_if(around.begin(), around.end(),
                                   [&](NodeId v) { return from.partition.parent[v] == seed; });
    if (next != around.end()) seed = *next;
  }
  return seeds;
}

// A partition can be repaired where each new seed lies in its old region. Those that would not on
// the way back return at once.
Solved solve_moved(const Graph& graph, const Solved& from) {
  Solved moved = solve(graph, one_arc_on(graph, from));
  while (true) {
    std::vector<NodeId> seeds = moved.seeds;
    for (RegionId r = 0; r < seeds.size(); ++r) {
      if (region_of(moved.partition.key[from.seeds[r]]) != r) seeds[r] = from.seeds[r];
    }
    if (seeds == moved.seeds) return moved;
    moved = solve(graph, std::move(seeds));
  }
}

}  // namespace

Rest macrostep(Engine& engine, std::vector<NodeId> seeds) {
  const std::vector<std::uint8_t> keeps_seed(seeds.size(), 0);
  Rest rest;
  rest.microsteps =
      engine.macrostep(seeds, {keeps_seed, true, true}, [](std::uint32_t) { return true; });
  rest.seeds = std::move(seeds);
  return rest;
}

std::uint64_t count_visits(const std::vector<Microstep>& microsteps) {
  std::uint64_t visits = 0;
  for (const Microstep& m : microsteps) visits += m.node_visits;
  return visits;
}

Relaxed summarise(const Relaxation& relaxation) {
  Relaxed relaxed{relaxation.fingerprint, relaxation.seeds, relaxation.steps.size(), 0};
  for (const Step& step : relaxation.steps) relaxed.node_visits += step.node_visits;
  return relaxed;
}

const Mesh& Inputs::mesh() {
  return mesh_.get({}, [&] {
    return source_.file.empty() ? creature(source_.triangles, random_seed)
                                : read(source_.file).mesh;
  });
}

const MeshEdges& Inputs::edges() {
  return edges_.get({}, [&] {
    MeshEdges edges = find_edges(mesh());
    require(are_whole(mesh(), edges), "edges are missing or out of order");
    return edges;
  });
}

const MeshFacts& Inputs::facts() {
  return facts_.get({}, [&] {
    const MeshFacts facts = check_mesh(mesh(), edges());
    require(facts.edges == edges().size() && facts.triangles == mesh().triangle_count(),
            "counts of the mesh");
    return facts;
  });
}

const MeshGraph& Inputs::mesh_graph(GraphKind kind) {
  return graph_.get(kind, [&] {
    MeshGraph made = make_mesh_graph(mesh(), edges(), {kind, Norm::geodesic, {}});
    require(is_undirected(made.graph), "an arc is at one end only");
    return made;
  });
}

const Components& Inputs::components() {
  return components_.get({}, [&] { return connected_components(graph()); });
}

const Solved& Inputs::solved(std::size_t seeds) {
  return solved_.get(seeds, [&] {
    return solve(graph(),
                 choose_seeds(graph(), components(), SeedInit::random_area, seeds, random_seed));
  });
}

const Solved& Inputs::moved(std::size_t seeds) {
  return moved_.get(seeds, [&] { return solve_moved(graph(), solved(seeds)); });
}

const Rest& Inputs::rest(std::size_t seeds) {
  return rest_.get(seeds, [&] {
    const auto engine = make_reference_engine(graph());
    engine->partition(solved(seeds).seeds);
    Rest rest = macrostep(*engine, solved(seeds).seeds);
    certify(graph(), rest.seeds, engine->current(), Regions::locked);
    return rest;
  });
}

const Relaxed& Inputs::relaxed(std::size_t seeds) {
  return relaxed_.get(seeds, [&] {
    const auto engine = make_reference_engine(graph());
    const Relaxation relaxation = relax(graph(), *engine, solved(seeds).seeds, {});
    certify(graph(), relaxation.seeds, relaxation.partition, Regions::free);
    return summarise(relaxation);
  });
}

const RestedSurface& Inputs::surface(std::size_t sites) {
  return surface_.get(sites, [&] { return rest_on_surface(mesh(), edges(), sites); });
}

const Remesh& Inputs::surface_remesh(std::size_t sites) {
  return surface_remesh_.get(sites, [&] {
    RemeshOptions options;
    options.vertex_count = sites;
    Remesh remesh = make_remesh(mesh(), edges(), options, reference_runtime());
    require(remesh.has_input_topology(), "the remesh is no manifold like the mesh");
    return remesh;
  });
}

Inputs& inputs_of(const BenchMesh& mesh) {
  static std::unique_ptr<Inputs> last;
  if (!last || last->source().name != mesh.name || last->source().file != mesh.file) {
    last.reset();
    last = std::make_unique<Inputs>(mesh);
  }
  return *last;
}

}  // namespace geolloyd

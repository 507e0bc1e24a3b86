// The library as its users see it: a mesh in, a tessellation out.
#include <geolloyd/core/graph/components.h>
#include <geolloyd/core/graph/mesh_graph.h>
#include <geolloyd/core/lloyd/reference_engine.h>
#include <geolloyd/core/lloyd/relaxation.h>
#include <geolloyd/core/seeds/seeds.h>
#include <geolloyd/core/shapes/shapes.h>
#include <geolloyd/parallel/engine/parallel_engine.h>
#include <cstdio>

int main() {
  using namespace geolloyd;
  const Mesh mesh = icosphere(2000);
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), {});
  const auto seeds =
      choose_seeds(made.graph, connected_components(made.graph), SeedInit::farthest, 12, 1);
  const auto reference = make_reference_engine(made.graph);
  const Relaxation expected = relax(made.graph, *reference, seeds, {});
  Scheduler scheduler(2);
  const auto engine = make_parallel_engine(scheduler, made.graph);
  const Relaxation result = relax(made.graph, *engine, seeds, {});
  std::printf("%zu regions, energy %g\n", result.seeds.size(), result.energy);
  return result.end == End::converged && result.fingerprint == expected.fingerprint ? 0 : 1;
}

// A small triangle soup all the way to the judgement of its remesh: executors compared, both
// engines compared, everything checked that is promised.
#include "tests/fuzz/soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "bench/support/same_bytes.h"
#include "core/dual/dual_mesh.h"
#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/paired_engine.h"
#include "core/lloyd/reference_engine.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_quality.h"
#include "core/mesh/mesh_topology.h"
#include "core/regions/dual_places.h"
#include "core/regions/dual_repair.h"
#include "core/regions/region_borders.h"
#include "core/voronoi/check_partition.h"
#include "geolloyd/errors.h"
#include "parallel/threads/scheduler.h"
#include "tests/fuzz/target.h"

namespace geolloyd::fuzz {
namespace {

Scheduler& scheduler_of(const Soup& soup) {
  static std::map<std::pair<std::size_t, Backend>, std::unique_ptr<Scheduler>> all;
  auto& scheduler = all[{soup.threads, soup.backend}];
  if (!scheduler) scheduler = std::make_unique<Scheduler>(soup.threads, soup.backend);
  return *scheduler;
}

bool same_dual(const DualMesh& a, const DualMesh& b) {
  const auto same_violations = [&] {
    for (std::size_t i = 0; i < a.violations.size(); ++i) {
      if (a.violations[i].kind != b.violations[i].kind ||
          a.violations[i].regions != b.violations[i].regions) {
        return false;
      }
    }
    return true;
  };
  return same_bytes(a.triangles, b.triangles) && same_bytes(a.corner, b.corner) &&
         a.repeated == b.repeated && a.back_to_back == b.back_to_back &&
         a.violations.size() == b.violations.size() && same_violations();
}

MeshEdges make_edges(const Mesh& mesh, Scheduler& scheduler) {
  MeshEdges edges = find_edges(mesh);
  require(same_bytes(edges, find_edges(mesh, scheduler)), "any executor finds the same edges");
  const MeshFacts facts = check_mesh(mesh, edges);
  require(same_bytes(facts, check_mesh(mesh, edges, scheduler)),
          "any executor finds the same facts");
  require(std::isfinite(facts.area) && std::isfinite(facts.bounding_diagonal), "facts are numbers");
  return edges;
}

MeshGraph make_graph(const Soup& soup, const MeshEdges& edges, Scheduler& scheduler) {
  MeshGraph made = make_mesh_graph(soup.mesh, edges, soup.graph);
  require(same_bytes(made, make_mesh_graph(soup.mesh, edges, soup.graph, scheduler)),
          "any executor makes the same graph");
  return made;
}

std::vector<NodeId> make_seeds(const Soup& soup, const Graph& graph, Scheduler& scheduler) {
  const Components components = connected_components(graph);
  const std::size_t count = std::min(components.size() + soup.seeds, graph.node_count());
  std::vector<NodeId> seeds = choose_seeds(graph, components, soup.init, count, soup.random_seed);
  Threads runtime(scheduler);
  require(seeds == choose_seeds(graph, components, soup.init, count, soup.random_seed, runtime),
          "both searches choose the same seeds");
  require(std::set(seeds.begin(), seeds.end()).size() == count, "seeds are different");
  return seeds;
}

Relaxation relax_soup(const Soup& soup, const Graph& graph, Engine& engine,
                      const std::vector<NodeId>& seeds) {
  Relaxation relaxed = relax(graph, engine, seeds, soup.relaxation);
  const auto defect = check_partition(graph, relaxed.seeds, relaxed.partition, Regions::free);
  require(!defect, defect ? defect->what : "");
  require(std::isfinite(relaxed.energy) && relaxed.energy >= 0, "the energy is a number");
  require(!relaxed.steps.empty() || soup.relaxation.max_macrosteps == 0, "there are steps");
  for (const Step& step : relaxed.steps) {
    require(relaxed.energy <= step.energy, "the result is the best state met");
  }
  return relaxed;
}

// No edge has more than two triangles, and those around a vertex are one fan: the opposite edges,
// one chain. Whatever the orientations; written apart from mesh_topology.
bool is_manifold(const std::vector<Triangle>& triangles) {
  std::map<VertexId, std::map<VertexId, std::vector<VertexId>>> around;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [v, p, q] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
      around[v][p].push_back(q);
      around[v][q].push_back(p);
    }
  }
  for (const auto& [v, link] : around) {
    std::set<VertexId> met;
    std::vector<VertexId> open = {link.begin()->first};
    while (!open.empty()) {
      const VertexId a = open.back();
      open.pop_back();
      if (!met.insert(a).second) continue;
      if (link.at(a).size() > 2) return false;
      open.insert(open.end(), link.at(a).begin(), link.at(a).end());
    }
    if (met.size() != link.size()) return false;
  }
  return true;
}

void require_sound(const DualisedSeeds& dualised, std::size_t node_count) {
  std::set<NodeId> different(dualised.seeds.begin(), dualised.seeds.end());
  require(different.size() == dualised.seeds.size(), "seeds stay different");
  require(*different.rbegin() < node_count, "seeds stay nodes");
  for (const Triangle& t : dualised.dual.triangles) {
    require(has_three_vertices(t), "the dual's triangles have three vertices");
    for (const VertexId v : t) require(v < dualised.seeds.size(), "its vertices are regions");
  }
}

// As every component of the graph has a seed, so has every part of the surface.
void require_surface_over_again(const Mesh& remesh, const Mesh& mesh, const MeshEdges& edges) {
  const MeshTopology wanted = find_topology(mesh, edges);
  if (!wanted.is_manifold()) return;
  const MeshTopology found = find_topology(remesh, find_edges(remesh));
  require(found.is_manifold() && is_manifold(remesh.triangles),
          "a dual without violations of a manifold is a manifold");
  require(found.parts == wanted.parts, "it has the topology of the input");
  require(wanted.inconsistent_edges > 0 || found.inconsistent_edges == 0,
          "it is oriented where the input is");
}

void require_quality(const Mesh& remesh) {
  const MeshQuality quality = measure_quality(remesh, find_edges(remesh));
  if (remesh.triangles.empty()) return;
  require(quality.smallest_angle >= 0 && quality.smallest_angle <= 60, "angles are angles");
  require(quality.smallest_quality >= 0 && quality.mean_quality <= 1 + 1e-6,
          "qualities are from 0 to 1");
}

// The dual as it is, then with seeds added.
void remesh(const Soup& soup, const MeshEdges& edges, const MeshGraph& made, Engine& engine,
            Scheduler& scheduler, const std::vector<NodeId>& seeds) {
  const DualInput input{soup.mesh, edges, made, scheduler};
  const DualisedSeeds first = dualise(input, partition_of(engine, seeds), seeds);
  const DualisedSeeds repaired = repair_dual(input, engine, first, [] { return true; });
  require(std::equal(seeds.begin(), seeds.end(), repaired.seeds.begin()) ||
              repaired.seeds.size() > seeds.size(),
          "seeds only move where others are added");
  for (const DualisedSeeds* dualised : {&first, &repaired}) {
    require(same_dual(dualised->dual, make_dual(dualised->surface)),
            "the dual is the same by one thread");
    require_sound(*dualised, made.graph.node_count());
    const Mesh remesh{place_dual(soup.mesh, dualised->surface, dualised->dual,
                                 positions_of(made, dualised->seeds)),
                      dualised->dual.triangles};
    for (const Vec3& p : remesh.positions) require(p.allFinite(), "vertices have places");
    require(count_flipped(soup.mesh, dualised->surface, dualised->dual, remesh.positions) <=
                remesh.triangle_count(),
            "no more triangles are flipped than there are");
    for (const double length : border_lengths(soup.mesh, dualised->surface)) {
      require(std::isfinite(length) && length >= 0, "borders have lengths");
    }
    if (dualised->dual.violations.empty()) require_surface_over_again(remesh, soup.mesh, edges);
    require_quality(remesh);
  }
}

void drive(const Soup& soup) {
  Scheduler& scheduler = scheduler_of(soup);
  const MeshEdges edges = make_edges(soup.mesh, scheduler);
  const MeshGraph made = make_graph(soup, edges, scheduler);
  const std::vector<NodeId> seeds = make_seeds(soup, made.graph, scheduler);
  const auto reference = make_reference_engine(made.graph);
  const auto parallel = make_parallel_engine(scheduler, made.graph, soup.frontier);
  PairedEngine both(*reference, *parallel);
  const Relaxation relaxed = relax_soup(soup, made.graph, both, seeds);
  remesh(soup, edges, made, both, scheduler, relaxed.seeds);
}

}  // namespace
}  // namespace geolloyd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const geolloyd::fuzz::Soup soup = geolloyd::fuzz::make_soup({data, size});
  if (soup.mesh.triangles.empty()) return -1;
  try {
    geolloyd::fuzz::drive(soup);
  } catch (const geolloyd::InvalidInput& error) {
    geolloyd::fuzz::require(std::string_view(error.what()).size() < 400, "a message is short");
  }
  return 0;
}

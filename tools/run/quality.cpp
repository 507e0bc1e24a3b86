#include "tools/run/quality.h"

#include <string>
#include <utility>
#include <vector>

#include "core/base/loops.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/hexagonal_energy.h"
#include "tools/evaluation/point_queries.h"
#include "tools/evaluation/site_energy.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

MeshEdges load(const std::filesystem::path& file, JudgedMesh& mesh, Scheduler& scheduler,
               ProgressLine& progress) {
  progress.stage("reading " + file.string());
  LoadedInput loaded = load_input(file, scheduler);
  mesh.input = std::move(loaded.input);
  mesh.topology = find_topology(mesh.input.mesh(), loaded.edges);
  return std::move(loaded.edges);
}

void require_area(const JudgedMesh& mesh) {
  if (mesh.input.facts.area > 0) return;
  throw InvalidInput(mesh.input.file.string() +
                     ": no triangle with an area, so no distance to measure");
}

// Of the points of the surface closest to the remesh's vertices, and of the hexagonal tiling with
// as many regions.
void measure_energy(const Mesh& remesh, const MeshEdges& edges, Scheduler& scheduler,
                    Likeness& likeness) {
  const Mesh& mesh = likeness.original.input.mesh();
  std::vector<Vec3> sites = referenced_positions(remesh, scheduler);
  const ClosestPoint closest(mesh, scheduler.threads());
  parallel_for(scheduler, sites.size(), 256,
               [&](std::size_t r) { sites[r] = closest.find(sites[r]).position; });
  const double area = likeness.original.input.facts.area;
  likeness.energy = site_energy(mesh, edges.duplicates, sites, scheduler);
  likeness.hexagonal = hexagonal_energy(area, area, sites.size());
}

Likeness compare(const JudgedMesh& remesh, const std::filesystem::path& original,
                 std::size_t samples, Scheduler& scheduler, ProgressLine& progress) {
  Likeness likeness;
  const MeshEdges edges = load(original, likeness.original, scheduler, progress);
  announce_memory(original.string(), memory_to_judge(remesh.input.facts.triangles,
                                                     likeness.original.input.facts.triangles));
  require_area(remesh);
  require_area(likeness.original);
  progress.stage("measuring distances");
  likeness.samples = samples;
  likeness.distance =
      measure_distance(scheduler, remesh.input.mesh(), likeness.original.input.mesh(), samples);
  progress.stage("measuring energy");
  measure_energy(remesh.input.mesh(), edges, scheduler, likeness);
  return likeness;
}

}  // namespace

QualityRecord judge(const std::filesystem::path& remesh, const std::filesystem::path& original,
                    std::size_t samples, Scheduler& scheduler, ProgressLine& progress) {
  QualityRecord record;
  const MeshEdges edges = load(remesh, record.remesh, scheduler, progress);
  record.quality = measure_quality(record.remesh.input.mesh(), edges);
  if (original.empty()) {
    announce_memory(remesh.string(), memory_to_judge(record.remesh.input.facts.triangles, 0));
  } else {
    record.likeness = compare(record.remesh, original, samples, scheduler, progress);
  }
  progress.clear();
  return record;
}

}  // namespace geolloyd

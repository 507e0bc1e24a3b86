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
#include "tools/run/memory_need.h"
#include "tools/run/stages.h"
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

void compare(const QualityInput& input, const MeshEdges& remesh_edges, QualityRecord& record,
             Scheduler& scheduler, ProgressLine& progress) {
  const JudgedMesh& remesh = record.remesh;
  Likeness& likeness = record.likeness.emplace();
  const MeshEdges edges = load(input.original, likeness.original, scheduler, progress);
  WorkSize size = size_of(likeness.original.input.loaded);
  size.has_field = !input.field.vfield.empty();
  announce_memory(input.original.string(), bytes_to_judge(size_of(remesh.input.loaded), size));
  require_area(remesh);
  require_area(likeness.original);
  progress.stage("measuring distances");
  likeness.samples = input.samples;
  likeness.distance = measure_distance(scheduler, remesh.input.mesh(),
                                       likeness.original.input.mesh(), input.samples);
  progress.stage("measuring energy");
  measure_energy(remesh.input.mesh(), edges, scheduler, likeness);
  const Mesh& original = likeness.original.input.mesh();
  const std::vector<TangentSpace> field = find_field(input.field, original, edges, scheduler);
  if (field.empty()) return;
  progress.stage("measuring in the metric");
  record.in_metric =
      judge_in_metric(remesh.input.mesh(), remesh_edges, original, edges, field, scheduler);
}

}  // namespace

QualityRecord judge(const QualityInput& input, Scheduler& scheduler, ProgressLine& progress) {
  QualityRecord record;
  const MeshEdges edges = load(input.remesh, record.remesh, scheduler, progress);
  record.quality = measure_quality(record.remesh.input.mesh(), edges);
  if (input.original.empty()) {
    announce_memory(input.remesh.string(), bytes_to_judge(size_of(record.remesh.input.loaded), {}));
  } else {
    compare(input, edges, record, scheduler, progress);
  }
  progress.clear();
  return record;
}

}  // namespace geolloyd

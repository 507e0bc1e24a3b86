#include "tools/run/quality.h"

#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/repair/crossings.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/distances/distance_bounds.h"
#include "tools/run/memory_need.h"
#include "tools/run/stages.h"
#include "tools/system/memory_limit.h"

namespace geolloyd {
namespace {

MeshEdges load(const std::filesystem::path& file, const MeshReading& reading, JudgedMesh& mesh,
               Executor& executor, ProgressLine& progress) {
  progress.stage("reading " + file.string());
  LoadedInput loaded = load_input(file, executor, {false, reading});
  mesh.input = std::move(loaded.input);
  mesh.topology = find_topology(mesh.input.mesh(), loaded.edges);
  return std::move(loaded.edges);
}

void require_area(const JudgedMesh& mesh) {
  if (mesh.input.facts.area > 0) return;
  throw InvalidInput(mesh.input.file.string() +
                     ": no triangle with an area, so no distance to measure");
}

void compare(const QualityInput& input, const MeshEdges& remesh_edges, QualityRecord& record,
             Runtime& runtime, ProgressLine& progress) {
  Executor& executor = runtime.executor();
  JudgedMesh& original = record.original.emplace();
  const MeshEdges edges = load(input.original, input.reading, original, executor, progress);
  WorkSize size = size_of(original.input.loaded);
  size.has_field = !input.field.vfield.empty();
  progress.announce_memory(input.original.string(),
                           bytes_to_judge(size_of(record.remesh.input.loaded), size));
  require_area(record.remesh);
  require_area(original);
  progress.stage("measuring distances and energy");
  const Mesh& remesh = record.remesh.input.mesh();
  const Mesh& mesh = original.input.mesh();
  record.likeness =
      compare(remesh, mesh, edges.duplicates, original.input.facts.area, input.samples, executor);
  if (input.certify) {
    progress.stage("certifying the distance");
    record.bounds = certify_distance(executor, remesh, mesh, 0);
  }
  const std::vector<TangentSpace> field = find_field(input.field, mesh, edges, executor);
  if (field.empty()) return;
  progress.stage("measuring in the metric");
  record.in_metric = judge_in_metric(remesh, remesh_edges, mesh, edges, field, runtime);
}

}  // namespace

QualityRecord judge(const QualityInput& input, Runtime& runtime, ProgressLine& progress) {
  QualityRecord record;
  const MeshEdges edges =
      load(input.remesh, input.reading, record.remesh, runtime.executor(), progress);
  const Mesh& remesh = record.remesh.input.mesh();
  record.quality = measure_quality(remesh, edges);
  record.self_intersections = find_crossings(remesh, runtime.executor());
  if (input.original.empty()) {
    progress.announce_memory(input.remesh.string(),
                             bytes_to_judge(size_of(record.remesh.input.loaded), {}));
  } else {
    compare(input, edges, record, runtime, progress);
  }
  progress.clear();
  return record;
}

}  // namespace geolloyd

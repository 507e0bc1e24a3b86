#include "bench/zoo/judge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <vector>

#include "bench/zoo/kept_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/repair/crossings.h"
#include "core/seams/stitching.h"
#include "geolloyd/evaluation.h"
#include "geolloyd/quality.h"

namespace geolloyd::zoo {
namespace {

constexpr std::size_t distance_samples = 50'000;
constexpr double flat = 1e-6;

// Of this process, all threads.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Of a closed mesh, from this vertex on.
double share_of_valence_6(const Mesh& mesh, std::size_t first) {
  std::vector<std::size_t> valence(mesh.vertex_count(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) ++valence[v];
  }
  const auto begin = valence.begin() + static_cast<std::ptrdiff_t>(first);
  const auto count = static_cast<double>(valence.end() - begin);
  return count > 0 ? static_cast<double>(std::count(begin, valence.end(), 6U)) / count : 1;
}

void judge_shape(const Mesh& mesh, const Truth& truth, const Remesh& remesh, Verdict& verdict) {
  const MeshTopology topology = find_topology(remesh.mesh);
  verdict.is_manifold = topology.is_manifold() && topology.inconsistent_edges == 0;
  verdict.has_topology = topology.parts == truth.parts;
  verdict.parts = topology.parts.size();
  for (const auto& [a, b, c] : remesh.mesh.triangles) {
    const auto& p = remesh.mesh.positions;
    verdict.flat += flatness(p[a], p[b], p[c]) > flat ? 0 : 1;
  }
  verdict.crossings = find_crossings(remesh.mesh).size();
  const MeshQuality found = quality(remesh.mesh);
  verdict.smallest_angle = found.smallest_angle;
  verdict.wanted_angle = std::min(20.0, 0.75 * truth.forced_angle);
  verdict.valence_6 = found.share_valence_6;
  verdict.valence_6_between = share_of_valence_6(remesh.mesh, remesh.curve_vertices);
  verdict.volume_error = enclosed_volume(remesh.mesh) / truth.volume - 1;
  verdict.hausdorff =
      measure_distance(mesh, remesh.mesh, distance_samples).two_sided().largest / diagonal_of(mesh);
}

}  // namespace

double diagonal_of(const Mesh& mesh) {
  Vec3 low = mesh.positions.front();
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return norm(high - low);
}

bool Verdict::is_sound() const {
  return is_manifold && has_topology && flat == 0;
}

bool Verdict::is_good() const {
  constexpr double most_error = 0.01;
  constexpr double least_kept = 0.99;
  constexpr std::size_t least_on_a_rim = 6;
  const auto most = static_cast<double>(wanted) * 1.05;
  return is_sound() && crossings == 0 && std::abs(volume_error) <= most_error &&
         hausdorff <= most_error && kept.value_or(1) >= least_kept &&
         least_on_rim.value_or(least_on_a_rim) >= least_on_a_rim &&
         smallest_angle >= wanted_angle && static_cast<double>(vertices) <= most;
}

bool Verdict::is_bad() const {
  constexpr double most_volume_error = 0.02;
  constexpr double most_distance = 0.03;
  return !is_sound() || std::abs(volume_error) > most_volume_error || hausdorff > most_distance;
}

Mesh welded(const Part& part) {
  Mesh mesh = part.mesh;
  if (part.is_split) rename_vertices(mesh, find_split_vertices(mesh));
  return mesh;
}

Verdict judge(const Part& part, std::size_t vertices) {
  const Mesh mesh = welded(part);
  RemeshOptions options;
  options.vertex_count = vertices;
  Verdict verdict;
  const double begin = processor_seconds();
  const Remesh made = remesh(mesh, options);
  verdict.seconds = processor_seconds() - begin;
  verdict.wanted = vertices;
  verdict.vertices = made.mesh.vertex_count();
  verdict.features = made.feature_edges.size();
  verdict.warnings = made.warnings;
  judge_shape(mesh, part.truth, made, verdict);
  const KeptEdges kept(part.truth, made.mesh, diagonal_of(mesh));
  verdict.kept = kept.share();
  verdict.least_on_rim = kept.least_on_rim();
  return verdict;
}

}  // namespace geolloyd::zoo

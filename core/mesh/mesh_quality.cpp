#include "core/mesh/mesh_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

// Edge i lies opposite to corner i.
std::array<double, 3> edge_lengths(const TriangleCorners& corners) {
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) {
    lengths[i] = norm(corners[(i + 2) % 3] - corners[(i + 1) % 3]);
  }
  return lengths;
}

// Right angles are not, however they are rounded.
bool is_obtuse(const TriangleCorners& corners) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 b = corners[(i + 1) % 3] - corners[i];
    const Vec3 c = corners[(i + 2) % 3] - corners[i];
    if (dot(b, c) < -rounding * norm(b) * norm(c)) return true;
  }
  return false;
}

void measure_triangles(const Mesh& mesh, std::span<const Metric> metric, MeshQuality& quality) {
  if (mesh.triangles.empty()) return;
  quality.smallest_angle = 60;
  quality.smallest_quality = 1;
  double angles = 0;
  double qualities = 0;
  double under_30 = 0;
  double obtuse = 0;
  for (const Triangle& t : mesh.triangles) {
    const TriangleCorners corners = corners_of(mesh, t, metric);
    const double angle = smallest_angle(corners);
    const double q = triangle_quality(corners);
    quality.smallest_angle = std::min(quality.smallest_angle, angle);
    quality.smallest_quality = std::min(quality.smallest_quality, q);
    angles += angle;
    qualities += q;
    if (angle < 30) ++under_30;
    if (is_obtuse(corners)) ++obtuse;
  }
  const auto count = static_cast<double>(mesh.triangle_count());
  quality.mean_smallest_angle = angles / count;
  quality.mean_quality = qualities / count;
  quality.share_under_30 = under_30 / count;
  quality.share_obtuse = obtuse / count;
}

void count_valences(const Mesh& mesh, const MeshEdges& edges, MeshQuality& quality) {
  std::vector<std::uint32_t> valence(mesh.vertex_count(), 0);
  std::vector<std::uint8_t> is_inner(mesh.vertex_count(), 1);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const VertexId v : edges.ends[e]) {
      ++valence[v];
      if (edges.corners(e).size() != 2) is_inner[v] = 0;
    }
  }
  std::size_t six = 0;
  std::size_t nearly_six = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0 || is_inner[v] == 0) continue;
    ++quality.inner_vertices;
    if (valence[v] == 6) ++six;
    if (valence[v] >= 5 && valence[v] <= 7) ++nearly_six;
  }
  if (quality.inner_vertices == 0) return;
  const auto count = static_cast<double>(quality.inner_vertices);
  quality.share_valence_6 = static_cast<double>(six) / count;
  quality.share_valence_5_to_7 = static_cast<double>(nearly_six) / count;
}

}  // namespace

TriangleCorners corners_of(const Mesh& mesh, const Triangle& triangle,
                           std::span<const Metric> metric) {
  const auto& [a, b, c] = triangle;
  TriangleCorners corners = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
  if (metric.empty()) return corners;
  const MetricRoot root((1.0 / 3) * (metric[a] + metric[b] + metric[c]));
  return {root(corners[0]), root(corners[1]), root(corners[2])};
}

// The arc tangent is exact also where the cosine hardly tells angles apart, and 0 without area.
double smallest_angle(const TriangleCorners& corners) {
  const std::array<double, 3> lengths = edge_lengths(corners);
  const auto apex =
      static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
  const Vec3& a = corners[apex];
  const Vec3 b = corners[(apex + 1) % 3] - a;
  const Vec3 c = corners[(apex + 2) % 3] - a;
  return std::atan2(norm(cross(b, c)), dot(b, c)) * (180 / std::numbers::pi);
}

double cosine_of_smallest_angle(const TriangleCorners& corners) {
  const Vec3 ab = normalized(corners[1] - corners[0]);
  const Vec3 bc = normalized(corners[2] - corners[1]);
  const Vec3 ca = normalized(corners[0] - corners[2]);
  return -std::min({dot(ab, bc), dot(bc, ca), dot(ca, ab)});
}

double triangle_quality(const TriangleCorners& corners) {
  const double area = norm(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
  if (area == 0) return 0;
  const auto [a, b, c] = edge_lengths(corners);
  return 6 / std::sqrt(3.0) * area / ((a + b + c) / 2 * std::max({a, b, c}));
}

std::size_t count_flat(const Mesh& mesh) {
  constexpr double least_flatness = 1e-6;
  const auto& p = mesh.positions;
  return static_cast<std::size_t>(std::count_if(
      mesh.triangles.begin(), mesh.triangles.end(),
      [&](const Triangle& t) { return !(flatness(p[t[0]], p[t[1]], p[t[2]]) >= least_flatness); }));
}

std::size_t count_folds(const Mesh& mesh, const MeshEdges& edges) {
  constexpr double cosine_150 = -0.8660254037844386;
  const auto normal = [&mesh](CornerId corner) {
    const auto& [a, b, c] = mesh.triangles[triangle_of(corner)];
    const auto& p = mesh.positions;
    return normalized(cross(p[b] - p[a], p[c] - p[a]));
  };
  std::size_t folds = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto corners = edges.corners(e);
    if (corners.size() != 2) continue;
    const bool is_consistent = edge_start(mesh, corners[0]) != edge_start(mesh, corners[1]);
    const double cosine = dot(normal(corners[0]), normal(corners[1]));
    if ((is_consistent ? cosine : -cosine) < cosine_150) ++folds;
  }
  return folds;
}

MeshQuality measure_quality(const Mesh& mesh, const MeshEdges& edges,
                            std::span<const Metric> metric) {
  MeshQuality quality;
  measure_triangles(mesh, metric, quality);
  count_valences(mesh, edges, quality);
  return quality;
}

MeshQuality quality(const Mesh& mesh) {
  validate_contents(mesh);
  return measure_quality(mesh, find_edges(mesh));
}

}  // namespace geolloyd

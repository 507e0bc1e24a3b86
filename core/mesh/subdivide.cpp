#include "core/mesh/subdivide.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// The edge opposite to each corner.
std::vector<std::uint32_t> edges_of_corners(const Mesh& mesh, const MeshEdges& edges) {
  std::vector<std::uint32_t> edge_of(3 * mesh.triangle_count(), no_id);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (const CornerId corner : edges.corners(e)) edge_of[corner] = e;
  }
  return edge_of;
}

// The mesh being built: it opens with the old vertices and the points that cut each edge in
// `frequency` equal parts. `inner_points` and `pieces` are counts per triangle.
class Subdivision {
 public:
  Subdivision(const Mesh& mesh, std::uint32_t frequency, std::uint64_t inner_points,
              std::uint64_t pieces)
      : mesh_(mesh), frequency_(frequency) {
    const MeshEdges edges = find_edges(mesh);
    reserve(edges.size(), inner_points, pieces);
    edge_of_ = edges_of_corners(mesh, edges);
    result_.positions = mesh.positions;
    for (const auto& [low, high] : edges.ends) {
      const Vec3& a = mesh.positions[low];
      const Vec3& b = mesh.positions[high];
      for (std::uint32_t k = 1; k < frequency; ++k) {
        add_point((a * (frequency - k) + b * k) / frequency);
      }
    }
  }

  /// The point `k` parts along the edge from one corner of a triangle to another; k = 0 and
  /// k = frequency are the corners themselves.
  [[nodiscard]] VertexId on_edge(TriangleId t, std::uint32_t from, std::uint32_t to,
                                 std::uint32_t k) const {
    const VertexId start = mesh_.triangles[t][from];
    const VertexId end = mesh_.triangles[t][to];
    if (k == 0) return start;
    if (k == frequency_) return end;
    const std::size_t edge = edge_of_[std::size_t{3} * t + (3 - from - to)];
    const std::uint32_t parts = start < end ? k : frequency_ - k;
    return static_cast<VertexId>(mesh_.vertex_count() + edge * (frequency_ - 1) + parts - 1);
  }

  VertexId add_point(const Vec3& position) {
    result_.positions.push_back(position);
    return static_cast<VertexId>(result_.positions.size() - 1);
  }

  void add_triangle(VertexId a, VertexId b, VertexId c) { result_.triangles.push_back({a, b, c}); }

  Mesh take() { return std::move(result_); }

 private:
  void reserve(std::size_t edges, std::uint64_t inner_points, std::uint64_t pieces) {
    const auto parents =
        std::count_if(mesh_.triangles.begin(), mesh_.triangles.end(), has_three_vertices);
    const auto count = static_cast<std::uint64_t>(parents);
    const Uint128 vertices =
        mesh_.vertex_count() + Uint128{edges} * (frequency_ - 1) + Uint128{count} * inner_points;
    const Uint128 triangles = Uint128{count} * pieces;
    if (!ids_suffice(vertices, triangles)) {
      throw InvalidInput(
          "subdivision: the result would need ids beyond 32 bits; take a coarser mesh or fewer "
          "pieces");
    }
    result_.positions.reserve(static_cast<std::size_t>(vertices));
    result_.triangles.reserve(static_cast<std::size_t>(triangles));
  }

  const Mesh& mesh_;
  std::uint32_t frequency_;
  std::vector<std::uint32_t> edge_of_;
  Mesh result_;
};

// The grid points of a triangle in the row `row` parts away from its corner 0, from the edge to
// corner 1 over to the edge to corner 2.
void find_row(const Mesh& mesh, TriangleId t, std::uint32_t frequency, std::uint32_t row,
              Subdivision& fine, std::vector<VertexId>& ids) {
  ids.clear();
  if (row == frequency) {
    for (std::uint32_t k = 0; k <= row; ++k) ids.push_back(fine.on_edge(t, 1, 2, k));
    return;
  }
  ids.push_back(fine.on_edge(t, 0, 1, row));
  const auto& [a, b, c] = mesh.triangles[t];
  for (std::uint32_t k = 1; k < row; ++k) {
    ids.push_back(fine.add_point((mesh.positions[a] * (frequency - row) +
                                  mesh.positions[b] * (row - k) + mesh.positions[c] * k) /
                                 frequency));
  }
  if (row > 0) ids.push_back(fine.on_edge(t, 0, 2, row));
}

}  // namespace

Mesh refine(const Mesh& mesh, std::uint32_t frequency) {
  if (frequency == 0) throw InvalidInput("subdivision: the frequency must be at least 1");
  const std::uint64_t f = frequency;
  Subdivision fine(mesh, frequency, f < 3 ? 0 : (f - 1) * (f - 2) / 2, f * f);
  std::vector<VertexId> above;
  std::vector<VertexId> below;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (!has_three_vertices(mesh.triangles[t])) continue;
    find_row(mesh, t, frequency, 0, fine, above);
    for (std::uint32_t row = 1; row <= frequency; ++row, std::swap(above, below)) {
      find_row(mesh, t, frequency, row, fine, below);
      for (std::uint32_t k = 0; k < row; ++k) {
        if (k > 0) fine.add_triangle(above[k - 1], below[k], above[k]);
        fine.add_triangle(above[k], below[k], below[k + 1]);
      }
    }
  }
  return fine.take();
}

Mesh subdivide_midpoint(const Mesh& mesh) {
  return refine(mesh, 2);
}

Mesh subdivide_barycentric(const Mesh& mesh) {
  Subdivision fine(mesh, 2, 1, 6);
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (!has_three_vertices(corners)) continue;
    const auto& [a, b, c] = corners;
    const VertexId centre =
        fine.add_point((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t next = (i + 1) % 3;
      const VertexId middle = fine.on_edge(t, i, next, 1);
      fine.add_triangle(corners[i], middle, centre);
      fine.add_triangle(middle, corners[next], centre);
    }
  }
  return fine.take();
}

}  // namespace geolloyd

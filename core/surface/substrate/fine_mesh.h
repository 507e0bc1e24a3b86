#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/bounding_box.h"
#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/metric.h"

namespace geolloyd {

/// The cube of the unit frame.
inline BoundingBox unit_box() {
  return {Vec3::Constant(-1), Vec3::Constant(1)};
}

/// A triangle mesh in the unit frame, ready for sweeps and cuts. Vertices are in the spatial order
/// of the unit frame, so that what is near in space is near in memory; triangles in the order of
/// their smallest vertices.
struct FineMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<double> inverse_sizing;  ///< per vertex: how many times shorter than the spacing
                                       ///< edges are to be there; empty: 1 everywhere
  std::vector<Metric> metric;         ///< per vertex, with the determinant 1 along the surface: the
                                      ///< shape of cells there; empty: they are round
  std::vector<Triangle> across_open;  ///< per corner: the vertex beyond the edge opposite to it, or
                                      ///< no_id where that edge is not open: it does not have two
                                      ///< triangles, or is closed (close_edges())
  std::vector<std::uint32_t> first_neighbour;  ///< per vertex, and one more
  std::vector<VertexId> neighbour;             ///< of each vertex, ascending
  std::vector<std::uint32_t> first_triangle;   ///< per vertex, and one more
  std::vector<TriangleId> triangle_at;         ///< around each vertex, ascending
  double whole_area = 0;
  double whole_sized_area = 0;
  double whole_mass = 0;
  double largest_trace = 1;  ///< of the metric, at least 1

  [[nodiscard]] std::size_t vertex_count() const { return positions.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size(); }
  [[nodiscard]] std::span<const VertexId> neighbours(VertexId v) const {
    return {neighbour.data() + first_neighbour[v], neighbour.data() + first_neighbour[v + 1]};
  }
  [[nodiscard]] std::span<const TriangleId> triangles_at(VertexId v) const {
    return {triangle_at.data() + first_triangle[v], triangle_at.data() + first_triangle[v + 1]};
  }
  [[nodiscard]] double inverse_sizing_at(VertexId v) const {
    return inverse_sizing.empty() ? 1 : inverse_sizing[v];
  }
  /// The inverse sizing in the direction in which a cell there is narrowest.
  [[nodiscard]] double finest_at(VertexId v) const {
    return metric.empty() ? inverse_sizing_at(v)
                          : inverse_sizing_at(v) * metric[v].largest_stretch();
  }
  /// The mean of its corners'.
  [[nodiscard]] double inverse_sizing_of(TriangleId t) const {
    const auto& [a, b, c] = triangles[t];
    return inverse_sizing.empty() ? 1
                                  : (inverse_sizing[a] + inverse_sizing[b] + inverse_sizing[c]) / 3;
  }
  /// Found anew each time: whoever asks has its corners at hand, and a table would be large.
  [[nodiscard]] double area(TriangleId t) const {
    const auto& [a, b, c] = triangles[t];
    return norm(cross(positions[b] - positions[a], positions[c] - positions[a])) / 2;
  }
  /// The mean of its corners'. Of a mesh with a metric.
  [[nodiscard]] Metric metric_of(TriangleId t) const {
    const auto& [a, b, c] = triangles[t];
    return (1.0 / 3) * (metric[a] + metric[b] + metric[c]);
  }
  /// An edge's length in the metric, times the inverse sizing: in spacings, if the spacing is 1.
  [[nodiscard]] double sized_length(VertexId a, VertexId b) const {
    return length_between(a, b, positions[b] - positions[a]) *
           ((inverse_sizing_at(a) + inverse_sizing_at(b)) / 2);
  }
  /// Of a displacement near two vertices, in their mean metric.
  [[nodiscard]] double length_between(VertexId a, VertexId b, const Vec3& displacement) const {
    return metric.empty() ? norm(displacement)
                          : (0.5 * (metric[a] + metric[b])).length(displacement);
  }
  /// Of a displacement from or to a vertex, in its metric.
  [[nodiscard]] double square_at(VertexId v, const Vec3& displacement) const {
    return metric.empty() ? dot(displacement, displacement) : metric[v].square(displacement);
  }
  /// A triangle's area in proportion to the number of cells on it.
  [[nodiscard]] double sized_area(TriangleId t) const {
    const double r = inverse_sizing_of(t);
    return area(t) * (r * r);
  }
  /// By which the energy counts a triangle: its area times a density, the fourth power of the
  /// inverse sizing, because the cells of a centroidal tessellation of the plane have sizes in
  /// proportion to density^(-1/4) (Du, Faber and Gunzburger 1999, 6.4; Newman 1982).
  [[nodiscard]] double mass(TriangleId t) const {
    const double r = inverse_sizing_of(t);
    return area(t) * ((r * r) * (r * r));
  }
};

/// Positions, triangles and inverse sizing are there already; fills in what follows from them. All
/// edges with two triangles are open.
void connect(FineMesh& mesh, Executor& executor = sequential());

/// What follows from another inverse sizing: the sums over all triangles.
void find_whole(FineMesh& mesh, Executor& executor = sequential());

/// Closes edges (ascending within), such as those of features: the free sites beyond them have no
/// share of the triangles before them. `across_open` leaves them out from then on.
void close_edges(FineMesh& mesh, std::span<const std::array<VertexId, 2>> edges);

}  // namespace geolloyd

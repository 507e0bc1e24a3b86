#include "core/fields/curvature_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/base/buffer.h"
#include "core/base/loops.h"
#include "core/base/vec3.h"
#include "core/fields/principal_direction.h"
#include "core/fields/tangent_plane.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

constexpr int smoothing_rounds = 16;
constexpr double widest_range = 32;  // of curvatures, about their mean
constexpr double flat = 1e-3;        // mean curvature, times the surface's size

// Curvature by direction: (size + p, q; q, size - p) in the axes of a vertex.
struct Tensor {
  double size = 0;
  double p = 0;
  double q = 0;

  [[nodiscard]] double stretch() const { return std::sqrt(p * p + q * q); }
};

// How a neighbour's tensor is written in the axes of a vertex after transport: turned by an angle,
// of which these are the cosine and sine of the double. Where normals face away from each other one
// is negated, and with it the tensor and the second axis.
struct Passage {
  VertexId from;
  bool is_reversed;
  double cosine;
  double sine;

  [[nodiscard]] Tensor of(const Tensor& t) const {
    const double size = is_reversed ? -t.size : t.size;
    const double p = is_reversed ? -t.p : t.p;
    return {size, p * cosine - t.q * sine, p * sine + t.q * cosine};
  }
};

class CurvatureTensors {
 public:
  CurvatureTensors(const Mesh& mesh, const MeshEdges& edges,
                   const Bucketed<std::uint32_t>& edges_at, Executor& executor)
      : mesh_(mesh),
        edges_(edges),
        edges_at_(edges_at),
        executor_(executor),
        area_(vertex_areas(mesh, edges.duplicates)) {
    find_normals();
    tensor_.resize(mesh.vertex_count());
    for_vertices([&](VertexId v) { tensor_[v] = measured(v); });
    smooth();
  }

  [[nodiscard]] double area(VertexId v) const { return area_[v]; }
  [[nodiscard]] const Tensor& tensor(VertexId v) const { return tensor_[v]; }
  [[nodiscard]] const PlaneAxes& axes(VertexId v) const { return axes_[v]; }

 private:
  template <class Visit>
  void for_vertices(Visit&& visit) {
    parallel_for(executor_, mesh_.vertex_count(), small_items,
                 [&](std::size_t v) { visit(static_cast<VertexId>(v)); });
  }

  [[nodiscard]] bool turns_around(std::span<const CornerId> corners) const {
    return edge_start(mesh_, corners[0]) == edge_start(mesh_, corners[1]);
  }

  [[nodiscard]] bool has_one_orientation() const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto corners = edges_.corners(e);
      if (corners.size() == 2 && turns_around(corners)) return false;
    }
    return true;
  }

  // As long as twice the area.
  [[nodiscard]] Vec3 triangle_normal(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    const std::vector<Vec3>& p = mesh_.positions;
    return cross(p[b] - p[a], p[c] - p[a]);
  }

  // Of a vertex without a normal, any axes.
  void find_normals() {
    is_oriented_ = has_one_orientation();
    normal_.assign(mesh_.vertex_count(), Vec3::Zero());
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      if (!has_three_vertices(mesh_.triangles[t])) continue;
      const Vec3 own = triangle_normal(t);
      for (const VertexId v : mesh_.triangles[t]) {
        const bool is_away = !is_oriented_ && dot(own, normal_[v]) < 0;
        normal_[v] += is_away ? Vec3(-own) : own;
      }
    }
    axes_.resize(mesh_.vertex_count());
    for_vertices([&](VertexId v) {
      normal_[v] = normalized(normal_[v]);
      if (normal_[v] == Vec3::Zero()) {
        area_[v] = 0;
        axes_[v] = {Vec3::UnitX(), Vec3::UnitY()};
      } else {
        axes_[v] = plane_axes(normal_[v]);
      }
    });
  }

  // Chord between the unit normals at an edge, positive where the surface is convex as the vertex
  // sees it.
  [[nodiscard]] double bend(std::span<const CornerId> corners, VertexId v) const {
    const Vec3 near = normalized(triangle_normal(triangle_of(corners[0])));
    Vec3 far = normalized(triangle_normal(triangle_of(corners[1])));
    if (near == Vec3::Zero() || far == Vec3::Zero()) return 0;
    if (turns_around(corners)) far = -far;
    const Vec3 beyond =
        mesh_.positions[apex(mesh_, corners[1])] - mesh_.positions[edge_start(mesh_, corners[0])];
    const bool is_convex = dot(near, beyond) < 0;
    const bool is_seen_from_behind = !is_oriented_ && dot(near, normal_[v]) < 0;
    return is_convex != is_seen_from_behind ? norm(far - near) : -norm(far - near);
  }

  // Half of each edge is at either end; what it bends is the direction across.
  [[nodiscard]] Tensor measured(VertexId v) const {
    Tensor sum;
    if (!(area_[v] > 0)) return sum;
    for (const std::uint32_t e : edges_at_[v]) {
      const auto corners = edges_.corners(e);
      if (corners.size() != 2) continue;
      const auto& [a, b] = edges_.ends[e];
      const Vec3 edge = mesh_.positions[b] - mesh_.positions[a];
      const Vec3 across = normalized(cross(normal_[v], edge));
      const double share = bend(corners, v) * norm(edge) / 2 / area_[v];
      const double x = dot(across, axes_[v].first);
      const double y = dot(across, axes_[v].second);
      sum.size += share / 2;
      sum.p += share * (x * x - y * y) / 2;
      sum.q += share * x * y;
    }
    return sum;
  }

  [[nodiscard]] Passage passage(VertexId from, VertexId to) const {
    const bool is_reversed = dot(normal_[from], normal_[to]) < 0;
    const Vec3 normal = is_reversed ? Vec3(-normal_[from]) : normal_[from];
    const Vec3 first = transported(axes_[from].first, normal, normal_[to]);
    const double x = dot(first, axes_[to].first);
    const double y = dot(first, axes_[to].second);
    return {from, is_reversed, x * x - y * y, 2 * x * y};
  }

  // Half itself, half the mean of the neighbours, by their areas.
  void smooth() {
    Buffer<Passage> passages(edges_at_.entry.size());
    const std::uint32_t* const first = edges_at_.entry.data();
    for_vertices([&](VertexId v) {
      for (const std::uint32_t& e : edges_at_[v]) {
        const auto& [a, b] = edges_.ends[e];
        passages.data()[&e - first] = passage(a == v ? b : a, v);
      }
    });
    std::vector<Tensor> before(tensor_.size());
    for (int round = 0; round < smoothing_rounds; ++round) {
      std::swap(before, tensor_);
      for_vertices([&](VertexId v) {
        Tensor sum;
        double weight = 0;
        const auto own = edges_at_[v];
        for (const Passage& way : std::span(passages.data() + (own.data() - first), own.size())) {
          const Tensor t = way.of(before[way.from]);
          const double share = area_[way.from];
          sum.size += share * t.size;
          sum.p += share * t.p;
          sum.q += share * t.q;
          weight += share;
        }
        tensor_[v] = before[v];
        if (!(weight > 0) || !(area_[v] > 0)) return;
        tensor_[v] = {(before[v].size + sum.size / weight) / 2, (before[v].p + sum.p / weight) / 2,
                      (before[v].q + sum.q / weight) / 2};
      });
    }
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const Bucketed<std::uint32_t>& edges_at_;
  Executor& executor_;
  bool is_oriented_ = true;
  std::vector<double> area_;  // per vertex; 0 where there is no normal
  std::vector<Vec3> normal_;
  std::vector<PlaneAxes> axes_;
  std::vector<Tensor> tensor_;
};

// Over the surface, of the root of the mean square of the two curvatures.
double mean_curvature(const CurvatureTensors& tensors, std::size_t vertices, double whole_area) {
  double sum = 0;
  for (VertexId v = 0; v < vertices; ++v) {
    const Tensor& t = tensors.tensor(v);
    sum += tensors.area(v) * std::sqrt(t.size * t.size + t.p * t.p + t.q * t.q);
  }
  return sum / whole_area;
}

}  // namespace

std::vector<TangentSpace> curvature_field(const Mesh& mesh, const MeshEdges& edges,
                                          Executor& executor) {
  return curvature_field(mesh, edges, edges_at_vertices(mesh.vertex_count(), edges, executor),
                         executor);
}

std::vector<TangentSpace> curvature_field(const Mesh& mesh, const MeshEdges& edges,
                                          const Bucketed<std::uint32_t>& edges_at,
                                          Executor& executor) {
  const CurvatureTensors tensors(mesh, edges, edges_at, executor);
  const std::size_t count = mesh.vertex_count();
  double whole_area = 0;
  for (VertexId v = 0; v < count; ++v) whole_area += tensors.area(v);
  const double mean = whole_area > 0 ? mean_curvature(tensors, count, whole_area) : 0;
  const bool is_flat = !(mean * std::sqrt(whole_area) > flat);

  const auto magnitude = [&](double curvature) {
    const double relative = std::min(std::abs(curvature) / mean, widest_range);
    return std::sqrt(std::sqrt(relative * relative + 1 / (widest_range * widest_range)));
  };
  std::vector<TangentSpace> field(count);
  parallel_for(executor, count, small_items, [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    const Tensor& t = tensors.tensor(v);
    const auto& [first, second] = tensors.axes(v);
    field[v] = {first, second, 1, 1};
    if (is_flat || !(tensors.area(v) > 0)) return;
    // The larger of |size + stretch| and |size - stretch| has the sign of `size`.
    const double sign = t.size < 0 ? -1 : 1;
    const auto [cosine, sine] = principal_direction(sign * t.p, sign * t.q);
    const double larger = magnitude(std::abs(t.size) + t.stretch());
    const double smaller = magnitude(std::abs(t.size) - t.stretch());
    field[v] = {cosine * first + sine * second, cosine * second - sine * first, larger,
                std::max(smaller, larger / most_stretch)};
  });

  double metric_area = 0;
  for (VertexId v = 0; v < count; ++v) {
    metric_area += tensors.area(v) * field[v].tangent_magnitude * field[v].bitangent_magnitude;
  }
  const double scale = metric_area > 0 ? std::sqrt(whole_area / metric_area) : 1;
  for (TangentSpace& space : field) {
    space.tangent_magnitude *= scale;
    space.bitangent_magnitude *= scale;
  }
  return field;
}

}  // namespace geolloyd

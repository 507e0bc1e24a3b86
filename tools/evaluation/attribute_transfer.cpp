#include "tools/evaluation/attribute_transfer.h"

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "core/base/loops.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/properties/properties.h"
#include "core/properties/property_mixture.h"
#include "tools/evaluation/distances/point_queries.h"

namespace geolloyd {
namespace {

constexpr std::size_t queries_at_a_time = 64;

class Carrier {
 public:
  Carrier(const Mesh& mesh, const Properties& properties, Executor& executor)
      : mesh_(mesh),
        properties_(properties),
        corners_(value_triangles(mesh, properties)),
        executor_(executor) {}

  /// mixture(i): what vertex i of the remesh is made of.
  template <class MixtureOf>
  Properties carry(const Mesh& remesh, MixtureOf&& mixture_of) {
    Properties carried;
    carried.left_out = properties_.left_out;
    if (!properties_.corner_values.empty()) carried.left_out.emplace_back(one_side_of_seams);
    if (!properties_.of_vertices.empty()) {
      std::vector<Mixture> mixtures(remesh.vertex_count());
      parallel_for(executor_, mixtures.size(), queries_at_a_time,
                   [&](std::size_t v) { mixtures[v] = mixture_of(v); });
      carried.of_vertices = mix(properties_.of_vertices, mixtures, executor_);
    }
    if (!properties_.of_triangles.empty()) {
      std::vector<Mixture> mixtures(remesh.triangle_count());
      find_surface();
      parallel_for(executor_, mixtures.size(), queries_at_a_time,
                   [&](std::size_t t) { mixtures[t] = triangles_below(remesh, t); });
      carried.of_triangles = mix(properties_.of_triangles, mixtures, executor_);
    }
    return carried;
  }

  /// Before any point is looked for.
  void find_surface() {
    if (!surface_) surface_.emplace(mesh_, executor_.threads());
  }

  [[nodiscard]] Mixture closest_to(const Vec3& p) const {
    const TriangleId triangle = surface_->find(p).triangle;
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const auto [v, w] = barycentric_closest_to_origin(
        {mesh_.positions[a] - p, mesh_.positions[b] - p, mesh_.positions[c] - p});
    const double u = 1 - v - w;
    return mixture_at(corners_, {triangle, {u > 0 ? u : 0, v, w}});
  }

 private:
  // Of its quarters: one has the same middle as it, and one lies at each corner.
  [[nodiscard]] Mixture triangles_below(const Mesh& remesh, std::size_t t) const {
    std::array<Vec3, 3> corner;
    for (std::size_t c = 0; c < 3; ++c) corner[c] = remesh.positions[remesh.triangles[t][c]];
    const Vec3 middle = (corner[0] + corner[1] + corner[2]) / 3;
    Mixture mixture{};
    mixture[0] = {surface_->find(middle).triangle, 0.25};
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 p = (corner[c] + middle) / 2;
      mixture[c + 1] = {surface_->find(p, mixture[0].item).triangle, 0.25};
    }
    return mixture;
  }

  const Mesh& mesh_;
  const Properties& properties_;
  std::span<const Triangle> corners_;
  Executor& executor_;
  std::optional<ClosestPoint> surface_;
};

Mixture mixture_of_seed(std::span<const Triangle> triangles, const MeshGraph& mesh_graph,
                        NodeId seed) {
  const InputId id = mesh_graph.input_id[seed];
  if (!mesh_graph.is_triangle(id)) return {{{id, 1}}};
  constexpr double third = 1.0 / 3;
  const auto triangle = static_cast<TriangleId>(id - mesh_graph.first_triangle_id);
  return mixture_at(triangles, {triangle, {third, third, third}});
}

}  // namespace

Properties transfer_properties(const Mesh& mesh, const Properties& properties, const Remesh& remesh,
                               Executor& executor) {
  const std::span<const Triangle> corners = value_triangles(mesh, properties);
  return Carrier(mesh, properties, executor).carry(remesh.mesh, [&](std::size_t v) {
    return mixture_at(corners, remesh.places[v]);
  });
}

Properties transfer_properties(const Mesh& mesh, const Properties& properties,
                               const MeshGraph& mesh_graph, const GraphDual& remesh,
                               Executor& executor) {
  Carrier carrier(mesh, properties, executor);
  const std::span<const Triangle> corners = value_triangles(mesh, properties);
  const auto is_at_seed = [&](std::size_t v) {
    return remesh.mesh.positions[v] == mesh_graph.position[remesh.seeds[v]];
  };
  for (std::size_t v = 0; v < remesh.seeds.size() && !properties.of_vertices.empty(); ++v) {
    if (!is_at_seed(v)) carrier.find_surface();
  }
  return carrier.carry(remesh.mesh, [&](std::size_t v) {
    return is_at_seed(v) ? mixture_of_seed(corners, mesh_graph, remesh.seeds[v])
                         : carrier.closest_to(remesh.mesh.positions[v]);
  });
}

}  // namespace geolloyd

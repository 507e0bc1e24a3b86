#include "core/mesh_graph.h"

#include <string>
#include <utility>

#include "core/errors.h"
#include "core/mesh_measure.h"
#include "core/spatial_order.h"

namespace geolloyd {
namespace {

// A node's place while its arcs are measured.
struct Place {
  NodeId node;
  Vec3 position;
  const TangentSpace* space;  // null in the isotropic metric
};

class LinkBuilder {
 public:
  LinkBuilder(const Mesh& mesh, const MeshEdges& edges, const MeshGraphOptions& options,
              const MeshGraph& target)
      : mesh_(mesh), edges_(edges), options_(options), target_(target) {
    if (!options.vertex_space.empty()) {
      triangle_space_ = triangle_spaces(mesh, options.vertex_space);
    }
  }

  std::vector<Link> build() {
    const GraphKind kind = options_.kind;
    if (kind == GraphKind::triangle_dense) find_fans();
    reserve();
    if (has_vertices(kind)) link_along_edges();
    if (kind == GraphKind::vertex_dense) link_opposite_vertices();
    if (has_triangles(kind)) link_adjacent_triangles();
    if (kind == GraphKind::triangle_dense) link_fans();
    if (kind == GraphKind::mixed) link_corners();
    return std::move(links_);
  }

 private:
  static std::uint64_t pairs(std::uint64_t count) { return count * (count - 1) / 2; }

  // Many triangles at one edge or vertex make arcs by the square of their number: count before
  // taking memory.
  void reserve() {
    std::uint64_t count = 0;
    if (has_vertices(options_.kind)) count += edges_.size();
    if (options_.kind == GraphKind::mixed) count += 3 * mesh_.triangle_count();
    if (options_.kind != GraphKind::vertex) {
      for (std::size_t e = 0; e < edges_.size(); ++e) count += pairs(edges_.corners(e).size());
    }
    for (std::size_t v = 0; v + 1 < first_in_fan_.size(); ++v) {
      count += pairs(first_in_fan_[v + 1] - first_in_fan_[v]);
    }
    if (2 * count > most_arcs) {
      throw InvalidInput("the graph would have " + std::to_string(2 * count) +
                         " arcs, more than fit, because very many triangles share an edge or a "
                         "vertex: use --graph vertex");
    }
    links_.reserve(count);
  }

  // In the graphs of triangles a vertex has a place but no node.
  [[nodiscard]] Place vertex(VertexId v) const {
    return {has_vertices(options_.kind) ? target_.node_of[v] : no_id, mesh_.positions[v],
            options_.vertex_space.empty() ? nullptr : &options_.vertex_space[v]};
  }

  [[nodiscard]] Place triangle(TriangleId t) const {
    return {target_.node_of[target_.first_triangle_id + t], barycentre(mesh_, t),
            triangle_space_.empty() ? nullptr : &triangle_space_[t]};
  }

  // Length of a way from a to b whose isotropic length is known: its displacement is taken as the
  // chord's direction with that length. A way between two places that coincide in space (a closed
  // fold) has no direction, and keeps its isotropic length.
  [[nodiscard]] double length(const Place& a, const Place& b, double isotropic) const {
    const bool in_field = a.space != nullptr && b.space != nullptr;
    if (!in_field && options_.norm == Norm::geodesic) return isotropic;
    const Vec3 chord = b.position - a.position;
    const double chord_length = geolloyd::norm(chord);
    if (chord_length == 0) return isotropic;
    const Vec3 displacement = chord * (isotropic / chord_length);
    return in_field ? measure(displacement, average(*a.space, *b.space), options_.norm)
                    : measure(displacement, options_.norm);
  }

  [[nodiscard]] double straight_length(const Place& a, const Place& b) const {
    return length(a, b, geolloyd::norm(b.position - a.position));
  }

  void link_along_edges() {
    for (const auto& [a, b] : edges_.ends) {
      links_.push_back(
          {target_.node_of[a], target_.node_of[b], straight_length(vertex(a), vertex(b))});
    }
  }

  template <class PlaceOfCorner>
  void link_across_edges(PlaceOfCorner&& place) {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto corners = edges_.corners(e);
      const Vec3& e0 = mesh_.positions[edges_.ends[e][0]];
      const Vec3& e1 = mesh_.positions[edges_.ends[e][1]];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place a = place(corners[i]);
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
          const Place b = place(corners[j]);
          const double isotropic = unfolded_distance(a.position, b.position, e0, e1);
          links_.push_back({a.node, b.node, length(a, b, isotropic)});
        }
      }
    }
  }

  void link_opposite_vertices() {
    link_across_edges([this](CornerId corner) { return vertex(apex(mesh_, corner)); });
  }

  void link_adjacent_triangles() {
    link_across_edges([this](CornerId corner) { return triangle(triangle_of(corner)); });
  }

  [[nodiscard]] double leg(CornerId corner) const {
    return straight_length(triangle(triangle_of(corner)), vertex(apex(mesh_, corner)));
  }

  void find_fans() {
    first_in_fan_.assign(mesh_.vertex_count() + 1, 0);
    for_each_corner(mesh_, [&](CornerId corner) { ++first_in_fan_[apex(mesh_, corner) + 1]; });
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      first_in_fan_[v + 1] += first_in_fan_[v];
    }
    fan_.resize(first_in_fan_.back());
    std::vector<std::uint32_t> next(first_in_fan_.begin(), first_in_fan_.end() - 1);
    for_each_corner(mesh_, [&](CornerId corner) { fan_[next[apex(mesh_, corner)]++] = corner; });
  }

  void link_fans() {
    std::vector<double> legs;
    for (VertexId v = 0; v < mesh_.vertex_count(); ++v) {
      const std::uint32_t begin = first_in_fan_[v];
      const std::uint32_t end = first_in_fan_[v + 1];
      legs.clear();
      for (std::uint32_t i = begin; i < end; ++i) legs.push_back(leg(fan_[i]));
      for (std::uint32_t i = begin; i < end; ++i) {
        const NodeId a = target_.node_of[triangle_of(fan_[i])];
        for (std::uint32_t j = i + 1; j < end; ++j) {
          links_.push_back(
              {a, target_.node_of[triangle_of(fan_[j])], legs[i - begin] + legs[j - begin]});
        }
      }
    }
  }

  void link_corners() {
    for_each_corner(mesh_, [&](CornerId corner) {
      const NodeId node = target_.node_of[target_.first_triangle_id + triangle_of(corner)];
      links_.push_back({node, target_.node_of[apex(mesh_, corner)], leg(corner)});
    });
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const MeshGraphOptions& options_;
  const MeshGraph& target_;
  std::vector<TangentSpace> triangle_space_;
  std::vector<std::uint32_t> first_in_fan_;  // per vertex, and one more: into fan_
  std::vector<CornerId> fan_;                // corners at each vertex
  std::vector<Link> links_;
};

std::vector<std::uint32_t> used_input_ids(const Mesh& mesh, const MeshGraph& target) {
  std::vector<std::uint32_t> used;
  if (has_vertices(target.kind)) {
    const std::vector<bool> referenced = referenced_vertices(mesh);
    for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
      if (referenced[v]) used.push_back(v);
    }
  }
  if (has_triangles(target.kind)) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      if (!has_three_vertices(mesh.triangles[t])) continue;
      used.push_back(static_cast<std::uint32_t>(target.first_triangle_id + t));
    }
  }
  return used;
}

std::size_t id_count(const Mesh& mesh, GraphKind kind) {
  return (has_vertices(kind) ? mesh.vertex_count() : 0) +
         (has_triangles(kind) ? mesh.triangle_count() : 0);
}

void number_nodes(const Mesh& mesh, MeshGraph& target) {
  const std::vector<std::uint32_t> used = used_input_ids(mesh, target);
  std::vector<Vec3> positions;
  positions.reserve(used.size());
  for (const std::uint32_t id : used) {
    positions.push_back(
        target.is_triangle(id)
            ? barycentre(mesh, static_cast<TriangleId>(id - target.first_triangle_id))
            : mesh.positions[id]);
  }
  target.node_of.assign(id_count(mesh, target.kind), no_id);
  target.input_id.reserve(used.size());
  target.position.reserve(used.size());
  for (const std::uint32_t i : spatial_order(positions)) {
    target.node_of[used[i]] = static_cast<NodeId>(target.input_id.size());
    target.input_id.push_back(used[i]);
    target.position.push_back(positions[i]);
  }
}

std::vector<double> node_masses(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& target) {
  const std::vector<double> of_triangle = triangle_areas(mesh, duplicate_triangles(mesh, edges));
  const std::vector<double> of_vertex = vertex_areas(mesh, of_triangle);
  std::vector<double> masses;
  masses.reserve(target.input_id.size());
  for (const std::uint32_t id : target.input_id) {
    masses.push_back(target.is_triangle(id) ? of_triangle[id - target.first_triangle_id]
                                            : of_vertex[id]);
  }
  return masses;
}

}  // namespace

MeshGraph make_mesh_graph(const Mesh& mesh, const MeshEdges& edges,
                          const MeshGraphOptions& options) {
  MeshGraph result;
  result.kind = options.kind;
  result.first_triangle_id = has_vertices(options.kind) ? mesh.vertex_count() : 0;
  if (id_count(mesh, options.kind) >= no_id) {
    throw InvalidInput("the mesh has more vertices and triangles than 32-bit ids can count");
  }
  number_nodes(mesh, result);
  if (result.input_id.empty()) {
    throw InvalidInput(
        "no triangle of the mesh has three different vertices: nothing to tessellate");
  }
  const std::vector<Link> links = LinkBuilder(mesh, edges, options, result).build();
  result.graph = make_graph(links, node_masses(mesh, edges, result));
  return result;
}

}  // namespace geolloyd

#pragma once

#include <span>
#include <vector>

#include "core/base/grouping.h"
#include "core/graph/graph_on.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {

/// A node's place while its arcs are measured.
struct Place {
  NodeId node;
  Vec3 position;
  const TangentSpace* space;  ///< null in the isotropic metric
};

/// Length of a way from a to b whose isotropic length is known: its displacement is taken as the
/// chord's direction with that length. A way between two places that coincide in space (a closed
/// fold) has no direction, and keeps its isotropic length.
double length_in_metric(const Place& a, const Place& b, double isotropic, Norm norm_kind);
double straight_length(const Place& a, const Place& b, Norm norm_kind);

/// Pairs of `count` things.
inline std::uint64_t pairs(std::uint64_t count) {
  return count * (count - 1) / 2;
}

/// Makes the links of a mesh graph whose nodes have been numbered.
template <class Executor>
class LinkBuilder {
 public:
  LinkBuilder(Executor& executor, const Mesh& mesh, const MeshEdges& edges,
              const MeshGraphOptions& options, const MeshGraph& target)
      : executor_(executor), mesh_(mesh), edges_(edges), options_(options), target_(target) {
    if (has_triangles(options.kind) && !options.vertex_space.empty()) {
      triangle_space_.resize(mesh.triangle_count());
      for_items(executor, mesh.triangle_count(), small_items, [&](std::size_t t) {
        triangle_space_[t] = triangle_space(mesh.triangles[t], options.vertex_space);
      });
    }
  }

  /// Many triangles at one edge or vertex make links by the square of their number: they are
  /// counted before any memory is taken.
  Buffer<Link> build() {
    const GraphKind kind = options_.kind;
    if (kind == GraphKind::triangle_dense) find_fans();
    const Packing along(executor_, has_vertices(kind) ? edges_.size() : 0,
                        [](std::size_t) { return std::uint64_t{1}; });
    const Packing across(executor_, kind != GraphKind::vertex ? edges_.size() : 0,
                         [this](std::size_t e) { return pairs(edges_.corners(e).size()); });
    const Packing fans(executor_, fans_.size(),
                       [this](std::size_t v) { return pairs(fans_[v].size()); });
    const Packing spokes(executor_, kind == GraphKind::mixed ? mesh_.triangle_count() : 0,
                         [this](std::size_t t) {
                           return std::uint64_t{has_three_vertices(mesh_.triangles[t]) ? 3U : 0U};
                         });
    check_link_count(along.total() + across.total() + fans.total() + spokes.total());

    Buffer<Link> links(along.total() + across.total() + fans.total() + spokes.total());
    Link* first = links.data();
    along.for_each(executor_, [&](std::size_t e, std::uint64_t i) { link_along(e, first + i); });
    first += along.total();
    across.for_each(executor_, [&](std::size_t e, std::uint64_t i) { link_across(e, first + i); });
    first += across.total();
    fans.for_each(executor_, [&](std::size_t v, std::uint64_t i) { link_fan(v, first + i); });
    first += fans.total();
    spokes.for_each(executor_, [&](std::size_t t, std::uint64_t i) { link_spokes(t, first + i); });
    return links;
  }

 private:
  // In the graphs of triangles a vertex has a place but no node.
  [[nodiscard]] Place vertex(VertexId v) const {
    return {has_vertices(options_.kind) ? target_.node_of[v] : no_id, mesh_.positions[v],
            options_.vertex_space.empty() ? nullptr : &options_.vertex_space[v]};
  }

  [[nodiscard]] NodeId triangle_node(TriangleId t) const {
    return target_.node_of[target_.first_triangle_id + t];
  }

  [[nodiscard]] Place triangle(TriangleId t) const {
    const NodeId node = triangle_node(t);
    return {node, target_.position[node], triangle_space_.empty() ? nullptr : &triangle_space_[t]};
  }

  void link_along(std::size_t edge, Link* link) const {
    const Place a = vertex(edges_.ends[edge][0]);
    const Place b = vertex(edges_.ends[edge][1]);
    *link = {a.node, b.node, straight_length(a, b, options_.norm)};
  }

  // The other end of a way across the edge opposite to a corner.
  [[nodiscard]] Place beyond(CornerId corner) const {
    return options_.kind == GraphKind::vertex_dense ? vertex(apex(mesh_, corner))
                                                    : triangle(triangle_of(corner));
  }

  void link_across(std::size_t edge, Link* link) const {
    const auto corners = edges_.corners(edge);
    const Vec3& e0 = mesh_.positions[edges_.ends[edge][0]];
    const Vec3& e1 = mesh_.positions[edges_.ends[edge][1]];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Place a = beyond(corners[i]);
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        const Place b = beyond(corners[j]);
        const double isotropic = unfolded_distance(a.position, b.position, e0, e1);
        *link++ = {a.node, b.node, length_in_metric(a, b, isotropic, options_.norm)};
      }
    }
  }

  [[nodiscard]] double leg(CornerId corner) const {
    return straight_length(triangle(triangle_of(corner)), vertex(apex(mesh_, corner)),
                           options_.norm);
  }

  void find_fans() {
    fans_ = group_items<CornerId>(
        executor_, mesh_.vertex_count(), mesh_.triangle_count(), [this](std::size_t t, auto&& put) {
          for_each_corner(mesh_, t, [&](CornerId corner) { put(apex(mesh_, corner), corner); });
        });
    legs_ = Buffer<double>(fans_.entry.size());
  }

  // All triangles at a vertex to each other, by way of it.
  void link_fan(std::size_t v, Link* link) {
    const std::span<const CornerId> fan = fans_[v];
    double* legs = legs_.data() + (fan.data() - fans_.entry.data());
    for (std::size_t i = 0; i < fan.size(); ++i) {
      legs[i] = leg(fan[i]);
      const NodeId node = triangle_node(triangle_of(fan[i]));
      for (std::size_t j = 0; j < i; ++j) {
        *link++ = {triangle_node(triangle_of(fan[j])), node, legs[j] + legs[i]};
      }
    }
  }

  void link_spokes(std::size_t t, Link* link) const {
    for_each_corner(mesh_, t, [&](CornerId corner) {
      *link++ = {triangle_node(triangle_of(corner)), target_.node_of[apex(mesh_, corner)],
                 leg(corner)};
    });
  }

  Executor& executor_;
  const Mesh& mesh_;
  const MeshEdges& edges_;
  const MeshGraphOptions& options_;
  const MeshGraph& target_;
  std::vector<TangentSpace> triangle_space_;
  Groups<CornerId> fans_;  // corners at each vertex
  Buffer<double> legs_;    // of each of these
};

}  // namespace geolloyd

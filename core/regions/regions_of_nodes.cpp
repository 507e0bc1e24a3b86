#include "core/regions/regions_of_nodes.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

class RegionSurfaceBuilder {
 public:
  RegionSurfaceBuilder(const Mesh& mesh, const MeshEdges& edges, const MeshGraph& mesh_graph,
                       const Partition& partition, std::size_t region_count)
      : mesh_(mesh), edges_(edges), mesh_graph_(mesh_graph), partition_(partition) {
    surface_.vertex_count = mesh.vertex_count();
    surface_.region_count = region_count;
    if (!has_vertices(mesh_graph.kind)) {
      surface_.first_node = static_cast<PointId>(mesh.vertex_count());
    }
  }

  RegionSurface run() {
    label_nodes();
    if (!has_vertices(mesh_graph_.kind)) label_vertices();
    find_triangles();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto count = static_cast<std::uint32_t>(edges_.corners(e).size());
      if (count != 2) surface_.irregular_edges.push_back({edges_.ends[e], count});
    }
    std::erase_if(surface_.irregular_edges, [this](const IrregularEdge& edge) {
      return surface_.region[edge.ends[0]] == no_id || surface_.region[edge.ends[1]] == no_id;
    });
    // Arcs of the two other graphs are edges of the triangulation.
    if (mesh_graph_.kind != GraphKind::vertex && mesh_graph_.kind != GraphKind::triangle) {
      reassign_fragments();
    }
    return std::move(surface_);
  }

 private:
  void find_triangles() {
    std::vector<Triangle> triangles;
    if (has_triangles(mesh_graph_.kind)) {
      for (std::size_t e = 0; e < edges_.size(); ++e) triangulate_along(e, triangles);
      std::erase_if(triangles, [this](const Triangle& t) { return !is_part(t); });
    } else if (std::all_of(mesh_.triangles.begin(), mesh_.triangles.end(),
                           [this](const Triangle& t) { return is_part(t); })) {
      surface_.triangles = SurfaceTriangles::of(mesh_.triangles);
      return;
    } else {
      std::copy_if(mesh_.triangles.begin(), mesh_.triangles.end(), std::back_inserter(triangles),
                   [this](const Triangle& t) { return is_part(t); });
    }
    surface_.triangles = SurfaceTriangles(std::move(triangles));
  }

  // Reached, and with three vertices.
  [[nodiscard]] bool is_part(const Triangle& t) const {
    return has_three_vertices(t) && surface_.region[t[0]] != no_id &&
           surface_.region[t[1]] != no_id && surface_.region[t[2]] != no_id;
  }

  void label_nodes() {
    const std::size_t triangles = has_triangles(mesh_graph_.kind) ? mesh_.triangle_count() : 0;
    surface_.region.assign(mesh_.vertex_count() + triangles, no_id);
    surface_.distance.assign(surface_.region.size(), 0);
    for (NodeId v = 0; v < partition_.key.size(); ++v) {
      const Key key = partition_.key[v];
      const PointId point = point_of(mesh_graph_, mesh_.vertex_count(), v);
      surface_.region[point] = region_of(key);
      surface_.distance[point] = distance_of(key) * mesh_graph_.graph.tick_length;
    }
  }

  void label_vertices() {
    surface_.nearest_node.assign(mesh_.vertex_count(), no_id);
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      const auto centre = static_cast<PointId>(mesh_.vertex_count() + t);
      for_each_corner(mesh_, t, [&](CornerId c) {
        const VertexId v = apex(mesh_, c);
        const double distance = surface_.distance[centre] + length(centre, v);
        if (surface_.region[v] == no_id || std::tie(distance, surface_.region[centre]) <
                                               std::tie(surface_.distance[v], surface_.region[v])) {
          surface_.region[v] = surface_.region[centre];
          surface_.distance[v] = distance;
          surface_.nearest_node[v] = centre;
        }
      });
    }
  }

  void triangulate_along(std::size_t edge, std::vector<Triangle>& triangles) const {
    const auto corners = edges_.corners(edge);
    const CornerId c = corners[0];
    const PointId u = edge_start(mesh_, c);
    const PointId w = edge_end(mesh_, c);
    if (corners.size() == 2 && goes_across(u, w, centre_of(c), centre_of(corners[1]))) {
      triangles.push_back({u, centre_of(corners[1]), centre_of(c)});
      triangles.push_back({centre_of(corners[1]), w, centre_of(c)});
      return;
    }
    for (const CornerId corner : corners) {
      triangles.push_back({edge_start(mesh_, corner), edge_end(mesh_, corner), centre_of(corner)});
    }
  }

  [[nodiscard]] PointId centre_of(CornerId corner) const {
    return static_cast<PointId>(mesh_.vertex_count() + triangle_of(corner));
  }

  // Whether the diagonal of an edge's quadrilateral is that between its triangles.
  [[nodiscard]] bool goes_across(PointId u, PointId w, PointId left, PointId right) const {
    const auto& region = surface_.region;
    const auto& distance = surface_.distance;
    const bool along = region[u] == region[w];
    const bool across = region[left] == region[right];
    if (along != across) return across;
    if (!has_vertices(mesh_graph_.kind)) return true;
    return std::max(distance[left], distance[right]) < std::max(distance[u], distance[w]);
  }

  [[nodiscard]] double length(PointId a, PointId b) const {
    return norm(surface_.position(mesh_, a) - surface_.position(mesh_, b));
  }

  // What has lost touch with its seed goes to neighbours, nearest first.
  void reassign_fragments() {
    const std::vector<std::uint8_t> is_held = find_held();
    std::unordered_map<PointId, std::vector<PointId>> neighbours;  // of those not held
    for (const Triangle& t : surface_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (is_held[t[i]] != 0) continue;
        neighbours[t[i]].push_back(t[(i + 1) % 3]);
        neighbours[t[i]].push_back(t[(i + 2) % 3]);
      }
    }
    using Offer = std::tuple<double, RegionId, PointId>;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    const auto offer = [&](PointId from, PointId to) {
      offers.emplace(surface_.distance[from] + length(from, to), surface_.region[from], to);
    };
    for (const auto& [point, around] : neighbours) {
      for (const PointId n : around) {
        if (is_held[n] != 0) offer(n, point);
      }
    }
    while (!offers.empty()) {
      const auto [distance, region, point] = offers.top();
      offers.pop();
      const auto found = neighbours.find(point);
      if (found == neighbours.end()) continue;
      surface_.region[point] = region;
      surface_.distance[point] = distance;
      surface_.reassigned_points.push_back(point);
      const std::vector<PointId> around = std::move(found->second);
      neighbours.erase(found);
      for (const PointId n : around) {
        if (neighbours.contains(n)) offer(point, n);
      }
    }
    std::sort(surface_.reassigned_points.begin(), surface_.reassigned_points.end());
  }

  // Per point, whether edges of the triangulation join it to its region's seed. Points on no
  // triangle count as held.
  [[nodiscard]] std::vector<std::uint8_t> find_held() const {
    const auto& region = surface_.region;
    DisjointSets pieces(region.size());
    std::vector<std::uint8_t> is_held(region.size(), 1);
    for (const Triangle& t : surface_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        is_held[t[i]] = 0;
        if (region[t[i]] == region[t[(i + 1) % 3]]) pieces.unite(t[i], t[(i + 1) % 3]);
      }
    }
    std::vector<std::uint8_t> has_seed(region.size(), 0);  // per piece
    for (NodeId v = 0; v < partition_.key.size(); ++v) {
      if (distance_of(partition_.key[v]) == 0) {
        has_seed[pieces.find(point_of(mesh_graph_, mesh_.vertex_count(), v))] = 1;
      }
    }
    for (PointId p = 0; p < region.size(); ++p) {
      if (is_held[p] == 0) is_held[p] = has_seed[pieces.find(p)];
    }
    return is_held;
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const MeshGraph& mesh_graph_;
  const Partition& partition_;
  RegionSurface surface_;
};

}  // namespace

MeshEdges irregular_edges(const MeshEdges& edges) {
  MeshEdges irregular;
  irregular.duplicates = edges.duplicates;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto corners = edges.corners(e);
    if (corners.size() == 2) continue;
    irregular.ends.push_back(edges.ends[e]);
    irregular.first_corner.push_back(static_cast<std::uint32_t>(irregular.corner.size()));
    irregular.corner.insert(irregular.corner.end(), corners.begin(), corners.end());
  }
  irregular.first_corner.push_back(static_cast<std::uint32_t>(irregular.corner.size()));
  return irregular;
}

PointId point_of(const MeshGraph& mesh_graph, std::size_t vertex_count, NodeId node) {
  const std::uint32_t id = mesh_graph.input_id[node];
  return has_vertices(mesh_graph.kind) ? id : static_cast<PointId>(vertex_count + id);
}

NodeId node_at(const MeshGraph& mesh_graph, std::size_t vertex_count, PointId point) {
  if (has_vertices(mesh_graph.kind)) {
    return point < mesh_graph.node_of.size() ? mesh_graph.node_of[point] : no_id;
  }
  return point < vertex_count ? no_id : mesh_graph.node_of[point - vertex_count];
}

RegionSurface make_region_surface(const Mesh& mesh, const MeshEdges& edges,
                                  const MeshGraph& mesh_graph, const Partition& partition,
                                  std::size_t region_count) {
  return RegionSurfaceBuilder(mesh, edges, mesh_graph, partition, region_count).run();
}

}  // namespace geolloyd

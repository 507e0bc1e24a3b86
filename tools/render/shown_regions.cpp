#include "tools/render/shown_regions.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "core/base/loops.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

// The region of a point of the surface, and how far away its seed is, in pixels.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  RegionId region = no_id;

  friend bool operator<(const Nearest& a, const Nearest& b) {
    return std::tie(a.distance, a.region) < std::tie(b.distance, b.region);
  }
};

// Pixels; less is rounding.
constexpr double doubt = 1e-4;

// Nodes of the graph and, where vertices are none, vertices.
struct Places {
  std::vector<Nearest> vertex;    // per vertex
  std::vector<Nearest> triangle;  // per triangle, or none

  // Most triangles are inside a region: that region; else no_id.
  [[nodiscard]] RegionId only_region(const Mesh& mesh, TriangleId triangle_id) const {
    const Triangle& t = mesh.triangles[triangle_id];
    const RegionId region = vertex[t[0]].region;
    const bool is_only = vertex[t[1]].region == region && vertex[t[2]].region == region &&
                         (triangle.empty() || triangle[triangle_id].region == region);
    return is_only ? region : no_id;
  }
};

// of_node(node) is a node's Nearest; seen_from(its own, its position, another position) that of a
// vertex by way of a triangle.
template <class OfNode, class SeenFrom>
Places find_places(const Scene& scene, const MeshGraph& mesh_graph, Executor& executor,
                   OfNode&& of_node, SeenFrom&& seen_from) {
  const Mesh& mesh = scene.mesh;
  const auto nearest = [&](std::size_t id) {
    const NodeId node = mesh_graph.node_of[id];
    return node == no_id ? Nearest{} : of_node(node);
  };
  Places places;
  places.vertex.resize(mesh.vertex_count());
  if (has_vertices(mesh_graph.kind)) {
    parallel_for(executor, mesh.vertex_count(), small_items,
                 [&](std::size_t v) { places.vertex[v] = nearest(v); });
  }
  if (!has_triangles(mesh_graph.kind)) return places;
  places.triangle.resize(mesh.triangle_count());
  parallel_for(executor, mesh.triangle_count(), small_items, [&](std::size_t t) {
    places.triangle[t] = nearest(mesh_graph.first_triangle_id + t);
  });
  if (has_vertices(mesh_graph.kind)) return places;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Nearest& own = places.triangle[t];
    if (own.region == no_id) continue;
    const Vec3 centre = barycentre(mesh, static_cast<TriangleId>(t));
    for (const VertexId v : mesh.triangles[t]) {
      places.vertex[v] = std::min(places.vertex[v], seen_from(own, centre, mesh.positions[v]));
    }
  }
  return places;
}

// The three places around a sample, the one with the largest weight first.
struct Corners {
  struct Corner {
    double weight;
    Vec3 position;
    Nearest nearest;
  };
  std::array<Corner, 3> corner;

  [[nodiscard]] bool has_gap() const {
    return std::any_of(corner.begin(), corner.end(),
                       [](const Corner& c) { return c.nearest.region == no_id; });
  }
  [[nodiscard]] Vec3 position() const {
    Vec3 sum(0, 0, 0);
    for (const Corner& c : corner) sum += c.weight * c.position;
    return sum;
  }
};

Corners corners_around(const RayHit& hit, const Mesh& mesh, const Places& places) {
  const Triangle& t = mesh.triangles[hit.triangle];
  const std::array<double, 3> weight = {1.0 - hit.u - hit.v, hit.u, hit.v};
  Corners corners{};
  for (std::size_t c = 0; c < 3; ++c) {
    corners.corner[c] = {weight[c], mesh.positions[t[c]], places.vertex[t[c]]};
  }
  const auto heavier = [](const auto& a, const auto& b) { return a.weight > b.weight; };
  std::sort(corners.corner.begin(), corners.corner.end(), heavier);
  if (places.triangle.empty()) return corners;
  // The centre takes the place of the farthest vertex.
  const double least = corners.corner[2].weight;
  corners.corner[0].weight -= least;
  corners.corner[1].weight -= least;
  corners.corner[2] = {3 * least, barycentre(mesh, hit.triangle), places.triangle[hit.triangle]};
  std::sort(corners.corner.begin(), corners.corner.end(), heavier);
  return corners;
}

// Of the regions around a sample the one with the smallest distance_of(region, corners), in doubt
// that of the nearest place.
template <class DistanceOf>
std::vector<RegionId> show(const Scene& scene, const Places& places, Executor& executor,
                           DistanceOf&& distance_of) {
  std::vector<RegionId> shown(scene.hit.size(), no_id);
  parallel_for(executor, shown.size(), small_items, [&](std::size_t i) {
    if (scene.hit[i].triangle == no_id) return;
    shown[i] = places.only_region(scene.mesh, scene.hit[i].triangle);
    if (shown[i] != no_id) return;
    const Corners corners = corners_around(scene.hit[i], scene.mesh, places);
    shown[i] = corners.corner[0].nearest.region;
    if (corners.has_gap()) return;
    double least = std::numeric_limits<double>::infinity();
    for (const Corners::Corner& c : corners.corner) {
      const double distance = distance_of(c.nearest.region, corners);
      if (distance > least - doubt) continue;
      least = distance;
      shown[i] = c.nearest.region;
    }
  });
  return shown;
}

// Distance from a region's seed to a corner: its own, or by way of a corner of the region, but no
// less than to the corner's own seed.
double distance_to(std::size_t c, RegionId region, const Corners& corners) {
  const Corners::Corner& to = corners.corner[c];
  if (to.nearest.region == region) return to.nearest.distance;
  double least = std::numeric_limits<double>::infinity();
  for (const Corners::Corner& by : corners.corner) {
    if (by.nearest.region != region) continue;
    least = std::min(least, by.nearest.distance + norm(by.position - to.position));
  }
  return std::max(least, to.nearest.distance);
}

}  // namespace

std::vector<RegionId> show_partition(const Scene& scene, const MeshGraph& mesh_graph,
                                     const Partition& partition, Executor& executor) {
  const double tick = mesh_graph.graph.tick_length / scene.camera.pixel;
  const Places places = find_places(
      scene, mesh_graph, executor,
      [&](NodeId node) {
        const Key key = partition.key[node];
        return Nearest{distance_of(key) * tick, region_of(key)};
      },
      [](const Nearest& by, const Vec3& from, const Vec3& to) {
        return Nearest{by.distance + norm(to - from), by.region};
      });
  return show(scene, places, executor, [](RegionId region, const Corners& corners) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += corners.corner[c].weight * distance_to(c, region, corners);
    }
    return sum;
  });
}

std::vector<RegionId> show_nearest(const Scene& scene, const MeshGraph& mesh_graph,
                                   std::span<const RegionId> region_of_node,
                                   std::span<const Vec3> seed_position, Executor& executor) {
  std::vector<Vec3> seed;
  seed.reserve(seed_position.size());
  for (const Vec3& p : seed_position) seed.push_back(scene.camera(p));
  const Places places = find_places(
      scene, mesh_graph, executor,
      [&](NodeId node) {
        return Nearest{0, region_of_node[node]};
      },
      [&](const Nearest& by, const Vec3& /*from*/, const Vec3& to) {
        return Nearest{norm(to - seed[by.region]), by.region};
      });
  return show(scene, places, executor, [&](RegionId region, const Corners& corners) {
    return norm(corners.position() - seed[region]);
  });
}

}  // namespace geolloyd

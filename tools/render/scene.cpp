#include "tools/render/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/base/disjoint_sets.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {
namespace {

// In the space of the picture: from the upper left, over the viewer's shoulder.
const Vec3 to_lamp = normalized(Vec3(-0.45, -0.7, -0.8));
constexpr double ambient = 0.4;
constexpr double from_eye = 0.3;
constexpr double from_lamp = 0.42;
constexpr double crease_cosine = 0.76;  // of 40 degrees, between the normals at an edge

constexpr int tile = 4;  // of samples, cast as one packet
static_assert(tile * tile == static_cast<int>(RayCaster::packet));

Mesh seen_by(const Camera& camera, const Mesh& mesh, Executor& executor) {
  Mesh seen = mesh;
  parallel_for(executor, seen.vertex_count(), small_items,
               [&](std::size_t v) { seen.positions[v] = camera(seen.positions[v]); });
  return seen;
}

// Twice the area long.
Vec3 normal_of(const Mesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

void cast_tile(const RayCaster& caster, int column, int row, Scene& scene) {
  std::array<float, RayCaster::packet> x{};
  std::array<float, RayCaster::packet> y{};
  for (int i = 0; i < tile * tile; ++i) {
    const auto ray = static_cast<std::size_t>(i);
    x[ray] = static_cast<float>(SampleGrid::place(column + i % tile));
    y[ray] = static_cast<float>(SampleGrid::place(row + i / tile));
  }
  const auto hits = caster.cast(x, y);
  for (int i = 0; i < tile * tile; ++i) {
    const int c = column + i % tile;
    const int r = row + i / tile;
    if (c >= scene.grid.columns() || r >= scene.grid.rows()) continue;
    scene.hit[scene.grid.index(c, r)] = hits[static_cast<std::size_t>(i)];
  }
}

void cast_all(Scene& scene, Executor& executor) {
  const RayCaster caster(scene.mesh, executor.threads());
  scene.hit.resize(scene.grid.count());
  const int tile_rows = (scene.grid.rows() + tile - 1) / tile;
  parallel_for(executor, static_cast<std::size_t>(tile_rows), 1, [&](std::size_t r) {
    for (int column = 0; column < scene.grid.columns(); column += tile) {
      cast_tile(caster, column, static_cast<int>(r) * tile, scene);
    }
  });
}

// Unit normals of triangles, and of sets of corners that meet at a vertex and across edges that
// turn little; the latter weighted by area.
class Normals {
 public:
  Normals(const Mesh& mesh, Shading shading, Executor& executor) {
    of_triangle_.resize(mesh.triangle_count());
    parallel_for(executor, mesh.triangle_count(), small_items,
                 [&](std::size_t t) { of_triangle_[t] = normal_of(mesh, mesh.triangles[t]); });
    if (shading == Shading::smooth) join_corners(mesh, executor);
    for (std::vector<Vec3>* normals : {&of_triangle_, &of_set_}) {
      parallel_for(executor, normals->size(), small_items,
                   [&](std::size_t i) { (*normals)[i] = normalized((*normals)[i]); });
    }
  }

  [[nodiscard]] Vec3 at(const RayHit& hit) const {
    if (of_set_.empty()) return of_triangle_[hit.triangle];
    const std::array<double, 3> weight = {1.0 - hit.u - hit.v, hit.u, hit.v};
    Vec3 sum(0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c)
      sum += weight[c] * of_set_[set_[std::size_t{3} * hit.triangle + c]];
    return normalized(sum);
  }

 private:
  void join_corners(const Mesh& mesh, Executor& executor) {
    const MeshEdges edges = find_edges(mesh, executor);
    DisjointSets sets(3 * mesh.triangle_count(), executor);
    parallel_for(executor, edges.size(), small_items, [&](std::size_t e) {
      const std::span<const CornerId> corners = edges.corners(e);
      if (corners.size() != 2 || is_crease(corners[0], corners[1])) return;
      for (const VertexId v : edges.ends[e]) {
        sets.unite(corner_at(mesh, corners[0], v), corner_at(mesh, corners[1], v));
      }
    });
    set_.resize(3 * mesh.triangle_count());
    for (CornerId c = 0; c < set_.size(); ++c) {
      const CornerId root = sets.find(c);  // not above c
      set_[c] = root < c ? set_[root] : static_cast<std::uint32_t>(of_set_.size());
      if (root == c) of_set_.emplace_back(Vec3::Zero());
      of_set_[set_[c]] += of_triangle_[triangle_of(c)];
    }
  }

  [[nodiscard]] bool is_crease(CornerId one, CornerId other) const {
    const Vec3& a = of_triangle_[triangle_of(one)];
    const Vec3& b = of_triangle_[triangle_of(other)];
    return !(dot(a, b) > crease_cosine * norm(a) * norm(b));
  }

  // Of the two ends of the edge opposite to `opposite`.
  static CornerId corner_at(const Mesh& mesh, CornerId opposite, VertexId v) {
    return edge_start(mesh, opposite) == v ? corner_at_start(opposite) : corner_at_end(opposite);
  }

  std::vector<Vec3> of_triangle_;
  std::vector<Vec3> of_set_;
  std::vector<std::uint32_t> set_;  // per corner
};

// Both sides of the surface alike.
float light_on(Vec3 normal) {
  if (normal.z() > 0) normal = -normal;
  const double lamp = std::max(0.0, dot(normal, to_lamp));
  return static_cast<float>(std::min(1.0, ambient - from_eye * normal.z() + from_lamp * lamp));
}

void light_all(Scene& scene, Shading shading, Executor& executor) {
  const Normals normals(scene.mesh, shading, executor);
  scene.light.resize(scene.hit.size());
  parallel_for(executor, scene.hit.size(), small_items, [&](std::size_t i) {
    if (scene.hit[i].triangle != no_id) scene.light[i] = light_on(normals.at(scene.hit[i]));
  });
}

}  // namespace

Scene make_scene(const Mesh& mesh, const Camera& camera, Shading shading, Executor& executor) {
  Scene scene{camera, {camera.size}, seen_by(camera, mesh, executor), {}, {}};
  cast_all(scene, executor);
  light_all(scene, shading, executor);
  return scene;
}

}  // namespace geolloyd

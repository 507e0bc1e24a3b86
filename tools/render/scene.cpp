#include "tools/render/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

// In the space of the picture: from the upper left, over the viewer's shoulder.
const Vec3 to_lamp = normalized(Vec3(-0.45, -0.7, -0.8));
constexpr double ambient = 0.4;
constexpr double from_eye = 0.3;
constexpr double from_lamp = 0.42;
constexpr double crease_cosine = 0.76;  // of an edge's angle from its vertices' normals, halved

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

// Unit normals of triangles and of vertices, the latter weighted by area.
class Normals {
 public:
  Normals(const Mesh& mesh, Shading shading, Executor& executor) : mesh_(mesh) {
    of_triangle_.resize(mesh.triangle_count());
    parallel_for(executor, mesh.triangle_count(), small_items,
                 [&](std::size_t t) { of_triangle_[t] = normal_of(mesh, mesh.triangles[t]); });
    if (shading == Shading::smooth) add_vertices();
    for (std::vector<Vec3>* normals : {&of_triangle_, &of_vertex_}) {
      parallel_for(executor, normals->size(), small_items,
                   [&](std::size_t i) { (*normals)[i] = normalized((*normals)[i]); });
    }
  }

  // At a corner where the surface bends too much, that of the triangle counts.
  [[nodiscard]] Vec3 at(const RayHit& hit) const {
    const Vec3& flat = of_triangle_[hit.triangle];
    if (of_vertex_.empty()) return flat;
    const std::array<double, 3> weight = {1.0 - hit.u - hit.v, hit.u, hit.v};
    Vec3 sum(0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& smooth = of_vertex_[mesh_.triangles[hit.triangle][c]];
      sum += weight[c] * (dot(smooth, flat) > crease_cosine ? smooth : flat);
    }
    return normalized(sum);
  }

 private:
  void add_vertices() {
    of_vertex_.assign(mesh_.vertex_count(), Vec3::Zero());
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (const VertexId v : mesh_.triangles[t]) of_vertex_[v] += of_triangle_[t];
    }
  }

  const Mesh& mesh_;
  std::vector<Vec3> of_triangle_;
  std::vector<Vec3> of_vertex_;
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

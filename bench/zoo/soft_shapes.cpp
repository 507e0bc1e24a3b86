#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "bench/zoo/changes.h"
#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"
#include "core/base/random.h"
#include "core/mesh/mesh_measure.h"
#include "core/shapes/shapes.h"

namespace geolloyd::zoo {
namespace {

Solid closed(Mesh mesh, std::int64_t euler_characteristic) {
  Solid solid{std::move(mesh), 0, {{euler_characteristic, 0}}, {}};
  solid.volume = enclosed_volume(solid.mesh);
  return solid;
}

Solid ellipsoid(const Vec3& axes, std::size_t triangles) {
  Mesh mesh = icosphere(triangles);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(axes);
  return closed(std::move(mesh), 2);
}

/// A sphere with waves in random directions.
Solid blob(std::uint64_t random_seed, double depth, std::size_t triangles) {
  Mesh mesh = icosphere(triangles);
  for (Vec3& p : mesh.positions) {
    const Vec3 out = p;
    double radius = 1;
    for (std::uint64_t k = 0; k < 6; ++k) {
      const auto number = [&](std::uint64_t n) {
        return 2 * random_unit(random_seed, 4 * k + n) - 1;
      };
      const Vec3 wave(number(0), number(1), number(2));
      radius += depth * std::sin(5 * dot(wave, out) + 6 * number(3));
    }
    p = radius * out;
  }
  return closed(std::move(mesh), 2);
}

Solid with_true_volume(Solid solid) {
  solid.volume = enclosed_volume(solid.mesh);
  return solid;
}

}  // namespace

void add_soft_shapes(Cages& cages) {
  const auto add = [&](const std::string& name, auto make) {
    cages.push_back({name, soft_kind, [name, make] { return soft_part_of(name, make()); }});
  };
  add("ellipsoid", [] { return ellipsoid({1, 0.7, 0.5}, 8'000); });
  add("ellipsoid_flat", [] { return ellipsoid({1, 0.9, 0.1}, 8'000); });
  add("ellipsoid_long", [] { return ellipsoid({1, 0.15, 0.15}, 20'000); });
  add("ellipsoid_coarse", [] { return ellipsoid({1, 0.7, 0.5}, 320); });
  add("blob_1", [] { return blob(1, 0.06, 20'000); });
  add("blob_2", [] { return blob(2, 0.06, 20'000); });
  add("blob_noisy", [] { return with_true_volume(with_noise(blob(3, 0.05, 40'000), 0.004, 3)); });
  add("ball_noisy", [] {
    return with_true_volume(with_noise(ellipsoid({1, 1, 1}, 20'000), 0.008, 4));
  });
  add("torus", [] { return closed(torus(10'000, 1), 0); });
  add("creature", [] { return closed(creature(40'000, 3), 2); });
}

}  // namespace geolloyd::zoo

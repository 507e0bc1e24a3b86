#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"

namespace geolloyd::zoo {
namespace {

Solid cylinder_of(double radius, double height, std::uint32_t sides, bool from_corner) {
  return turned({{{0, 0}, {radius, 0}, {radius, height}, {0, height}}, sides, false, from_corner});
}

Solid cone(double radius, double height, std::uint32_t sides) {
  return turned({{{0, 0}, {radius, 0}, {0, height}}, sides, false, true});
}

/// A quarter of a circle from one direction to the other, about a middle.
void add_arc(Polygon& profile, Point middle, double radius, double from, double to,
             std::uint32_t edges) {
  for (std::uint32_t k = 0; k <= edges; ++k) {
    const double turn = from + (to - from) * k / edges;
    const double angle = 2 * std::numbers::pi * turn;
    profile.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
  }
}

Solid shaft_with_fillets() {
  Polygon profile = {{0, 0}, {0.4, 0}, {0.5, 0.1}, {0.5, 1.2}};
  add_arc(profile, {0.6, 1.4}, 0.1, 0.5, 0.25, 5);  // into the shoulder
  profile.insert(profile.end(), {{1, 1.5}, {1, 2}, {0.6, 2}, {0.6, 3}, {0, 3}});
  return turned({profile, 64});
}

Solid pulley() {
  return turned({{{0.3, 0}, {1, 0}, {1, 0.2}, {0.7, 0.5}, {1, 0.8}, {1, 1}, {0.3, 1}}, 80, true});
}

Solid stepped_shaft(std::uint32_t sides) {
  return turned(
      {{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0.8, 0.5}, {0.8, 1}, {0.3, 1}, {0.3, 2.5}, {0, 2.5}},
       sides});
}

Solid pipe_flange() {
  return turned({{{0.5, 0}, {1.5, 0}, {1.5, 0.2}, {0.6, 0.2}, {0.6, 2}, {0.5, 2}}, 96, true});
}

/// Open above.
Solid cup(double wall_thickness) {
  const double t = wall_thickness;
  return turned({{{0, 0}, {0.8, 0}, {1, 2}, {1 - t, 2}, {0.8 - t, t}, {0, t}}, 72});
}

Solid bowl(double wall_thickness) {
  Polygon profile;
  add_arc(profile, {0, 1}, 1, 0.75, 1, 16);
  profile.front().x = 0;
  Polygon inner;
  add_arc(inner, {0, 1}, 1 - wall_thickness, 1, 0.75, 16);
  inner.back().x = 0;
  profile.insert(profile.end(), inner.begin(), inner.end());
  return turned({profile, 64});
}

Solid ball(double radius, std::uint32_t sides) {
  Polygon profile;
  add_arc(profile, {0, 0}, radius, -0.25, 0.25, sides / 2);
  profile.front().x = 0;
  profile.back().x = 0;
  return turned({profile, sides});
}

Solid bottle() {
  Polygon profile = {{0, 0}, {0.7, 0}, {0.8, 0.1}};
  add_arc(profile, {0.5, 1.6}, 0.3, 0, 0.2, 6);
  profile.insert(profile.end(), {{0.3, 2.1}, {0.3, 2.6}, {0.36, 2.6}, {0.36, 2.8}, {0.26, 2.8}});
  profile.insert(profile.end(), {{0.26, 2.0}, {0.74, 1.5}, {0.74, 0.08}, {0, 0.08}});
  return turned({profile, 60});
}

Solid o_ring(double thickness) {
  Polygon profile;
  add_arc(profile, {1, 0}, thickness, 0, 0.9375, 15);
  return turned({profile, 96, true});
}

}  // namespace

void add_turned_parts(Cages& cages) {
  const auto add = [&](const std::string& name, const std::string& kind, auto make) {
    cages.push_back(cage(name, kind, make));
  };
  add("cone", "cone or hub", [] { return cone(1, 2, 64); });
  add("cone_hub_600", "cone or hub", [] { return cone(1, 1, 600); });
  add("cone_flat_hub", "cone or hub", [] { return cone(1, 0.1, 400); });
  add("cone_spike", "cone or hub", [] { return cone(0.1, 3, 48); });
  add("cone_cut_off", "cone or hub", [] {
    return turned({{{0, 0}, {1, 0}, {0.4, 1}, {0, 1}}, 48});
  });
  add("spindle", "cone or hub", [] { return turned({{{0, -1}, {0.6, 0}, {0, 1}}, 300}); });
  add("disc_hub_600", "cone or hub", [] { return cylinder_of(1, 0.1, 600, false); });
  add("cylinder_7", "turned part", [] { return cylinder_of(1, 2, 7, true); });
  add("cylinder_12", "turned part", [] { return cylinder_of(1, 2, 12, true); });
  add("cylinder_48", "turned part", [] { return cylinder_of(1, 2, 48, true); });
  add("rod_thin", "turned part", [] { return cylinder_of(0.03, 4, 24, true); });
  add("shaft_stepped", "turned part", [] { return stepped_shaft(48); });
  add("shaft_fillets", "chamfers and fillets", shaft_with_fillets);
  add("pulley", "turned part", pulley);
  add("pipe_flange", "turned part", pipe_flange);
  add("bottle", "thin wall", bottle);
  add("cup", "thin wall", [] { return cup(0.08); });
  add("cup_thin", "thin wall", [] { return cup(0.01); });
  add("bowl", "thin wall", [] { return bowl(0.05); });
  add("bowl_paper", "thin wall", [] { return bowl(0.005); });
  add("tube_thin", "thin wall", [] {
    return turned({{{0.98, 0}, {1, 0}, {1, 2}, {0.98, 2}}, 64, true});
  });
  add("ball_hollow", "thin wall", [] { return with_hollow(ball(1, 48), ball(0.95, 48)); });
  add("ball_smooth", "turned part", [] { return ball(1, 64); });
  add("o_ring", "turned part", [] { return o_ring(0.2); });
  add("o_ring_thin", "turned part", [] { return o_ring(0.02); });
}

}  // namespace geolloyd::zoo

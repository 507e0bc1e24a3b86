#include <cmath>
#include <cstdint>
#include <vector>

#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"
#include "core/base/random.h"

namespace geolloyd::zoo {
namespace {

struct Hole {
  Point middle;
  double radius = 0;
};

Solid plate(const Polygon& outline, double thickness, const std::vector<Hole>& holes,
            std::uint32_t corners) {
  Terrace outer = wall(outline, 0, thickness);
  for (const Hole& hole : holes) {
    outer.inside.push_back(round_wall(circle(hole.middle, hole.radius, corners), thickness, 0));
  }
  return terraces(outer);
}

/// On a plate of 4 by 3.
Solid plate_with_grid(std::uint32_t columns, std::uint32_t rows, double radius, double thickness,
                      std::uint32_t corners) {
  std::vector<Hole> holes;
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      holes.push_back({{4 * (c + 0.5) / columns, 3 * (r + 0.5) / rows}, radius});
    }
  }
  return plate(rectangle({0, 0}, {4, 3}), thickness, holes, corners);
}

/// Apart by at least a fifth of the smaller one's radius.
Solid plate_with_random_holes(std::uint64_t random_seed) {
  std::vector<Hole> holes;
  for (std::uint64_t n = 0; n < 60; ++n) {
    const double radius = 0.03 + 0.3 * std::pow(random_unit(random_seed, 3 * n), 3);
    const double room = 1.2 * radius;
    const Hole hole{{room + (4 - 2 * room) * random_unit(random_seed, 3 * n + 1),
                     room + (3 - 2 * room) * random_unit(random_seed, 3 * n + 2)},
                    radius};
    bool is_free = true;
    for (const Hole& other : holes) {
      const double way = std::hypot(hole.middle.x - other.middle.x, hole.middle.y - other.middle.y);
      is_free = is_free && way > 1.2 * radius + other.radius;
    }
    if (is_free) holes.push_back(hole);
  }
  return plate(rectangle({0, 0}, {4, 3}), 0.3, holes, 32);
}

Solid plate_of_many_radii() {
  std::vector<Hole> holes;
  double x = 0.1;
  for (const double radius : {0.01, 0.02, 0.04, 0.08, 0.15, 0.25, 0.4}) {
    x += radius;
    holes.push_back({{x, 0.6}, radius});
    x += radius + 0.15;
  }
  return plate(rectangle({0, 0}, {x, 1.2}), 0.2, holes, 48);
}

Solid flange_plate(std::uint32_t bolts, double radius) {
  std::vector<Hole> holes = {{{0, 0}, 0.9}};
  for (const Point& p : circle({0, 0}, 1.5, bolts)) holes.push_back({p, radius});
  return plate(circle({0, 0}, 2, 96), 0.3, holes, 32);
}

Solid counterbored_plate(bool is_sunk) {
  Terrace outer = wall(rectangle({0, 0}, {4, 3}), 0, 0.5);
  for (const double x : {0.7, 2.0, 3.3}) {
    for (const double y : {0.7, 2.3}) {
      const Polygon wide = circle({x, y}, 0.3, 40);
      const Polygon narrow = circle({x, y}, 0.15, 40);
      Terrace sunk{{{wide, 0.5}, {narrow, 0.35}, {narrow, 0}}, {}, true};
      Terrace bored = round_wall(wide, 0.5, 0.3);
      bored.inside.push_back(round_wall(narrow, 0.3, 0));
      outer.inside.push_back(is_sunk ? sunk : bored);
    }
  }
  return terraces(outer);
}

Solid grille(std::uint32_t count, double bar) {
  Terrace outer = wall(rectangle({0, 0}, {4, 4}), 0, 0.2);
  const double step = (4 - bar) / count;
  for (std::uint32_t r = 0; r < count; ++r) {
    for (std::uint32_t c = 0; c < count; ++c) {
      const Point low = {bar + c * step, bar + r * step};
      const Point high = {low.x + step - bar, low.y + step - bar};
      outer.inside.push_back(wall(rectangle(low, high), 0.2, 0));
    }
  }
  return terraces(outer);
}

Solid slotted_plate(double width) {
  Terrace outer = wall(rounded_rectangle({0, 0}, {4, 3}, 0.4, 8), 0, 0.25);
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double x = 0.5 + 0.6 * k - width / 2;
    outer.inside.push_back(
        wall(rounded_rectangle({x, 0.5}, {x + width, 2.5}, 0.45 * width, 6), 0.25, 0));
  }
  return terraces(outer);
}

Solid honeycomb(double wall_thickness) {
  Terrace outer = wall(rectangle({-0.6, -0.6}, {5.6, 4.3}), 0, 0.6);
  const double reach = 0.5 - wall_thickness / std::sqrt(3.0);
  for (std::uint32_t r = 0; r < 5; ++r) {
    for (std::uint32_t c = 0; c < 6 - r % 2; ++c) {
      const double x = std::sqrt(3.0) / 2 * (c + 0.5 * (r % 2));
      Polygon cell = circle({0, 0}, reach, 6);
      for (Point& p : cell) p = {p.y, p.x};
      const Polygon turned_cell(cell.rbegin(), cell.rend());
      outer.inside.push_back(wall(moved(turned_cell, {x + 0.3, 0.75 * r + 0.3}), 0.6, 0));
    }
  }
  return terraces(outer);
}

}  // namespace

void add_plates(Cages& cages) {
  const std::string kind = "plate with holes";
  const auto add = [&](const std::string& name, auto make) {
    cages.push_back(cage(name, kind, make));
  };
  add("plate_one_hole", [] { return plate_with_grid(1, 1, 0.6, 0.3, 48); });
  add("plate_4_holes", [] { return plate_with_grid(2, 2, 0.3, 0.3, 32); });
  add("plate_9_small_holes", [] { return plate_with_grid(3, 3, 0.06, 0.3, 24); });
  add("plate_32_holes", [] { return plate_with_grid(8, 4, 0.12, 0.4, 24); });
  add("plate_100_tiny_holes", [] { return plate_with_grid(10, 10, 0.04, 0.2, 12); });
  add("plate_octagonal_holes", [] { return plate_with_grid(4, 3, 0.25, 0.3, 8); });
  add("plate_fine_holes", [] { return plate_with_grid(3, 2, 0.35, 0.3, 192); });
  add("plate_close_holes", [] { return plate_with_grid(8, 6, 0.22, 0.3, 24); });
  add("plate_thin", [] { return plate_with_grid(3, 2, 0.3, 0.02, 32); });
  add("plate_thick", [] { return plate_with_grid(3, 2, 0.3, 2, 32); });
  add("plate_many_radii", plate_of_many_radii);
  add("plate_random_1", [] { return plate_with_random_holes(1); });
  add("plate_random_2", [] { return plate_with_random_holes(2); });
  add("flange_plate", [] { return flange_plate(8, 0.15); });
  add("flange_small_bolts", [] { return flange_plate(24, 0.05); });
  add("washer", [] { return plate(circle({0, 0}, 1, 64), 0.15, {{{0, 0}, 0.55}}, 64); });
  add("counterbored_plate", [] { return counterbored_plate(false); });
  add("countersunk_plate", [] { return counterbored_plate(true); });
  add("slotted_plate", [] { return slotted_plate(0.25); });
  add("narrow_slots", [] { return slotted_plate(0.05); });
  add("grille", [] { return grille(8, 0.15); });
  add("grille_thin_bars", [] { return grille(10, 0.04); });
  add("honeycomb", [] { return honeycomb(0.12); });
  add("honeycomb_thin", [] { return honeycomb(0.03); });
}

}  // namespace geolloyd::zoo

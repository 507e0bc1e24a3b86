#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"

namespace geolloyd::zoo {
namespace {

const Polygon brick = rectangle({0, 0}, {3, 2});

Solid box(double height) {
  return terraces(wall(brick, 0, height));
}

Solid ribbed(std::uint32_t count, double thickness, double height) {
  Terrace base = wall(rectangle({0, 0}, {4, 3}), 0, 0.3);
  for (std::uint32_t k = 0; k < count; ++k) {
    const double x = 4 * (k + 0.5) / count;
    base.inside.push_back(
        wall(rectangle({x - thickness / 2, 0.2}, {x + thickness / 2, 2.8}), 0.3, 0.3 + height));
  }
  return terraces(base);
}

Solid pyramid_of_steps(std::uint32_t count, double step) {
  Terrace inner = wall(inset(brick, 0.9), (count - 1) * step + 0.4, count * step + 0.4);
  for (std::uint32_t k = count - 1; k-- > 0;) {
    const double height = k * step + 0.4;
    Terrace outer = wall(inset(brick, 0.9 * (k + 1) / count), height, height + step);
    outer.inside.push_back(inner);
    inner = outer;
  }
  Terrace base = wall(brick, 0, 0.4);
  base.inside.push_back(inner);
  return terraces(base);
}

/// Of a profile that lies on its side.
Solid staircase(std::uint32_t count) {
  Polygon profile = {{0, 0}, {3, 0}};
  for (std::uint32_t k = 0; k < count; ++k) {
    const double x = 3 - 3.0 * k / count;
    const double y = 2.0 * (k + 1) / count;
    profile.push_back({x, y});
    profile.push_back({x - 3.0 / count, y});
  }
  profile.back() = {0, 2};
  return terraces(wall(profile, 0, 1.5));
}

Solid filleted_box(double radius, std::uint32_t edges) {
  return terraces(filleted_wall(brick, 0, 1, radius, edges));
}

Solid drafted_box(double slope) {
  return terraces({{{brick, 0}, {inset(brick, slope), 1}}});
}

Solid pocketed(double depth, double margin) {
  Terrace outer = wall(brick, 0, 1);
  outer.inside.push_back(wall(inset(brick, margin), 1, 1 - depth));
  return terraces(outer);
}

Solid nested_pockets() {
  Terrace outer = wall(brick, 0, 1);
  Terrace first = wall(inset(brick, 0.2), 1, 0.7);
  Terrace second = wall(inset(brick, 0.45), 0.7, 0.4);
  second.inside.push_back(round_wall(circle({1.5, 1}, 0.25, 32), 0.4, 0.9));
  first.inside.push_back(second);
  outer.inside.push_back(first);
  return terraces(outer);
}

Solid pocket_with_fillet(double radius) {
  Terrace outer = wall(brick, 0, 1);
  outer.inside.push_back(
      filleted_wall(rounded_rectangle({0.4, 0.4}, {2.6, 1.6}, 0.3, 6), 1, 0.4, radius, 5));
  return terraces(outer);
}

Solid plate_with_text(const std::string& text, double size, double depth, double margin) {
  const double width = 6 * size * static_cast<double>(text.size()) - size + 2 * margin;
  Terrace outer = wall(rectangle({0, 0}, {width, 7 * size + 2 * margin}), 0, 0.6);
  double x = margin;
  for (const char c : text) {
    std::vector<Polygon> lines = letter(c);
    for (Polygon& line : lines) line = moved(scaled(line, size), {x, margin});
    Terrace engraved = wall(lines[0], 0.6, 0.6 - depth);
    if (lines.size() > 1) engraved.inside.push_back(wall(lines[1], 0.6 - depth, 0.6));
    outer.inside.push_back(engraved);
    x += 6 * size;
  }
  return terraces(outer);
}

Solid geared(std::uint32_t teeth, double bore) {
  Terrace outer = wall(gear(teeth, 1, 1.2, 3), 0, 0.5);
  outer.inside.push_back(round_wall(circle({0, 0}, bore, 48), 0.5, 0));
  return terraces(outer);
}

Solid hexagonal_bolt(double chamfer) {
  const Polygon shank = circle({0, 0}, 0.5, 48);
  Terrace head = wall(circle({0, 0}, 1, 6), 0, 0.6);
  Terrace body = chamfer > 0 ? filleted_wall(shank, 0.6, 3, chamfer, 1) : wall(shank, 0.6, 3);
  head.inside.push_back(body);
  return terraces(head);
}

Solid rounded_bracket() {
  const Polygon angle = {{0, 0}, {3, 0}, {3, 0.4}, {0.4, 0.4}, {0.4, 2}, {0, 2}};
  Terrace outer = wall(angle, 0, 1.5);
  outer.inside.push_back(round_wall(circle({1.4, 0.2}, 0.12, 32), 1.5, 0));
  outer.inside.push_back(round_wall(circle({2.4, 0.2}, 0.12, 32), 1.5, 0));
  return terraces(outer);
}

Solid star(std::uint32_t points, double inner) {
  return terraces(wall(gear(points, inner, 1.5, 1), 0, 0.5));
}

Solid tray(double wall_thickness) {
  Terrace outer = wall(brick, 0, 1);
  outer.inside.push_back(wall(inset(brick, wall_thickness), 1, wall_thickness));
  return terraces(outer);
}

Solid rounded_tray(double wall_thickness) {
  const Polygon outline = rounded_rectangle({0, 0}, {3, 2}, 0.5, 8);
  Terrace outer = wall(outline, 0, 1);
  outer.inside.push_back(
      wall(rounded_rectangle({wall_thickness, wall_thickness},
                             {3 - wall_thickness, 2 - wall_thickness}, 0.5 - wall_thickness, 8),
           1, wall_thickness));
  return terraces(outer);
}

Solid case_with_bosses() {
  Terrace outer = wall(brick, 0, 0.8);
  Terrace floor = wall(inset(brick, 0.08), 0.8, 0.08);
  for (const double x : {0.4, 2.6}) {
    for (const double y : {0.4, 1.6}) {
      Terrace boss = round_wall(circle({x, y}, 0.18, 24), 0.08, 0.6);
      boss.inside.push_back(round_wall(circle({x, y}, 0.08, 24), 0.6, 0.2));
      floor.inside.push_back(boss);
    }
  }
  outer.inside.push_back(floor);
  return terraces(outer);
}

}  // namespace

void add_blocks(Cages& cages) {
  const auto add = [&](const std::string& name, const std::string& kind, auto make) {
    cages.push_back(cage(name, kind, make));
  };
  add("box", "ribs and steps", [] { return box(1); });
  add("box_thin", "thin wall", [] { return box(0.01); });
  add("ribs", "ribs and steps", [] { return ribbed(5, 0.25, 0.5); });
  add("ribs_thin", "ribs and steps", [] { return ribbed(5, 0.04, 0.5); });
  add("heat_sink", "ribs and steps", [] { return ribbed(16, 0.08, 1.5); });
  add("ribs_flat", "ribs and steps", [] { return ribbed(8, 0.2, 0.02); });
  add("step_pyramid", "ribs and steps", [] { return pyramid_of_steps(4, 0.2); });
  add("step_pyramid_fine", "ribs and steps", [] { return pyramid_of_steps(20, 0.05); });
  add("staircase", "ribs and steps", [] { return staircase(6); });
  add("staircase_fine", "ribs and steps", [] { return staircase(40); });
  add("chamfer_wide", "chamfers and fillets", [] { return filleted_box(0.2, 1); });
  add("chamfer_narrow", "chamfers and fillets", [] { return filleted_box(0.03, 1); });
  add("fillet_wide", "chamfers and fillets", [] { return filleted_box(0.4, 10); });
  add("fillet", "chamfers and fillets", [] { return filleted_box(0.12, 6); });
  add("fillet_narrow", "chamfers and fillets", [] { return filleted_box(0.03, 4); });
  add("fillet_tiny", "chamfers and fillets", [] { return filleted_box(0.005, 4); });
  add("draft", "chamfers and fillets", [] { return drafted_box(0.3); });
  add("pocket_fillet", "chamfers and fillets", [] { return pocket_with_fillet(0.2); });
  add("pocket", "pockets and letters", [] { return pocketed(0.5, 0.4); });
  add("pocket_deep", "pockets and letters", [] { return pocketed(0.95, 0.7); });
  add("pocket_shallow", "pockets and letters", [] { return pocketed(0.01, 0.4); });
  add("pockets_nested", "pockets and letters", nested_pockets);
  add("letters_engraved", "pockets and letters",
      [] { return plate_with_text("HELLO", 0.12, 0.2, 0.3); });
  add("letters_raised", "pockets and letters",
      [] { return plate_with_text("HALO", 0.12, -0.2, 0.3); });
  add("letters_tiny", "pockets and letters", [] { return plate_with_text("TILE", 0.02, 0.02, 1); });
  add("gear", "pockets and letters", [] { return geared(16, 0.4); });
  add("gear_fine", "pockets and letters", [] { return geared(60, 0.4); });
  add("star", "pockets and letters", [] { return star(5, 0.5); });
  add("star_sharp", "pockets and letters", [] { return star(9, 0.3); });
  add("bracket", "pockets and letters", rounded_bracket);
  add("bolt_hexagonal", "screw or spring", [] { return hexagonal_bolt(0); });
  add("bolt_chamfered", "screw or spring", [] { return hexagonal_bolt(0.1); });
  add("tray", "thin wall", [] { return tray(0.1); });
  add("tray_thin", "thin wall", [] { return tray(0.02); });
  add("tray_paper", "thin wall", [] { return tray(0.004); });
  add("tray_rounded", "thin wall", [] { return rounded_tray(0.06); });
  add("case_with_bosses", "thin wall", case_with_bosses);
}

}  // namespace geolloyd::zoo

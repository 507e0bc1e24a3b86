#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/zoo/changes.h"
#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"
#include "core/base/random.h"

// Parts like the others, as programs write them.
namespace geolloyd::zoo {
namespace {

Solid plate_with_hole(double radius, std::uint32_t corners) {
  Terrace outer = wall(rectangle({0, 0}, {3, 2}), 0, 0.4);
  outer.inside.push_back(round_wall(circle({1, 1}, radius, corners), 0.4, 0));
  return terraces(outer);
}

Solid shaft() {
  return turned({{{0, 0}, {0.5, 0}, {0.5, 1}, {1, 1}, {1, 1.4}, {0.4, 1.4}, {0.4, 2}, {0, 2}}, 40});
}

Solid fillet_block() {
  return terraces(filleted_wall(rectangle({0, 0}, {3, 2}), 0, 1, 0.2, 6));
}

Solid bolts(std::uint32_t count) {
  std::vector<Solid> all;
  for (std::uint32_t k = 0; k < count * count; ++k) {
    const std::uint32_t row = k / count;
    Terrace head = wall(circle({0, 0}, 1, 6), 0, 0.6);
    head.inside.push_back(round_wall(circle({0, 0}, 0.5, 24), 0.6, 2));
    all.push_back(moved(terraces(head), {3.0 * (k % count), 3.0 * row, 0}));
  }
  return together(all);
}

/// In a cell of a grid each, of random sizes.
Solid boxes(std::uint32_t count, std::uint64_t random_seed) {
  std::vector<Solid> all;
  for (std::uint32_t k = 0; k < count * count; ++k) {
    const std::uint32_t row = k / count;
    const std::uint32_t column = k % count;
    const auto side = [&](std::uint64_t n) {
      return 0.1 + 0.8 * random_unit(random_seed, 3UL * k + n);
    };
    const double x = column;
    const double y = row;
    all.push_back(terraces(wall(rectangle({x, y}, {x + side(0), y + side(1)}), 0, side(2))));
  }
  return together(all);
}

/// A block, and balls around it that are smaller than an edge.
Solid block_with_crumbs() {
  std::vector<Solid> all = {terraces(wall(rectangle({-1, -1}, {1, 1}), -1, 1))};
  for (std::uint32_t k = 0; k < 12; ++k) {
    const Point p = circle({0, 0}, 1.8, 12)[k];
    all.push_back(moved(turned({{{0, -0.02}, {0.02, 0}, {0, 0.02}}, 12}), {p.x, p.y, 0}));
  }
  return together(all);
}

}  // namespace

void add_awkward_files(Cages& cages) {
  const auto add = [&](const std::string& name, const std::string& kind,
                       const std::function<Solid()>& make,
                       const std::function<Part(Part)>& change) {
    cages.push_back({name, kind, [=] { return change(part_of(name, kind, make())); }});
  };
  const auto same = [](Part part) { return part; };
  const auto needles = [](std::uint32_t pieces) {
    return [=](Part part) { return with_needles(std::move(part), pieces); };
  };
  const auto fine = [](std::uint32_t frequency) {
    return [=](Part part) { return with_fine_triangles(std::move(part), frequency); };
  };
  const auto hole = [] { return plate_with_hole(0.4, 32); };
  const std::string needly = "needles";
  add("needles_plate", needly, hole, needles(200));
  add("needles_shaft", needly, shaft, needles(50));
  add("needles_fillet", needly, fillet_block, needles(300));
  add(
      "needles_rim", needly, [] { return plate_with_hole(0.5, 720); }, same);
  add(
      "strips_of_a_rod", needly,
      [] {
        return turned({{{0, 0}, {0.2, 0}, {0.2, 6}, {0, 6}}, 360, false, true});
      },
      same);
  const std::string turned_kind = "turned aside";
  add("aside_plate", turned_kind, hole, turned_aside);
  add("aside_shaft", turned_kind, shaft,
      [](Part part) { return with_short_numbers(turned_aside(std::move(part))); });
  add("aside_fillet", turned_kind, fillet_block,
      [](Part part) { return with_short_numbers(turned_aside(std::move(part))); });
  add("fine_plate", "fine triangles", hole, fine(12));
  add("fine_shaft", "fine triangles", shaft,
      [](Part part) { return turned_aside(with_fine_triangles(std::move(part), 8)); });
  add("fine_fillet", "fine triangles", fillet_block, fine(20));
  add("split_plate", "split vertices", hole, with_split_vertices);
  add("split_shaft", "split vertices", shaft, with_split_vertices);
  add("split_fillet", "split vertices", fillet_block, as_soup);
  add(
      "split_bolts", "split vertices", [] { return bolts(2); }, as_soup);
  add(
      "bolts_25", "many pieces", [] { return bolts(5); }, same);
  add(
      "boxes_36", "many pieces", [] { return boxes(6, 1); }, same);
  add(
      "boxes_144", "many pieces", [] { return boxes(12, 2); }, same);
  add("block_with_crumbs", "many pieces", block_with_crumbs, same);
}

}  // namespace geolloyd::zoo

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bench/zoo/solids.h"

namespace geolloyd::zoo {
namespace {

Polygon between(const Polygon& a, const Polygon& b) {
  Polygon middle;
  for (std::size_t i = 0; i < a.size(); ++i) {
    middle.push_back({(a[i].x + b[i].x) / 2, (a[i].y + b[i].y) / 2});
  }
  return middle;
}

class TerraceMaker {
 public:
  explicit TerraceMaker(const Terrace& outermost) : bottom_(outermost.rings.front().height) {
    const VertexId first = add(outermost);
    below_.insert(below_.begin(), {&outermost.rings.front().outline, first});
    cover(below_, true);
    const auto holes = static_cast<std::int64_t>(below_.size()) - 1;
    solid_.parts = {{2 - 2 * holes, 0}};
  }

  Solid take() { return std::move(solid_); }

 private:
  // Returns its first vertex.
  VertexId add(const Terrace& terrace) {
    const auto first = static_cast<VertexId>(solid_.mesh.vertex_count());
    const auto corners = static_cast<VertexId>(terrace.rings.front().outline.size());
    for (const Ring& ring : terrace.rings) {
      for (const Point& p : ring.outline) {
        solid_.mesh.positions.emplace_back(p.x, p.y, ring.height);
      }
    }
    for (std::size_t k = 0; k + 1 < terrace.rings.size(); ++k) {
      add_wall(first + static_cast<VertexId>(k) * corners, corners);
      add_volume(terrace.rings[k], terrace.rings[k + 1]);
    }
    const VertexId last = first + static_cast<VertexId>(terrace.rings.size() - 1) * corners;
    if (terrace.is_round) {
      add_rim(first, corners);
      add_rim(last, corners);
    }
    add_face(terrace, last);
    return first;
  }

  void add_face(const Terrace& terrace, VertexId last) {
    const Ring& ring = terrace.rings.back();
    if (ring.height == bottom_) {
      below_.push_back({&ring.outline, last});
      return;
    }
    std::vector<Outline> outlines = {{&ring.outline, last}};
    for (const Terrace& inner : terrace.inside) {
      outlines.push_back({&inner.rings.front().outline, add(inner)});
    }
    cover(outlines, false);
  }

  void add_wall(VertexId below, VertexId corners) {
    const VertexId above = below + corners;
    for (VertexId i = 0; i < corners; ++i) {
      const VertexId j = (i + 1) % corners;
      solid_.mesh.triangles.push_back({below + i, below + j, above + j});
      solid_.mesh.triangles.push_back({below + i, above + j, above + i});
    }
  }

  void add_volume(const Ring& a, const Ring& b) {
    const double areas =
        area_of(a.outline) + 4 * area_of(between(a.outline, b.outline)) + area_of(b.outline);
    solid_.volume += (b.height - a.height) * areas / 6;
  }

  void add_rim(VertexId first, VertexId corners) {
    const auto begin = solid_.mesh.positions.begin() + first;
    solid_.rims.emplace_back(begin, begin + corners);
  }

  struct Outline {
    const Polygon* polygon = nullptr;
    VertexId first = 0;
  };

  // What is inside the first one and outside the others.
  void cover(const std::vector<Outline>& outlines, bool is_bottom) {
    std::vector<Polygon> polygons;
    std::vector<VertexId> vertex;
    for (const Outline& outline : outlines) {
      polygons.push_back(*outline.polygon);
      for (VertexId i = 0; i < outline.polygon->size(); ++i) vertex.push_back(outline.first + i);
    }
    for (const auto& [a, b, c] : triangulated(polygons)) {
      solid_.mesh.triangles.push_back(
          {vertex[a], vertex[is_bottom ? c : b], vertex[is_bottom ? b : c]});
    }
  }

  double bottom_;
  Solid solid_;
  std::vector<Outline> below_;  // of the bottom
};

}  // namespace

Terrace wall(const Polygon& outline, double from, double to) {
  return {{{outline, from}, {outline, to}}};
}

Terrace round_wall(const Polygon& outline, double from, double to) {
  return {{{outline, from}, {outline, to}}, {}, true};
}

Terrace filleted_wall(const Polygon& outline, double from, double to, double radius,
                      std::uint32_t edges) {
  Terrace terrace{{{outline, from}}};
  const double up = to > from ? radius : -radius;
  for (std::uint32_t k = 0; k <= edges; ++k) {
    const double angle = std::numbers::pi / 2 * k / edges;
    const double height = k == edges ? to : to - up + up * std::sin(angle);
    terrace.rings.push_back({inset(outline, radius * (1 - std::cos(angle))), height});
  }
  return terrace;
}

Solid terraces(const Terrace& outermost) {
  return TerraceMaker(outermost).take();
}

}  // namespace geolloyd::zoo

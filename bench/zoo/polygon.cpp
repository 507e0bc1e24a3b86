#include "bench/zoo/polygon.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace geolloyd::zoo {
namespace {

Point on_circle(double radius, double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Where the lines through a in direction p and through b in direction q meet; b where they are one
// line.
Point meeting(Point a, Point p, Point b, Point q) {
  const double turn = p.x * q.y - p.y * q.x;
  if (std::abs(turn) < 1e-12) return b;
  const double along = ((b.x - a.x) * q.y - (b.y - a.y) * q.x) / turn;
  return {a.x + along * p.x, a.y + along * p.y};
}

}  // namespace

Polygon rectangle(Point low, Point high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Polygon circle(Point middle, double radius, std::uint32_t corners) {
  Polygon polygon;
  for (std::uint32_t i = 0; i < corners; ++i) {
    polygon.push_back(on_circle(radius, static_cast<double>(i) / corners));
  }
  return moved(std::move(polygon), middle);
}

Polygon rounded_rectangle(Point low, Point high, double radius, std::uint32_t edges) {
  const Polygon middles =
      rectangle({low.x + radius, low.y + radius}, {high.x - radius, high.y - radius});
  Polygon polygon;
  for (std::uint32_t corner = 0; corner < 4; ++corner) {
    for (std::uint32_t i = 0; i <= edges; ++i) {
      const double turn = 0.25 * (corner + 2 + static_cast<double>(i) / edges);
      const Point arm = on_circle(radius, turn);
      polygon.push_back({middles[corner].x + arm.x, middles[corner].y + arm.y});
    }
  }
  return polygon;
}

Polygon gear(std::uint32_t teeth, double inner, double outer, std::uint32_t corners_each) {
  Polygon polygon;
  const std::uint32_t corners = 2 * teeth * corners_each;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const bool is_outer = i / corners_each % 2 == 0;
    polygon.push_back(on_circle(is_outer ? outer : inner, static_cast<double>(i) / corners));
  }
  return polygon;
}

Polygon moved(Polygon polygon, Point by) {
  for (Point& p : polygon) p = {p.x + by.x, p.y + by.y};
  return polygon;
}

Polygon scaled(Polygon polygon, double factor) {
  for (Point& p : polygon) p = {p.x * factor, p.y * factor};
  return polygon;
}

Polygon inset(const Polygon& polygon, double distance) {
  const std::size_t size = polygon.size();
  std::vector<Point> along(size);
  Polygon starts(size);
  for (std::size_t i = 0; i < size; ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % size];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    along[i] = {(b.x - a.x) / length, (b.y - a.y) / length};
    starts[i] = {a.x - distance * along[i].y, a.y + distance * along[i].x};
  }
  Polygon result(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t before = (i + size - 1) % size;
    result[i] = meeting(starts[before], along[before], starts[i], along[i]);
  }
  return result;
}

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

std::vector<Polygon> letter(char name) {
  switch (name) {
    case 'A':
      return {{{0, 0}, {1, 0}, {1, 2}, {4, 2}, {4, 0}, {5, 0}, {5, 6}, {4, 7}, {1, 7}, {0, 6}},
              {{1, 3}, {4, 3}, {4, 6}, {1, 6}}};
    case 'E':
      return {{{0, 0},
               {5, 0},
               {5, 1},
               {1, 1},
               {1, 3},
               {4, 3},
               {4, 4},
               {1, 4},
               {1, 6},
               {5, 6},
               {5, 7},
               {0, 7}}};
    case 'H':
      return {{{0, 0},
               {1, 0},
               {1, 3},
               {4, 3},
               {4, 0},
               {5, 0},
               {5, 7},
               {4, 7},
               {4, 4},
               {1, 4},
               {1, 7},
               {0, 7}}};
    case 'I':
      return {rectangle({2, 0}, {3, 7})};
    case 'L':
      return {{{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 7}, {0, 7}}};
    case 'O':
      return {{{1, 0}, {4, 0}, {5, 1}, {5, 6}, {4, 7}, {1, 7}, {0, 6}, {0, 1}},
              {{1, 1.5}, {4, 1.5}, {4, 5.5}, {1, 5.5}}};
    case 'T':
      return {{{2, 0}, {3, 0}, {3, 6}, {5, 6}, {5, 7}, {0, 7}, {0, 6}, {2, 6}}};
    default:
      throw std::invalid_argument("no such letter");
  }
}

}  // namespace geolloyd::zoo

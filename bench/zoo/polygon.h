#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace geolloyd::zoo {

struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// A simple polygon, counterclockwise.
using Polygon = std::vector<Point>;

Polygon rectangle(Point low, Point high);
/// The first corner lies in the direction of x.
Polygon circle(Point middle, double radius, std::uint32_t corners);
/// Each corner an arc of so many edges.
Polygon rounded_rectangle(Point low, Point high, double radius, std::uint32_t edges);
/// A circle whose corners lie on two radii in turn, so many on each before it changes.
Polygon gear(std::uint32_t teeth, double inner, double outer, std::uint32_t corners_each);

Polygon moved(Polygon polygon, Point by);
Polygon scaled(Polygon polygon, double factor);
/// Every edge moved inward by so much, outward where it is less than 0; as many corners as before.
Polygon inset(const Polygon& polygon, double distance);
double area_of(const Polygon& polygon);

/// A block letter of A, E, H, I, L, O, T, 5 wide and 7 high: its outline, and perhaps an island.
std::vector<Polygon> letter(char name);

/// Of what is inside the first polygon and outside the others, which lie within it, apart. By
/// bridges and ears, so with as many needles as a CAD kernel makes. Corners are counted through all
/// polygons.
std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<Polygon>& polygons);

}  // namespace geolloyd::zoo

#include "tools/render/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "geolloyd/errors.h"
#include "tools/words/named.h"
#include "tools/words/numbers.h"

namespace geolloyd {
namespace {

const std::vector<Named<View>> view_names = {
    {"front", {0, 0}},  {"right", {90, 0}}, {"back", {180, 0}},
    {"left", {-90, 0}}, {"top", {0, 90}},   {"bottom", {0, -90}},
};

constexpr double margin = 0.02;  // of the picture's width and height, on each side

// The two numbers of "3,4" or "3x4", and nothing else.
template <class Number>
std::optional<std::array<Number, 2>> parse_pair(const std::string& text, char separator) {
  const std::size_t sign = text.find(separator);
  if (sign == std::string::npos) return std::nullopt;
  const auto first = parse_number<Number>(std::string_view(text).substr(0, sign));
  const auto second = parse_number<Number>(std::string_view(text).substr(sign + 1));
  if (!first || !second) return std::nullopt;
  return std::array<Number, 2>{*first, *second};
}

// The first of the sides that are all but the shortest of those but `other`: a mesh and its remesh
// differ a little, and are to be turned alike.
int shortest_side(const Vec3& extent, int other = -1) {
  constexpr double nearly = 1.02;
  double least = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 3; ++side) {
    if (side != other) least = std::min(least, extent[side]);
  }
  int side = 0;
  while (side == other || extent[side] > nearly * least) ++side;
  return side;
}

Axes axes_of(const BoundingBox& box, const View& view) {
  const Vec3 extent = box.extent();
  const int shortest = shortest_side(extent);
  const Vec3 front = Vec3::Unit(shortest);
  const Vec3 upright = Vec3::Unit(shortest_side(extent, shortest));
  const double azimuth = view.azimuth * std::numbers::pi / 180;
  const double elevation = view.elevation * std::numbers::pi / 180;
  const Vec3 level = std::cos(azimuth) * front + std::sin(azimuth) * cross(upright, front);
  const Vec3 towards = std::cos(elevation) * level + std::sin(elevation) * upright;
  const Vec3 up = std::cos(elevation) * upright - std::sin(elevation) * level;
  return {cross(up, towards), -up, -towards};
}

// Something seen from its end or of no extent at all still has a width.
double width_of(const Outline& outline) {
  const Vec3 extent = outline.box.extent();
  const double width = std::max({extent.x(), extent.y() / 64, extent.z() / 1024});
  return width > 0 ? width : 1;
}

}  // namespace

View parse_view(const std::string& text) {
  for (const Named<View>& named : view_names) {
    if (text == named.name) return named.value;
  }
  const auto angles = parse_pair<double>(text, ',');
  if (angles && std::abs((*angles)[0]) <= 360 && std::abs((*angles)[1]) <= 90) {
    return {(*angles)[0], (*angles)[1]};
  }
  throw InvalidInput("--view " + text +
                     ": give front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in "
                     "degrees, such as 25,15");
}

Size parse_size(const std::string& text) {
  const bool has_height = text.find('x') != std::string::npos;
  const auto pair = parse_pair<int>(has_height ? text : text + "x0", 'x');
  const auto is_good = [](int length) { return length >= least_side && length <= most_side; };
  if (pair && is_good((*pair)[0]) && (!has_height || is_good((*pair)[1]))) {
    return {(*pair)[0], (*pair)[1]};
  }
  throw InvalidInput("--size " + text + ": give WIDTH or WIDTHxHEIGHT in pixels, each from " +
                     std::to_string(least_side) + " to " + std::to_string(most_side) +
                     ", such as 1920x1080");
}

Outline outline_of(std::span<const Vec3> points, const View& view) {
  const Axes axes = axes_of(bounding_box(points), view);
  return {axes, bounding_box(points.size(), [&](std::size_t i) { return axes(points[i]); })};
}

double aspect_of(const Outline& outline) {
  return std::clamp(outline.box.extent().y() / width_of(outline), 1.0 / 64, 2.0);
}

Camera fit_camera(const Outline& outline, Size size) {
  const double room = 1 - 2 * margin;
  const double pixel = std::max(width_of(outline) / (room * size.width),
                                outline.box.extent().y() / (room * size.height));
  const Vec3 middle = outline.box.middle();
  return {outline.axes,
          {middle.x() - pixel * size.width / 2, middle.y() - pixel * size.height / 2,
           outline.box.low.z() - pixel},
          pixel,
          size};
}

}  // namespace geolloyd

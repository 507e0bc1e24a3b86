#pragma once

#include <span>
#include <string>

#include "core/base/bounding_box.h"

namespace geolloyd {

/// Where a mesh is seen from, in degrees. 0,0 is its front: along the shortest side of its bounding
/// box, with the middle one upright (of sides equal within 2 % x before y before z).
struct View {
  double azimuth = 0;    ///< takes the viewer around the mesh, to the viewer's right
  double elevation = 0;  ///< and up, from -90 to 90
};

/// "front", "back", "left", "right", "top", "bottom" or "AZIMUTH,ELEVATION". Throws InvalidInput.
View parse_view(const std::string& text);

/// Of the sides of a picture, pixels. Nine samples a pixel: the largest picture takes 18 GB.
inline constexpr int least_side = 64;
inline constexpr int most_side = 8192;

/// Of a picture, in pixels. Height 0: as high as what it shows.
struct Size {
  int width = 0;
  int height = 0;
};

/// How pictures look, unless they are told otherwise.
struct PictureLook {
  View view{25, 15};
  Size size{1280, 0};
};

/// "WIDTH" or "WIDTHxHEIGHT", each from 64 to 8192. Throws InvalidInput.
Size parse_size(const std::string& text);

/// The directions of a picture: unit vectors at right angles, right-handed.
struct Axes {
  Vec3 right;
  Vec3 down;
  Vec3 away;  ///< from the viewer

  /// Components of `p` along them.
  [[nodiscard]] Vec3 operator()(const Vec3& p) const {
    return {dot(p, right), dot(p, down), dot(p, away)};
  }
};

/// How much room something takes as it is seen.
struct Outline {
  Axes axes;
  BoundingBox box;  ///< along the axes
};

Outline outline_of(std::span<const Vec3> points, const View& view);

/// A parallel projection into the space of a picture: x to the right and y down from its upper left
/// corner, z away from the viewer, all in pixels.
struct Camera {
  Axes axes;
  Vec3 corner;       ///< what becomes 0, 0, 0, along the axes
  double pixel = 1;  ///< its side in mesh units
  Size size;

  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return (axes(p) - corner) / pixel; }
};

/// Height over width of the picture that an outline fills, from 1/64 to 2.
double aspect_of(const Outline& outline);

/// The largest picture in the middle of `size`, with a little room around it and z from 1 on.
Camera fit_camera(const Outline& outline, Size size);

}  // namespace geolloyd

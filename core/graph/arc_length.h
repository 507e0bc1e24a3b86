#pragma once

#include <string_view>

#include "core/base/vec3.h"
#include "core/fields/tangent_field.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// Length of displacement `d`; for norms other than geodesic, along the axes of the coordinates.
double measure(const Vec3& d, Norm norm_kind);

/// Length of `d` in a tangent space, whose directions are then the axes.
double measure(const Vec3& d, const TangentSpace& space, Norm norm_kind);

/// Length of the shortest way from `a` to `b` over two triangles that share the edge `e0`-`e1` and
/// have `a` and `b` on their planes, on the far sides of the edge: the straight line after
/// unfolding both into one plane or, where that line would miss the edge, the shorter way through
/// an end of it.
double unfolded_distance(const Vec3& a, const Vec3& b, const Vec3& e0, const Vec3& e1);

}  // namespace geolloyd

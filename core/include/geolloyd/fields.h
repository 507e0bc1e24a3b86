#pragma once

#include <vector>

#include "geolloyd/choices.h"
#include "geolloyd/mesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

// Fields that a surface has of itself, one tangent space per vertex. Throw InvalidInput where the
// mesh is not valid.

/// The principal directions of curvature, with magnitudes that go as the roots of the principal
/// curvatures (core/fields/curvature_field.h): equal lengths in the metric are equal heights of the
/// surface above its chords.
std::vector<TangentSpace> curvature_field(const Mesh& mesh, Runtime& runtime = all_threads());

/// Directions at a right angle, as smooth as can be, with magnitudes of 1
/// (core/fields/cross_field.h): the axes that norms other than the geodesic one want.
std::vector<TangentSpace> cross_field(const Mesh& mesh, Runtime& runtime = all_threads());

}  // namespace geolloyd

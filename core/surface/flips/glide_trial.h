#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/surface/flips/glide_paths.h"

namespace geolloyd {

/// What a path of flips, and the fit of what is about it, change of a remesh.
struct Glide {
  std::vector<FlippableTriangles::Side> flips;  ///< one after the other
  std::vector<std::pair<VertexId, Vec3>> moved;
  std::vector<TriangleId> triangles;  ///< whose samples are anew these:
  std::vector<std::pair<TriangleId, PlacedSample>> samples;
};

/// Flips the edges of a path on a copy of a patch, fits what is about them, and says what changes
/// where that is for the better: where the functional of the fit gets less, irregular vertices
/// having their price, than it does by the fit alone. It is not for the better where an angle gets
/// small, a triangle turns away from those around it, or samples are much farther.
std::optional<Glide> try_glide(const GlidingRemesh& remesh, GlidePatch patch, const FlipPath& path);

}  // namespace geolloyd

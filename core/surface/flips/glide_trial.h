#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/surface/flips/glide_paths.h"

namespace geolloyd {

/// What a path of flips, and the fit of what is about it, change of a remesh.
struct Glide {
  std::vector<FlippableTriangles::Side> flips;               ///< one after the other
  std::vector<std::pair<VertexId, Vec3>> positions;          ///< of the vertices about it
  std::vector<TriangleId> triangles;                         ///< those about it
  std::vector<std::pair<TriangleId, PlacedSample>> samples;  ///< all that these have now
};

/// Flips the edges of a path on a copy of a patch, fits what is about them, and says what changes
/// where that is for the better: the functional of the fit, with a price for irregular vertices,
/// gets less than it does by the fit alone. An angle that gets small rules it out, a triangle that
/// turns away from those around it, and samples that are much farther.
std::optional<Glide> try_glide(const GlidingRemesh& remesh, GlidePatch patch, const FlipPath& path);

}  // namespace geolloyd

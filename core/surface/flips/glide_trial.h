#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/surface/flips/glide_paths.h"

namespace geolloyd {

/// What a change, and the fit of what is about it, make of a remesh.
struct Glide {
  double change = 0;  ///< of the functional, over the price of a triangle's strain
  int fewer = 0;      ///< irregular vertices
  std::vector<FlippableTriangles::Replacement> triangles;    ///< all about it
  std::vector<std::pair<VertexId, Vec3>> positions;          ///< of the vertices about it
  std::vector<std::pair<TriangleId, PlacedSample>> samples;  ///< all that these have now
  VertexId gone = no_id;                                     ///< by a collapse
  double area_at_new = 0;  ///< of a split's new vertex: a triangle's, asked for
};

/// Changes a copy of a patch, fits what is about the change, and says what differs then, where that
/// is for the better: the functional of the fit, with a price for irregular vertices, gets less
/// than it does by the fit alone. An angle that gets small rules it out, a triangle that turns away
/// from those around it, and samples that are much farther.
std::optional<Glide> try_glide(const GlidingRemesh& remesh, GlidePatch patch,
                               const PatchChange& change, double most = -1e-3);

/// Makes the remesh what a trial has found.
void take_glide(const Glide& glide, GlidingRemesh& remesh);

}  // namespace geolloyd

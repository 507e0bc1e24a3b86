#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "geolloyd/properties.h"
#include "tools/render/labels.h"
#include "tools/render/scene.h"

namespace geolloyd {

/// The colours that a mesh has of its own: those of its vertices or, if they have none, those of
/// its triangles. Both are empty where it has none.
struct SurfaceColours {
  std::vector<Colour> of_vertices;
  std::vector<Colour> of_triangles;
  std::vector<Triangle> corners =
      {};  ///< the vertices whose colours triangles have, unless their own

  /// What a sample of a scene with this mesh shows; `plain` where there are no colours.
  [[nodiscard]] Colour at(const Scene& scene, std::size_t sample, const Colour& plain) const;
};

/// Of red, green and blue: integers are shares of the largest of their type, others of 1. What is
/// no number is grey.
SurfaceColours colours_of(const Properties& properties);

}  // namespace geolloyd

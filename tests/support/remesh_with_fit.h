#pragma once

#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// By the reference; without the fit its vertices are on the surface.
inline Remesh remesh_with_fit(const Mesh& mesh, std::size_t vertices, bool fit) {
  RemeshOptions options;
  options.vertex_count = vertices;
  options.fit = fit;
  return remesh(mesh, options, reference_runtime());
}

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/start/surface_start.h"

namespace geolloyd {

/// How fine the surface for so many sites is.
struct SurfaceFineness {
  double area = 0;  ///< mesh units
  SurfaceInputOptions options;
};

/// `edges` must live on.
SurfaceFineness surface_fineness(const Mesh& mesh, const MeshEdges& edges, std::size_t sites);

/// What the stages of a surface remesh start from, as the reference engine left it.
struct RestedSurface : SurfaceStart {
  std::vector<double> spacings;  ///< of the levels, ascending
  double energy = 0;             ///< of the sites at rest
};

RestedSurface rest_on_surface(const Mesh& mesh, const MeshEdges& edges, std::size_t sites);

}  // namespace geolloyd

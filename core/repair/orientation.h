#pragma once

#include "core/repair/mesh_under_repair.h"
#include "geolloyd/repair.h"

namespace geolloyd {

/// Turns triangles of a manifold until neighbours have the same orientation. Only components in
/// which some disagree are touched: closed ones are turned outward by the sign of their volume;
/// others, and those without a volume, as most of their area is, or as their first triangle is. A
/// component that cannot be oriented stays as it is. Near-linear.
void orient(Mesh& mesh, Repairs& repairs);

}  // namespace geolloyd

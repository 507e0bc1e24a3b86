#pragma once

#include <functional>
#include <span>

#include "core/surface/cells/surface_engine.h"

namespace geolloyd {

/// Is told where sites are, in the unit frame, each time their cells have been measured.
using SiteCallback = std::function<void(std::span<const Vec3> sites)>;

/// Engines that do what those of `make` do, and tell `callback` of it.
MakeSurfaceEngine watched(MakeSurfaceEngine make, SiteCallback callback);

}  // namespace geolloyd

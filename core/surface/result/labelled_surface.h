#pragma once

#include "core/base/executor.h"
#include "core/dual/region_surface.h"
#include "core/surface/features/patches.h"
#include "core/surface/sites/site_levels.h"

namespace geolloyd {

/// The surface with the cells of labelled sites as regions, of which a dual can be made.
/// Sub-resolution holes are closed.
RegionSurface label_surface(const SurfaceInput& input, const FeatureCurves& curves,
                            const LabelledSites& state, Executor& executor = sequential());

}  // namespace geolloyd

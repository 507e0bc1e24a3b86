#pragma once

#include <memory>

#include "core/surface/cells/surface_engine.h"

namespace geolloyd {

/// The sequential reference: visits every vertex in each sweep, and every triangle each time.
std::unique_ptr<SurfaceEngine> make_reference_surface_engine(const FineMesh& mesh);

}  // namespace geolloyd

#pragma once

#include <optional>
#include <string>

#include "core/mesh/quad_pairs.h"
#include "core/regions/graph_dual.h"
#include "tools/files/json.h"

namespace geolloyd {

/// The lines of the summary.
std::string describe(const GraphDual& dual);
std::string describe(const std::optional<QuadPairs>& quads);

/// Its part of report.json.
Json dual_part(const GraphDual& dual);
Json quads_part(const std::optional<QuadPairs>& quads);

}  // namespace geolloyd

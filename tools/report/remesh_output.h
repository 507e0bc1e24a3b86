#pragma once

#include <optional>
#include <string>

#include "core/mesh/quad_pairs.h"
#include "core/remesh/remesh.h"
#include "tools/files/json.h"

namespace geolloyd {

/// The lines of the summary.
std::string describe(const GraphRemesh& remesh);
std::string describe(const std::optional<QuadPairs>& quads);

/// Its part of report.json.
Json remesh_part(const GraphRemesh& remesh);
Json quads_part(const std::optional<QuadPairs>& quads);

}  // namespace geolloyd

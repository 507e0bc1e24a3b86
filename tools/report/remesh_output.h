#pragma once

#include <string>

#include "core/remesh/remesh.h"
#include "tools/files/json.h"

namespace geolloyd {

/// The lines of the summary.
std::string describe(const GraphRemesh& remesh);

/// Its part of report.json.
Json remesh_part(const GraphRemesh& remesh);

}  // namespace geolloyd

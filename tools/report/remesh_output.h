#pragma once

#include <string>

#include "core/remesh/remesh.h"
#include "tools/files/json.h"

namespace geolloyd {

/// The lines of the summary.
std::string describe(const Remesh& remesh);

/// Its part of report.json.
Json remesh_part(const Remesh& remesh);

}  // namespace geolloyd

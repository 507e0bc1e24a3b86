#pragma once

#include <span>
#include <string>

#include "geolloyd/remesh.h"

namespace geolloyd {

/// A line for each, as standard error has it. `about` begins them: of several meshes, which one.
std::string lines_of_warnings(std::span<const RemeshWarning> warnings,
                              const std::string& about = "");

}  // namespace geolloyd

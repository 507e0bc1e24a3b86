#pragma once

#include "tools/cli/cli_fwd.h"
#include "tools/files/mesh_reading.h"

namespace geolloyd {

/// Adds --format and --no-weld to a command that reads a mesh.
void add_reading_options(CLI::App& command, MeshReading& reading);
/// Adds --no-weld alone, where every mesh has a name that tells its format.
void add_weld_option(CLI::App& command, MeshReading& reading);

}  // namespace geolloyd

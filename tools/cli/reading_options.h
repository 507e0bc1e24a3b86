#pragma once

#include <string>

#include "tools/cli/cli_fwd.h"
#include "tools/files/mesh_reading.h"
#include "tools/files/mesh_target.h"

namespace geolloyd {

/// Adds --format and --no-weld to a command that reads a mesh.
void add_reading_options(CLI::App& command, MeshReading& reading);
/// Adds --format alone, where nothing is welded.
void add_format_option(CLI::App& command, MeshReading& reading);
/// Adds -o, called so: `what` is written there.
void add_output_option(CLI::App& command, MeshTarget& target, const std::string& what);
/// Adds --output-format, which add_output_option adds, too.
void add_output_format_option(CLI::App& command, MeshTarget& target);
/// Adds --no-weld alone, where every mesh has a name that tells its format.
void add_weld_option(CLI::App& command, MeshReading& reading);

}  // namespace geolloyd

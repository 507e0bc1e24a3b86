#pragma once

#include <optional>

#include "core/formats/mesh_formats.h"
#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Adds --format to a command that reads a mesh.
void add_format_option(CLI::App& command, std::optional<MeshFormat>& format);

}  // namespace geolloyd

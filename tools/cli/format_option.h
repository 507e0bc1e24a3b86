#pragma once

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Adds --format, which calls set_input_format (input_format.h), to a command that reads a mesh,
/// unless it has another option of that name.
void add_format_option(CLI::App& command);

}  // namespace geolloyd

#pragma once

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Adds --quiet, which calls silence() (summary.h).
void add_quiet_option(CLI::App& command);

/// Adds --json, which calls want_json(): the command has to print_json() all its figures.
void add_json_option(CLI::App& command);

}  // namespace geolloyd

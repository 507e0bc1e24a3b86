#pragma once

#include <filesystem>

#include "tools/cli/cli_fwd.h"
#include "tools/system/console.h"

namespace geolloyd {

/// Adds --quiet: silences the console, which must live on.
void add_quiet_option(CLI::App& command, Console& console);

/// Adds --json: the console, which must live on, then wants JSON, and the command has to print all
/// its figures as such.
void add_json_option(CLI::App& command, Console& console);

/// Adds --issues: a file that names what is wrong with a mesh, and where.
void add_issues_option(CLI::App& command, std::filesystem::path& file);

/// Adds --strict: warnings end the command with exit status 3.
void add_strict_option(CLI::App& command, bool& is_strict);

}  // namespace geolloyd

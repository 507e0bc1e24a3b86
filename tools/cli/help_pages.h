#pragma once

#include <string>

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

// What is made of the help text for other programs.

/// A script for bash that completes commands, options, choices and files.
std::string bash_completion(const CLI::App& program);

/// A manual page in troff: all commands and options. `name` has the version, too.
std::string manual_page(const CLI::App& program, const std::string& name);

}  // namespace geolloyd

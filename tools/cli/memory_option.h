#pragma once

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// Adds --memory-limit, which calls limit_memory (memory_limit.h).
void add_memory_option(CLI::App& command);

}  // namespace geolloyd

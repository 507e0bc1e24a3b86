#pragma once

#include "tools/cli/cli_fwd.h"
#include "tools/system/console.h"

namespace geolloyd {

// The commands that measure the engines and heuristics. Nothing else in the program needs them:
// whoever leaves this room out loses these three commands.

void add_compare_command(CLI::App& program, Console& console);
void add_profile_command(CLI::App& program, Console& console);
void add_batch_command(CLI::App& program, Console& console);

}  // namespace geolloyd

#pragma once

#include "tools/cli/cli_fwd.h"
#include "tools/system/console.h"

namespace geolloyd {

// Each adds one subcommand to the program, with its options and its callback. A callback returns
// normally or throws: Error becomes one line and exit status 2. The console must live on.

void add_relax_command(CLI::App& program, Console& console);
void add_remesh_command(CLI::App& program, Console& console);
void add_remesh_all_command(CLI::App& program, Console& console);
void add_render_command(CLI::App& program, Console& console);
void add_verify_command(CLI::App& program, Console& console);
void add_ground_truth_command(CLI::App& program, Console& console);
void add_generate_command(CLI::App& program, Console& console);
void add_subdivide_command(CLI::App& program, Console& console);
void add_convert_command(CLI::App& program, Console& console);
void add_info_command(CLI::App& program, Console& console);
void add_repair_command(CLI::App& program, Console& console);
void add_quality_command(CLI::App& program, Console& console);
void add_view_command(CLI::App& program, Console& console);
// Both print what is made of all commands of the program.
void add_completion_command(CLI::App& program);
void add_man_command(CLI::App& program);

}  // namespace geolloyd

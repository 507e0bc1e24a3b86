#pragma once

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

// Each adds one subcommand to the program, with its options and its callback. A callback returns
// normally or throws: Error becomes one line and exit status 2.

void add_relax_command(CLI::App& program);
void add_remesh_command(CLI::App& program);
void add_remesh_all_command(CLI::App& program);
void add_render_command(CLI::App& program);
void add_verify_command(CLI::App& program);
void add_ground_truth_command(CLI::App& program);
void add_generate_command(CLI::App& program);
void add_subdivide_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_repair_command(CLI::App& program);
void add_quality_command(CLI::App& program);
void add_view_command(CLI::App& program);
// Both print what is made of all commands of the program.
void add_completion_command(CLI::App& program);
void add_man_command(CLI::App& program);

}  // namespace geolloyd

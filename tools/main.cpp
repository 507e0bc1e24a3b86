#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "core/errors.h"
#include "tools/commands.h"
#include "tools/memory_limit.h"

namespace {

constexpr int status_error = 1;      // ours to mend
constexpr int status_bad_input = 2;  // the user's to mend
constexpr int status_interrupted = 130;

// One line, whatever stands in the name of a file.
int complain(int status, std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' '; }, '?');
  std::fprintf(stderr, "geolloyd: %s\n", message.c_str());
  return status;
}

int run(int argc, char** argv) {
  CLI::App program(
      "Geodesic centroidal Voronoi tessellations of triangle meshes.\n"
      "Try: geolloyd generate creature -o creature.ply\n"
      "     geolloyd relax creature.ply --seeds 2048 -o result");
  program.name("geolloyd");
  program.set_version_flag("--version", "geolloyd " GEOLLOYD_VERSION);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  geolloyd::add_relax_command(program);
  geolloyd::add_render_command(program);
  geolloyd::add_verify_command(program);
  geolloyd::add_compare_command(program);
  geolloyd::add_profile_command(program);
  geolloyd::add_batch_command(program);
  geolloyd::add_ground_truth_command(program);
  geolloyd::add_generate_command(program);
  geolloyd::add_subdivide_command(program);
  geolloyd::add_info_command(program);
  geolloyd::add_quality_command(program);
  for (CLI::App* command : program.get_subcommands({})) geolloyd::add_memory_option(*command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (asked_for) return program.exit(error);
    return complain(status_bad_input, std::string(error.what()) + ": see geolloyd --help");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    geolloyd::limit_memory(geolloyd::available_memory());
    return run(argc, argv);
  } catch (const geolloyd::Error& error) {
    return complain(status_bad_input, error.what());
  } catch (const geolloyd::InterruptedExit&) {
    return status_interrupted;
  } catch (const std::bad_alloc&) {
    return complain(status_bad_input, geolloyd::out_of_memory_message());
  } catch (const std::exception& error) {
    return complain(status_error, error.what());
  }
}

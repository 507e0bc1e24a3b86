#include "tools/cli/summary_options.h"

#include <CLI/App.hpp>

#include "tools/system/summary.h"

namespace geolloyd {

void add_quiet_option(CLI::App& command) {
  command.add_flag_callback("--quiet", silence, "Print nothing but errors");
}

void add_json_option(CLI::App& command) {
  command.add_flag_callback("--json", want_json, "Print all figures as JSON, for scripts");
}

}  // namespace geolloyd

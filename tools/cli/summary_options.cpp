#include "tools/cli/summary_options.h"

#include <CLI/App.hpp>

namespace geolloyd {

void add_quiet_option(CLI::App& command, Console& console) {
  command.add_flag_callback(
      "--quiet", [&console] { console.silence(); }, "Print nothing but errors");
}

void add_json_option(CLI::App& command, Console& console) {
  command.add_flag_callback(
      "--json", [&console] { console.want_json(); }, "Print all figures as JSON, for scripts");
}

}  // namespace geolloyd

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

void add_issues_option(CLI::App& command, std::filesystem::path& file) {
  command
      .add_option("--issues", file,
                  "CSV file that names the pairs of triangles that cross, and where")
      ->type_name("FILE");
}

void add_strict_option(CLI::App& command, bool& is_strict) {
  command.add_flag("--strict", is_strict,
                   "Exit with status 3, once all files are written, where there is a\n"
                   "warning: the result is bad");
}

}  // namespace geolloyd

#include "tools/cli/reading_options.h"

#include <CLI/App.hpp>
#include <string>

#include "tools/cli/choice_option.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {

void add_weld_option(CLI::App& command, MeshReading& reading) {
  command.add_flag("!--no-weld", reading.weld,
                   "Leave vertices apart that a file has several times in the same\n"
                   "place, as for several normals");
}

void add_output_option(CLI::App& command, MeshTarget& target, const std::string& what) {
  command.add_option("-o,--output", target.file, what + ": " + output_mesh_text)
      ->type_name("FILE")
      ->required();
  add_output_format_option(command, target);
}

void add_output_format_option(CLI::App& command, MeshTarget& target) {
  const auto set = [&target](const std::string& name) {
    target.format = value_of(written_format_names, name);
  };
  one_of(command.add_option_function<std::string>(
             "--output-format", set,
             "Format of what is written, if its name does not tell it, as that\n"
             "of standard output (-): without this, that of --format, or ply"),
         written_format_names);
}

void add_format_option(CLI::App& command, MeshReading& reading) {
  const auto set = [&reading](const std::string& name) {
    reading.format = value_of(read_format_names, name);
  };
  one_of(command.add_option_function<std::string>(
             "--format", set,
             "Format of a mesh whose name does not tell it, as that of\nstandard input (-)"),
         read_format_names);
}

void add_reading_options(CLI::App& command, MeshReading& reading) {
  add_format_option(command, reading);
  add_weld_option(command, reading);
}

}  // namespace geolloyd

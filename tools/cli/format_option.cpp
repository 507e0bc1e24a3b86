#include "tools/cli/format_option.h"

#include <CLI/App.hpp>
#include <string>

#include "tools/cli/choice_option.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {

void add_format_option(CLI::App& command, std::optional<MeshFormat>& format) {
  const auto set = [&format](const std::string& name) {
    format = value_of(read_format_names, name);
  };
  one_of(command.add_option_function<std::string>(
             "--format", set,
             "Format of a mesh whose name does not tell it, as that of\nstandard input (-)"),
         read_format_names);
}

}  // namespace geolloyd

#include "tools/cli/folder_option.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/formats/mesh_formats.h"

namespace geolloyd {

CLI::Option* folder_name(CLI::Option* option) {
  const auto check = [](const std::string& name) -> std::string {
    std::error_code error;
    if (!has_mesh_name(name) || std::filesystem::is_directory(name, error)) return "";
    return "'" + name + "' is the name of a mesh file: give that of a folder for all results";
  };
  return option->check(CLI::Validator(check, ""))->type_name("FOLDER");
}

}  // namespace geolloyd

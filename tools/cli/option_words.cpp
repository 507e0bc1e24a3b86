#include "tools/cli/option_words.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace geolloyd {
namespace {

std::vector<std::string> parts(const std::string& value) {
  std::vector<std::string> found;
  std::istringstream stream(value);
  for (std::string part; std::getline(stream, part, '|');) found.push_back(part);
  return found;
}

}  // namespace

std::vector<std::string> OptionWords::choices() const {
  std::vector<std::string> found = parts(value);
  std::erase_if(found, [](const std::string& part) {
    return part.empty() || std::islower(static_cast<unsigned char>(part.front())) == 0;
  });
  return found;
}

bool OptionWords::takes_file() const {
  const std::vector<std::string> found = parts(value);
  const auto is_file = [](const std::string& part) {
    return part == "FILE" || part == "FOLDER" || part == "MESH";
  };
  return std::any_of(found.begin(), found.end(), is_file) || (is_argument() && value.empty());
}

std::vector<OptionWords> option_words(const CLI::App& command) {
  std::vector<OptionWords> all;
  for (const CLI::Option* option : command.get_options()) {
    OptionWords words;
    for (const std::string& name : option->get_snames()) words.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) words.names.push_back("--" + name);
    if (words.is_argument()) words.argument = option->get_name(true);
    if (option->get_items_expected_max() > 0) {
      words.value = option->get_type_name();
      words.default_value = option->get_default_str();
    }
    words.description = in_one_line(option->get_description());
    words.is_required = option->get_required();
    all.push_back(std::move(words));
  }
  return all;
}

std::string in_one_line(const std::string& text) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

}  // namespace geolloyd

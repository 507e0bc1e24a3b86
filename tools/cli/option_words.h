#pragma once

#include <string>
#include <vector>

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

/// What an option or an argument of a command takes, as its help tells it.
struct OptionWords {
  std::vector<std::string> names;  ///< "-n", "--vertices"; of an argument none
  std::string argument;            ///< "MESH"; of an option empty
  std::string value;               ///< "auto|off|ANGLE"; of a flag empty
  std::string default_value;
  std::string description;  ///< one line
  bool is_required = false;

  [[nodiscard]] bool is_argument() const { return names.empty(); }
  /// The words among what it takes: "auto", "off".
  [[nodiscard]] std::vector<std::string> choices() const;
  [[nodiscard]] bool takes_file() const;
};

/// In the order of the help.
std::vector<OptionWords> option_words(const CLI::App& command);

/// Text in one line.
std::string in_one_line(const std::string& text);

}  // namespace geolloyd

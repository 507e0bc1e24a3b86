#include <CLI/CLI.hpp>

#include "tools/cli/help_pages.h"
#include "tools/cli/option_words.h"

namespace geolloyd {
namespace {

// So that troff takes each character for itself.
std::string escaped(const std::string& text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    begins_line = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

std::string heading(const OptionWords& option) {
  if (option.is_argument()) return italic(option.argument);
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + bold(name);
  return option.value.empty() ? text : text + " " + italic(option.value);
}

std::string entry(const OptionWords& option) {
  std::string text = ".TP\n" + heading(option) + "\n" + escaped(option.description);
  if (!option.default_value.empty()) text += " (default: " + escaped(option.default_value) + ")";
  return text + "\n";
}

// MESH, and the options that must be there.
std::string synopsis(const std::string& command, const std::vector<OptionWords>& options) {
  std::string text = bold("geolloyd " + command) + " [options]";
  for (const OptionWords& option : options) {
    if (option.is_argument()) text += " " + italic(option.argument);
    if (!option.is_argument() && option.is_required) {
      text += " " + bold(option.names.back()) + " " + italic(option.value);
    }
  }
  return text;
}

std::string section(const CLI::App& command) {
  const std::vector<OptionWords> options = option_words(command);
  std::string text = ".SS " + escaped(command.get_name()) + "\n" +
                     synopsis(command.get_name(), options) + "\n.PP\n" +
                     escaped(in_one_line(command.get_description())) + ".\n";
  for (const OptionWords& option : options) text += entry(option);
  if (!command.get_footer().empty()) {
    text += ".PP\n" + escaped(in_one_line(command.get_footer())) + "\n";
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& name) {
  std::string text = R"(.TH GEOLLOYD 1 "" ")" + escaped(name) + R"(" "User Commands"
.SH NAME
geolloyd \- remeshes and centroidal Voronoi tessellations of triangle meshes
.SH SYNOPSIS
)" + bold("geolloyd") +
                     " " + italic("COMMAND") + R"( [options]
.SH DESCRIPTION
.nf
)" + escaped(program.get_description()) +
                     R"(
.fi
.PP
The exit status is 0 where the work is done, 2 where the input or an option cannot be used,
130 after an interrupt, and 1 after a fault of the program.
.SH OPTIONS
)";
  for (const OptionWords& option : option_words(program)) text += entry(option);
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    text += section(*command);
  }
  return text;
}

}  // namespace geolloyd

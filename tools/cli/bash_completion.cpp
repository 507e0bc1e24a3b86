#include <CLI/CLI.hpp>

#include "tools/cli/help_pages.h"
#include "tools/cli/option_words.h"

namespace geolloyd {
namespace {

std::string joined_words(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

// "remesh --engine") words="parallel reference" files= ;;
std::string value_case(const std::string& command, const OptionWords& option) {
  if (option.value.empty() || option.is_argument()) return "";
  std::string pattern;
  for (const std::string& name : option.names) {
    if (!pattern.empty()) pattern += " | ";
    pattern.append("\"").append(command).append(" ").append(name).append("\"");
  }
  return "    " + pattern + ") words=\"" + joined_words(option.choices()) +
         "\" files=" + (option.takes_file() ? "yes" : "") + " ;;\n";
}

// remesh) options="--vertices ..." words="" files=yes ;;
std::string command_case(const std::string& command, const std::vector<OptionWords>& options) {
  std::vector<std::string> names;
  std::vector<std::string> choices;
  bool takes_file = false;
  for (const OptionWords& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!option.is_argument()) continue;
    for (const std::string& choice : option.choices()) choices.push_back(choice);
    takes_file = takes_file || option.takes_file();
  }
  return "    " + command + ") options=\"" + joined_words(names) + "\" words=\"" +
         joined_words(choices) + "\" files=" + (takes_file ? "yes" : "") + " ;;\n";
}

constexpr const char* head =
    R"(# Completes the words of geolloyd in bash: source <(geolloyd completion bash)
_geolloyd() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words= options= files=
  if [ "$current" = "=" ]; then
    current=
  elif [ "$before" = "=" ]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
)";

constexpr const char* tail = R"(  mapfile -t COMPREPLY < <(
    compgen -W "$words" -- "$current"
    [ -z "$files" ] || compgen -f -- "$current"
  )
  [ -z "$files" ] || compopt -o filenames 2>/dev/null
}
complete -F _geolloyd geolloyd
)";

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::vector<std::string> commands;
  std::string by_value;
  std::string by_command;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string& name = command->get_name();
    commands.push_back(name);
    const std::vector<OptionWords> options = option_words(*command);
    for (const OptionWords& option : options) by_value += value_case(name, option);
    by_command += command_case(name, options);
  }
  for (const OptionWords& option : option_words(program)) {
    commands.insert(commands.end(), option.names.begin(), option.names.end());
  }
  return std::string(head) + "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    words=\"" +
         joined_words(commands) + "\"\n  else\n    case \"${COMP_WORDS[1]} $before\" in\n" +
         by_value + "    *)\n      case \"${COMP_WORDS[1]}\" in\n" + by_command +
         "      esac\n      case \"$current\" in -*) words=$options files= ;; esac ;;\n"
         "    esac\n  fi\n" +
         tail;
}

}  // namespace geolloyd

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <vector>

#include "tools/cli/choice_option.h"
#include "tools/cli/help_pages.h"
#include "tools/commands/commands.h"
#include "tools/system/build_facts.h"

namespace geolloyd {
namespace {

enum class Shell { bash };
const std::vector<Named<Shell>> shell_names = {{"bash", Shell::bash}};

}  // namespace

void add_completion_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("completion", "Print a script that completes the words of geolloyd");
  const auto shell = std::make_shared<Shell>(Shell::bash);
  add_choice(*command, "SHELL", *shell, shell_names, "For which shell")->required();
  command->footer("For this session: source <(geolloyd completion bash)");
  command->callback([&program, shell] { fmt::print("{}", bash_completion(program)); });
}

void add_man_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("man", "Print the manual page: geolloyd man | man -l -");
  command->callback([&program] { fmt::print("{}", manual_page(program, program_name())); });
}

}  // namespace geolloyd

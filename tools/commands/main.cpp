#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "geolloyd/errors.h"
#include "tools/cli/memory_option.h"
#include "tools/cli/suggestion.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/laboratory/laboratory.h"
#include "tools/system/available_memory.h"
#include "tools/system/build_facts.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_limit.h"
#include "tools/system/standard_streams.h"

namespace {

constexpr int status_error = 1;      // ours to mend
constexpr int status_bad_input = 2;  // the user's to mend
constexpr int status_warned = 3;     // the results are there
constexpr int status_interrupted = 130;

// One line, whatever stands in the name of a file.
int complain(int status, std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' '; }, '?');
  std::fprintf(stderr, "geolloyd: %s\n", message.c_str());
  return status;
}

// A library that cannot start a thread throws where nothing may be thrown.
[[noreturn]] void end_by_exception() {
  std::string what;
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc& error) {
    what = error.what();
  } catch (const std::runtime_error& error) {
    what = error.what();
  } catch (...) {
    std::abort();
  }
  if (what.empty()) std::abort();
  _exit(complain(status_bad_input,
                 "out of memory or threads: " + what + ": use fewer --threads or a smaller mesh"));
}

// An empty value is what a script's unset variable leaves, and nobody's wish.
void refuse_empty_values(CLI::App& program) {
  const CLI::Validator check(
      [](const std::string& text) { return std::string(text.empty() ? "empty" : ""); }, "");
  for (CLI::App* command : program.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      if (option->get_items_expected_max() > 0) option->check(check);
    }
  }
}

// What the user meant by a word that is no name of ours; empty where no name is near.
std::string suggest(const std::string& word, const std::vector<std::string>& names) {
  const std::string name = geolloyd::closest_name(word, names);
  return name.empty() ? "" : " (did you mean " + name + "?)";
}

std::string suggest_command(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return suggest(word, names);
}

std::string suggest_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return suggest(word, names);
}

// Where a name was mistyped, CLI11 may miss what it stands for instead, or name all words left
// over.
std::string explain(const CLI::App& program, const CLI::ParseError& error) {
  const bool has_words_left =
      error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) ||
      error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
  const std::vector<CLI::App*> commands = program.get_subcommands();
  for (const std::string& word : program.remaining(true)) {
    const bool is_option = word.starts_with("--");
    if (!has_words_left || (!is_option && !commands.empty())) continue;
    const std::string name = word.substr(0, word.find('='));
    const std::string meant =
        is_option ? suggest_option(commands.empty() ? program : *commands.front(), name)
                  : suggest_command(program, name);
    if (!meant.empty() || !is_option) {
      std::string unknown = is_option ? "no option " : "no command ";
      return unknown.append(name).append(meant);
    }
  }
  return error.what();
}

void run(int argc, char** argv) {
  geolloyd::Console console;
  CLI::App program(
      "Remeshes and geodesic centroidal Voronoi tessellations of triangle meshes.\n"
      "Try: geolloyd generate creature -o creature.ply\n"
      "     geolloyd remesh creature.ply --vertices 2048 -o remesh.ply\n"
      "     geolloyd relax creature.ply --seeds 2048 -o result");
  program.name("geolloyd");
  program.set_version_flag("--version", geolloyd::build_facts_text,
                           "Version, and what this program was built with");
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  geolloyd::add_remesh_command(program, console);
  geolloyd::add_remesh_all_command(program, console);
  geolloyd::add_relax_command(program, console);
  geolloyd::add_render_command(program, console);
  geolloyd::add_view_command(program, console);
  geolloyd::add_verify_command(program, console);
  geolloyd::add_compare_command(program, console);
  geolloyd::add_profile_command(program, console);
  geolloyd::add_batch_command(program, console);
  geolloyd::add_ground_truth_command(program, console);
  geolloyd::add_generate_command(program, console);
  geolloyd::add_subdivide_command(program, console);
  geolloyd::add_convert_command(program, console);
  geolloyd::add_info_command(program, console);
  geolloyd::add_repair_command(program, console);
  geolloyd::add_quality_command(program, console);
  for (CLI::App* command : program.get_subcommands({})) {
    geolloyd::add_memory_option(*command);
    geolloyd::add_quiet_option(*command, console);
  }
  geolloyd::add_completion_command(program);
  geolloyd::add_man_command(program);
  refuse_empty_values(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (!asked_for) throw geolloyd::InvalidInput(explain(program, error) + ": see geolloyd --help");
    program.exit(error);
  }
  geolloyd::check_printed();
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_by_exception);
  geolloyd::hold_standard_streams();
  geolloyd::end_on_interrupts();
  geolloyd::return_freed_memory();
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is one more thing that cannot be written
  try {
    geolloyd::limit_memory(geolloyd::available_memory());
    run(argc, argv);
    return 0;
  } catch (const geolloyd::Error& error) {
    return complain(status_bad_input, error.what());
  } catch (const geolloyd::InterruptedExit&) {
    return status_interrupted;
  } catch (const geolloyd::WarnedExit&) {
    return status_warned;
  } catch (const std::bad_alloc&) {
    return complain(status_bad_input, geolloyd::out_of_memory_message());
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(status_bad_input, error.what());
  } catch (const std::system_error& error) {
    const bool lost = std::ferror(stdout) != 0;  // {fmt} says so with an error of its own
    return lost ? complain(status_bad_input, "standard output: " + std::string(error.what()))
                : complain(status_error, error.what());
  } catch (const std::exception& error) {
    return complain(status_error, error.what());
  }
}

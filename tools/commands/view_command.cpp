#include <fmt/format.h>
#include <CLI/App.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "tools/cli/choice_option.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/relax_arguments.h"
#include "tools/commands/commands.h"
#include "tools/run/stages.h"
#include "tools/system/browser.h"
#include "tools/system/interrupt.h"
#include "tools/system/progress.h"
#include "tools/view/assets.h"
#include "tools/view/http/http_server.h"
#include "tools/view/session/saving.h"
#include "tools/view/session/session.h"

namespace geolloyd {
namespace {

struct ViewArguments {
  RunRequest start;
  std::optional<GreedyMode> greedy;
  ThreadArguments threads;
  std::filesystem::path output;
  bool opens = true;
};

void check(const ViewArguments& arguments) {
  const RunRequest& start = arguments.start;
  if (start.seeds.count != 0 || !start.seed_file.path.empty()) {
    check_seeds(start.seeds, start.seed_file);
  }
}

// Flushed: others read it through a pipe while the command goes on.
void print_address(const std::string& mesh, const std::string& address) {
  fmt::print("{}\n  open        {}\n  end         Ctrl-C\n", mesh, address);
  std::fflush(stdout);
}

void run_view(const ViewArguments& arguments, const Console& console) {
  const ViewerAssets assets = viewer_assets();
  check(arguments);
  const RunRequest& start = arguments.start;
  const MadeFolders folders = prepare_saving(arguments.output, start.files());
  Scheduler scheduler = make_scheduler(arguments.threads);
  Threads threads(scheduler);
  ProgressLine progress(console);
  progress.stage("reading " + start.mesh.string());
  LoadedInput loaded = load_input(start.mesh, scheduler, {start.has_properties, start.reading});
  progress.stage("building the graph and choosing seeds");
  SessionModel model(std::move(loaded),
                     {start.graph, start.seeds, start.seed_file, arguments.greedy},
                     arguments.output, threads);
  progress.clear();
  catch_interrupts();
  HttpServerOptions options;
  options.should_end = interrupted;
  HttpServer server(options);
  Session session(model, [&server] { server.notify(); });
  const HttpGuard guard{server.port(), random_token()};
  HttpSite site(guard, {assets.index, assets.script, assets.style}, session);
  const std::string address = fmt::format("http://127.0.0.1:{}/#{}", guard.port, guard.token);
  print_address(start.mesh.string(), address);
  if (arguments.opens) open_in_browser(address);
  server.serve(site);
  if (interrupted()) throw InterruptedExit{};
}

}  // namespace

void add_view_command(CLI::App& program, Console& console) {
  CLI::App* command =
      program.add_subcommand("view", "Show a mesh in a browser: see its seeds move, and move them");
  const auto a = std::make_shared<ViewArguments>();
  a->start.has_properties = true;
  add_mesh_argument(*command, a->start.mesh);
  folder_name(command->add_option("-o,--output", a->output,
                                  "Folder that results, pictures and pages are saved into"));
  command->add_flag("!--no-open", a->opens, "Print the address, and do not open a browser");
  add_seed_options(*command, a->start.seeds, a->start.seed_file);
  add_graph_options(*command, a->start.graph);
  add_choice(*command, "--greedy", a->greedy, greedy_choice_names,
             "Greedy phase before the precise phase; auto goes by --init");
  add_drop_option(*command, a->start.has_properties);
  add_thread_options(*command, a->threads);
  add_reading_options(*command, a->start.reading);
  command->footer(
      "The server answers on this machine only, and only to the address that it prints. It ends\n"
      "with Ctrl-C, or when the page has been closed for ten minutes. From another machine:\n"
      "ssh -L PORT:127.0.0.1:PORT, with the port of the address.");
  command->callback([a, &console] { run_view(*a, console); });
}

}  // namespace geolloyd

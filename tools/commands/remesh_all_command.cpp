#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/formats/mesh_formats.h"
#include "core/text/compression.h"
#include "geolloyd/errors.h"
#include "tools/cli/choice_option.h"
#include "tools/cli/folder_option.h"
#include "tools/cli/reading_options.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/cli/summary_options.h"
#include "tools/commands/commands.h"
#include "tools/files/output_folder.h"
#include "tools/report/remesh_all_output.h"
#include "tools/report/remesh_output.h"
#include "tools/run/remesh_run.h"
#include "tools/run/stages.h"
#include "tools/run/work_queue.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"
#include "tools/system/progress.h"
#include "tools/words/facts_text.h"
#include "tools/words/mesh_files.h"

namespace geolloyd {
namespace {

namespace fs = std::filesystem;

struct RemeshAllArguments {
  std::vector<fs::path> inputs;      ///< folders and meshes
  RemeshArguments each;              ///< but for the files
  std::optional<MeshFormat> format;  ///< nothing: as the input's
  fs::path folder;
  bool has_reports = false;
};

// The meshes of a folder, by name, but for hidden ones.
std::vector<fs::path> meshes_in(const fs::path& folder) {
  std::vector<fs::path> meshes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& file = entry.path();
    if (has_mesh_name(file) && file.filename().string().front() != '.' && !entry.is_directory()) {
      meshes.push_back(file);
    }
  }
  if (meshes.empty()) {
    throw InvalidInput(folder.string() + ": no mesh in this folder");
  }
  std::sort(meshes.begin(), meshes.end());
  return meshes;
}

std::vector<fs::path> find_meshes(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> meshes;
  std::set<fs::path> known;
  const auto add = [&](const fs::path& mesh) {
    if (known.insert(fs::weakly_canonical(mesh)).second) meshes.push_back(mesh);
  };
  for (const fs::path& input : inputs) {
    if (fs::is_directory(input)) {
      for (const fs::path& mesh : meshes_in(input)) add(mesh);
    } else {
      if (!has_mesh_name(input) && !fs::exists(input)) {
        throw InvalidInput(input.string() + ": no such folder");
      }
      (void)format_to_read(input);
      add(input);
    }
  }
  return meshes;
}

// Throws InvalidInput where a remesh would replace another, or an input.
std::vector<RemeshTask> make_tasks(const RemeshAllArguments& arguments) {
  const std::vector<fs::path> meshes = find_meshes(arguments.inputs);
  std::set<fs::path> inputs;
  for (const fs::path& mesh : meshes) inputs.insert(fs::weakly_canonical(mesh));
  std::vector<RemeshTask> tasks;
  std::map<fs::path, fs::path> input_of;
  for (const fs::path& mesh : meshes) {
    fs::path name = mesh.filename();
    if (arguments.format) {
      name =
          name_without_compression(name).replace_extension(facts_of(*arguments.format).extension);
    }
    const fs::path output = arguments.folder / name;
    const auto [other, is_new] = input_of.emplace(output, mesh);
    if (!is_new) {
      throw InvalidInput(fmt::format("{} and {} would both become {}: rename one{}",
                                     other->second.string(), mesh.string(), output.string(),
                                     !arguments.format ? "" : ", or leave out --format"));
    }
    if (inputs.contains(fs::weakly_canonical(output))) {
      throw InvalidInput(output.string() + ": would be overwritten: write somewhere else");
    }
    tasks.push_back({mesh, output});
  }
  return tasks;
}

std::uint64_t size_of(const fs::path& file) {
  std::error_code unknown;  // is for the reader to tell
  const auto bytes = fs::file_size(file, unknown);
  return unknown ? 0 : bytes;
}

// What is known before the mesh is read. Measured: a vertex of the remesh takes about as long as
// 3000 bytes of the input, binary PLY, and the least that a triangle has are 18 of them.
QueuedWork to_be_queued(const RemeshTask& task, std::size_t vertices) {
  constexpr std::uint64_t bytes_per_vertex = 3000;
  constexpr std::uint64_t bytes_per_triangle = 18;
  const std::uint64_t bytes = size_of(task.input);
  WorkSize size;
  size.triangles = bytes / bytes_per_triangle;
  size.vertices = size.triangles / 2;
  size.fine_vertices = size.vertices + 8 * vertices;
  size.sites = vertices;
  return {bytes + bytes_per_vertex * vertices, bytes_to_remesh(size)};
}

class RemeshingAll {
 public:
  /// Both must live on.
  RemeshingAll(const RemeshAllArguments& arguments, const std::vector<RemeshTask>& tasks,
               const Console& console)
      : arguments_(arguments),
        tasks_(tasks),
        scheduler_(make_scheduler(arguments.each.threads)),
        record_(tasks, arguments.folder,
                remesh_options_part(
                    arguments.each.request,
                    {arguments.each.engine, scheduler_.backend(), scheduler_.threads()})),
        progress_(console) {
    for (const RemeshTask& task : tasks) {
      queued_.push_back(to_be_queued(task, arguments.each.request.options.vertex_count));
    }
  }

  const RemeshRecord& run() {
    record_.save(true);
    WorkQueue queue(queued_, allowed_memory(), scheduler_);
    queue.run([&](std::size_t task, MemoryShare& share) {
      begin(task);
      remesh(task, share);
      end(task);
    });
    record_.save(true);
    return record_;
  }

 private:
  // A small mesh does not pay for many threads.
  [[nodiscard]] std::size_t threads_for(std::size_t task) const {
    constexpr std::uint64_t share = 512 << 10;
    return std::clamp<std::size_t>(queued_[task].work / share, 1, scheduler_.threads());
  }

  void remesh(std::size_t task, MemoryShare& share) {
    const Stopwatch watch;
    std::string error;
    try {
      remesh(task, share, watch);
      return;
    } catch (const InterruptedExit&) {
      return;
    } catch (const std::bad_alloc&) {
      // Others may hold what is missing.
      if (!share.is_everything()) throw TooLittleMemory{allowed_memory()};
      error = tasks_[task].input.string() + ": " + out_of_memory_message();
    } catch (const std::exception& exception) {
      error = exception.what();
    }
    std::replace_if(
        error.begin(), error.end(), [](unsigned char c) { return c < ' '; }, '?');
    record_.add_failure(task, std::move(error), watch.seconds());
  }

  // An interrupted remesh is another one, so it is not written.
  void remesh(std::size_t task, MemoryShare& share, const Stopwatch& watch) {
    RemeshRequest request = arguments_.each.request;
    request.mesh = tasks_[task].input;
    RemeshFiles names;
    names.remesh.file = tasks_[task].output;
    if (arguments_.has_reports) names.report = names.remesh.file.string() + ".json";
    Scheduler scheduler(threads_for(task), arguments_.each.threads.backend);
    scheduler.set_watch(give_up_if_interrupted);
    ProgressLine silent = ProgressLine::silent();
    const auto check_memory = [&](std::uint64_t bytes) {
      require_memory(request.mesh.string(), bytes);
      share.become(bytes);
    };
    RemeshedInput done = remesh_input(request, std::nullopt, arguments_.each.engine, check_memory,
                                      scheduler, silent);
    if (done.result.made.remesh.interrupted) return;
    keep_writable(names.remesh.file, done.result.properties);
    const Stopwatch writing;
    FileGroup files = open_remesh_files(names);
    write_remesh(names, done.result, files);
    done.result.write_seconds = writing.seconds();
    done.result.total_seconds = watch.seconds();
    write_remesh_report(names, request, done, files);
    record_.add(task, done);
  }

  void begin(std::size_t task) {
    const std::lock_guard lock(mutex_);
    at_work_.insert(task);
    show();
  }

  void end(std::size_t task) {
    record_.save(false);
    const std::lock_guard lock(mutex_);
    at_work_.erase(task);
    show();
  }

  void show() {
    std::string names;
    for (const std::size_t task : at_work_) {
      names += (names.empty() ? "" : ", ") + tasks_[task].input.filename().string();
    }
    progress_.stage(fmt::format("{} of {}: {}", record_.done(),
                                counted(tasks_.size(), "mesh", "meshes"), names));
  }

  const RemeshAllArguments& arguments_;
  const std::vector<RemeshTask>& tasks_;
  Scheduler scheduler_;
  RemeshRecord record_;
  std::vector<QueuedWork> queued_;
  std::mutex mutex_;  // of both that follow
  std::set<std::size_t> at_work_;
  ProgressLine progress_;
};

void run_remesh_all(RemeshAllArguments& arguments, const Console& console) {
  check_remesh(arguments.each);
  if (!arguments.each.request.field.field_file().empty()) {
    throw InvalidInput("--vfield: a file belongs to one mesh: give curvature");
  }
  const std::vector<RemeshTask> tasks = make_tasks(arguments);
  catch_interrupts();  // before the folder appears, which tells others that it is done
  std::vector<fs::path> inputs;
  inputs.reserve(tasks.size());
  for (const RemeshTask& task : tasks) inputs.push_back(task.input);
  const MadeFolders folders = prepare_folder(
      arguments.folder, std::array{RemeshRecord::csv_name, RemeshRecord::json_name}, inputs);
  std::size_t failed = 0;
  bool has_warnings = false;
  {
    RemeshingAll all(arguments, tasks, console);
    const RemeshRecord& record = all.run();
    failed = record.failed();
    if (console.wants_json()) console.print_json(json_text(record.result()));
    fmt::print("{}", record.summary());
    has_warnings = !record.warnings().empty();
    tell_warnings(record.warnings(), arguments.each.is_strict, console);
  }
  if (interrupted()) throw InterruptedExit{};
  if (failed > 0) {
    throw InvalidInput(fmt::format("{} of {} have no remesh: see {}", grouped(failed),
                                   counted(tasks.size(), "mesh", "meshes"),
                                   (arguments.folder / RemeshRecord::csv_name).string()));
  }
  if (arguments.each.is_strict && has_warnings) throw WarnedExit{};
}

}  // namespace

void add_remesh_all_command(CLI::App& program, Console& console) {
  CLI::App* command =
      program.add_subcommand("remesh-all", "Remesh many meshes at once, each as remesh does");
  const auto a = std::make_shared<RemeshAllArguments>();
  command->add_option("INPUT", a->inputs, "Folders of meshes, or meshes")
      ->type_name("")
      ->required();
  add_fineness_options(*command, a->each.request);
  folder_name(command->add_option("-o,--output", a->folder,
                                  "Folder for the remeshes, each named as its input, and for\n"
                                  "remesh-all.csv and remesh-all.json"))
      ->required();
  const auto set_format = [a](const std::string& name) {
    a->format = value_of(written_format_names, name);
  };
  one_of(command->add_option_function<std::string>(
             "--format", set_format, "Format of the remeshes (default: that of each input)"),
         written_format_names);
  add_json_option(*command, console);
  add_strict_option(*command, a->each.is_strict);
  command->add_flag("--reports", a->has_reports,
                    "For each remesh a report, NAME.json, like that of remesh --report");
  add_adapt_options(*command, a->each.request);
  add_field_option(*command, a->each.request,
                   "Triangles regular in the metric of the surface's own curvatures.\n"
                   "Without other sizes, all edges have one length in it");
  add_repair_options(*command, a->each.repair);
  add_feature_options(*command, a->each.request);
  add_no_fit_option(*command, a->each.request);
  add_drop_option(*command, a->each.request.carries_properties);
  add_weld_option(*command, a->each.request.reading);
  add_engine_option(*command, a->each.engine);
  add_thread_options(*command, a->each.threads);
  command->footer(
      "A mesh that cannot be remeshed stops none of the others: its error is in the summary, and "
      "the\n"
      "exit status is 2. Ctrl-C ends the work; the remeshes written until then are whole.");
  command->callback([a, &console] { run_remesh_all(*a, console); });
}

}  // namespace geolloyd

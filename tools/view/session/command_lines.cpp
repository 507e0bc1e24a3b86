#include "tools/view/session/command_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "tools/words/names.h"

namespace geolloyd {
namespace {

class CommandLine {
 public:
  CommandLine(const char* command, const Input& input)
      : text_(fmt::format("geolloyd {} {}{}", command, quoted(input.file.string()),
                          input.reading.weld ? "" : " --no-weld")) {}

  template <class Value>
  CommandLine& add(const char* option, const Value& value) {
    text_ += fmt::format(" {} {}", option, quoted(fmt::format("{}", value)));
    return *this;
  }

  /// Unless it is the default.
  template <class Choice>
  CommandLine& add(const char* option, Choice value, Choice usual,
                   const std::vector<Named<Choice>>& names) {
    return value == usual ? *this : add(option, name_of(names, value));
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_graph(CommandLine& line, const GraphPlan& graph) {
  line.add("--graph", graph.kind, GraphKind::vertex, graph_kind_names);
  line.add("--norm", graph.norm, Norm::geodesic, norm_names);
  if (!graph.vfield.empty()) line.add("--vfield", graph.vfield.string());
  line.add("--averaging", graph.averaging, {}, averaging_choice_names);
}

// Of seeds from a file nobody knows how they were chosen, so the mode is said.
void add_seeds(CommandLine& line, const SteppedTessellation& t,
               const std::filesystem::path& output) {
  const SeedPlan& seeds = t.options().seeds;
  const SeedFile& given = t.options().seed_file;
  const std::filesystem::path file = t.has_edited_seeds() ? output / first_seeds_name : given.path;
  if (!file.empty()) {
    line.add("--seeds-file", file.string());
    if (!t.has_edited_seeds()) line.add("--by", given.by, SeedsBy::id, seeds_by_names);
    line.add("--greedy", name_of(greedy_mode_names, t.limits().greedy));
    return;
  }
  line.add("--seeds", seeds.count);
  line.add("--init", seeds.init, SeedInit::automatic, seed_init_names);
  if (seeds.random_seed != 1) line.add("--random-seed", seeds.random_seed);
  line.add("--greedy", t.options().greedy, {}, greedy_choice_names);
}

void add_limit(CommandLine& line, const char* option, std::uint32_t most) {
  if (most != RelaxationOptions::no_limit) line.add(option, most);
}

}  // namespace

std::string quoted(const std::string& word) {
  const bool is_plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string("_-+./:,=@%").find(static_cast<char>(c)) != std::string::npos;
  });
  if (is_plain) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string relax_command_line(const SteppedTessellation& tessellation,
                               const std::filesystem::path& output) {
  CommandLine line("relax", tessellation.start().input);
  add_seeds(line, tessellation, output);
  add_graph(line, tessellation.options().graph);
  const RelaxationOptions limits = tessellation.limits();
  add_limit(line, "--max-greedy-steps", limits.max_greedy_steps);
  add_limit(line, "--max-macrosteps", limits.max_macrosteps);
  if (!output.empty()) line.add("--output", output.string());
  return line.text();
}

std::string remesh_command_line(const Input& input, std::size_t vertices,
                                const std::filesystem::path& field,
                                const std::filesystem::path& output) {
  CommandLine line("remesh", input);
  line.add("--vertices", vertices);
  if (!field.empty()) line.add("--vfield", field.string());
  line.add("--output", (output / remesh_name).string());
  return line.text();
}

}  // namespace geolloyd

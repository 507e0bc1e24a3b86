#include "tools/run/checkpoint.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/graph/components.h"
#include "core/text/file_io.h"
#include "core/voronoi/energy.h"
#include "core/voronoi/fingerprint.h"
#include "geolloyd/errors.h"
#include "tools/files/flat_map.h"
#include "tools/system/build_facts.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

constexpr const char* format_name = "geolloyd checkpoint";
constexpr std::uint64_t format_version = 1;

using Bytes = std::vector<std::uint8_t>;

// Thrown where a checkpoint is not what write() makes.
struct Damaged {};

void require(bool condition) {
  if (!condition) throw Damaged{};
}

std::uint64_t checksum(const Bytes& bytes) {
  std::uint64_t sum = bytes.size();
  for (const std::uint8_t byte : bytes) sum = chain(sum, byte);
  return sum;
}

// Columns of numbers, little endian.
template <class Number>
void append(Bytes& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
  }
}

template <class Number>
Bytes column(const std::vector<Number>& numbers) {
  Bytes bytes;
  bytes.reserve(sizeof(Number) * numbers.size());
  for (const Number number : numbers) append(bytes, number);
  return bytes;
}

template <class Number, class Rows, class Value>
Bytes column(const Rows& rows, Value&& value_of_row) {
  Bytes bytes;
  for (const auto& row : rows) append<Number>(bytes, value_of_row(row));
  return bytes;
}

Bytes column(const std::vector<bool>& bits) {
  Bytes bytes((bits.size() + 7) / 8, 0);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i]) bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | 1U << i % 8);
  }
  return bytes;
}

template <class Value>
const Value& field(const FlatMap& map, const char* name) {
  const auto found = map.find(name);
  require(found != map.end() && std::holds_alternative<Value>(found->second));
  return std::get<Value>(found->second);
}

template <class Number>
std::vector<Number> numbers_in(const FlatMap& map, const char* name) {
  const auto& bytes = field<Bytes>(map, name);
  require(bytes.size() % sizeof(Number) == 0);
  std::vector<Number> numbers(bytes.size() / sizeof(Number), 0);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    Number& number = numbers[i / sizeof(Number)];
    number = static_cast<Number>(number | Number{bytes[i]} << (8 * (i % sizeof(Number))));
  }
  return numbers;
}

std::vector<bool> bits_in(const FlatMap& map, const char* name, std::size_t count) {
  const auto& bytes = field<Bytes>(map, name);
  if (bytes.empty()) return {};
  require(bytes.size() == (count + 7) / 8);
  std::vector<bool> bits(count);
  for (std::size_t i = 0; i < count; ++i) bits[i] = (bytes[i / 8] >> i % 8 & 1) != 0;
  return bits;
}

// Of all steps, one after the other.
std::vector<Microstep> microsteps_of(const std::vector<Step>& steps) {
  std::vector<Microstep> all;
  for (const Step& step : steps) {
    all.insert(all.end(), step.microsteps.begin(), step.microsteps.end());
  }
  return all;
}

std::vector<std::uint64_t> seconds_of(const std::vector<Step>& steps) {
  std::vector<std::uint64_t> all;
  for (const Step& step : steps) {
    for (const auto kernel : kernels) {
      all.push_back(std::bit_cast<std::uint64_t>(step.seconds.*kernel));
    }
  }
  return all;
}

void put_steps(FlatMap& map, const std::vector<Step>& steps) {
  const std::vector<Microstep> microsteps = microsteps_of(steps);
  using Row = const Step&;
  using MicroRow = const Microstep&;
  map["step.phase"] = column<std::uint8_t>(steps, [](Row s) { return std::uint8_t(s.phase); });
  map["step.seeds_moved"] = column<std::uint32_t>(steps, [](Row s) { return s.seeds_moved; });
  map["step.node_visits"] = column<std::uint64_t>(steps, [](Row s) { return s.node_visits; });
  map["step.score"] = column<Score>(steps, [](Row s) { return s.score; });
  map["step.state"] = column<std::uint64_t>(steps, [](Row s) { return s.state; });
  map["step.microsteps"] = column<std::uint64_t>(steps, [](Row s) { return s.microsteps.size(); });
  map["step.seconds"] = column(seconds_of(steps));
  map["microstep.seeds_moved"] =
      column<std::uint32_t>(microsteps, [](MicroRow m) { return m.seeds_moved; });
  map["microstep.node_visits"] =
      column<std::uint64_t>(microsteps, [](MicroRow m) { return m.node_visits; });
}

std::vector<Microstep> microsteps_in(const FlatMap& map) {
  const auto seeds_moved = numbers_in<std::uint32_t>(map, "microstep.seeds_moved");
  const auto node_visits = numbers_in<std::uint64_t>(map, "microstep.node_visits");
  require(seeds_moved.size() == node_visits.size());
  std::vector<Microstep> microsteps;
  for (std::size_t i = 0; i < seeds_moved.size(); ++i) {
    microsteps.push_back({seeds_moved[i], node_visits[i]});
  }
  return microsteps;
}

// Greedy ones first, and rounds of improvement after the others.
std::vector<Step> steps_in(const FlatMap& map, const Graph& graph) {
  const auto phase = numbers_in<std::uint8_t>(map, "step.phase");
  const auto seeds_moved = numbers_in<std::uint32_t>(map, "step.seeds_moved");
  const auto node_visits = numbers_in<std::uint64_t>(map, "step.node_visits");
  const auto score = numbers_in<Score>(map, "step.score");
  const auto state = numbers_in<std::uint64_t>(map, "step.state");
  const auto count = numbers_in<std::uint64_t>(map, "step.microsteps");
  const auto seconds = numbers_in<std::uint64_t>(map, "step.seconds");
  const std::vector<Microstep> microsteps = microsteps_in(map);
  const std::size_t size = phase.size();
  require(seeds_moved.size() == size && node_visits.size() == size && score.size() == size &&
          state.size() == size && count.size() == size && seconds.size() == kernels.size() * size);
  require(std::is_sorted(phase.begin(), phase.end()) &&
          (phase.empty() || (phase.front() < static_cast<std::uint8_t>(Phase::improvement) &&
                             phase.back() <= static_cast<std::uint8_t>(Phase::improvement))));
  std::vector<Step> steps(size);
  auto next = microsteps.begin();
  for (std::size_t i = 0; i < size; ++i) {
    require(count[i] <= static_cast<std::size_t>(microsteps.end() - next));
    const auto end = next + static_cast<std::ptrdiff_t>(count[i]);
    steps[i] = {static_cast<Phase>(phase[i]), seeds_moved[i], node_visits[i], score[i],
                to_energy(graph, score[i]),   state[i],       {next, end},    {}};
    next = end;
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      steps[i].seconds.*kernels[k] = std::bit_cast<double>(seconds[kernels.size() * i + k]);
    }
  }
  require(next == microsteps.end());
  return steps;
}

bool are_different(std::vector<NodeId> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end();
}

// What seeds can become of the first ones: different nodes, each in the component it began in, or,
// if rounds of improvement may have moved them, some in each component.
void check_seeds(const Graph& graph, const Components& components, const std::vector<NodeId>& first,
                 const std::vector<NodeId>& seeds, bool may_leave) {
  require(seeds.size() == first.size());
  std::vector<bool> has_seed(components.size(), false);
  for (std::size_t r = 0; r < seeds.size(); ++r) {
    require(seeds[r] < graph.node_count());
    const std::uint32_t component = components.component_of[seeds[r]];
    require(may_leave || component == components.component_of[first[r]]);
    has_seed[component] = true;
  }
  require(std::find(has_seed.begin(), has_seed.end(), false) == has_seed.end());
  require(are_different(seeds));
}

void check_state(const Graph& graph, const std::vector<NodeId>& first,
                 const RelaxationState& state) {
  const Components components = connected_components(graph);
  const bool may_leave = !state.steps.empty() && state.steps.back().phase == Phase::improvement;
  check_seeds(graph, components, first, state.seeds, may_leave);
  if (!state.best_seeds.empty()) {
    check_seeds(graph, components, first, state.best_seeds, may_leave);
  }
  require(state.steps.empty() || !state.best_seeds.empty());
  const bool is_precise = !state.steps.empty() && state.steps.back().phase != Phase::greedy;
  require(state.last_scores.size() == (is_precise ? first.size() : 0));
}

FlatMap read_content(const std::filesystem::path& path) {
  const std::optional<FlatMap> file = decode(read_file(path));
  require(file.has_value() && field<std::string>(*file, "format") == format_name);
  const auto& program = field<std::string>(*file, "program");
  if (field<std::uint64_t>(*file, "version") != format_version) {
    throw InvalidInput(path.string() + ": was written by " + program +
                       " in a form this program cannot read: go on with that one");
  }
  const auto& content = field<Bytes>(*file, "content");
  require(checksum(content) == field<std::uint64_t>(*file, "checksum"));
  std::optional<FlatMap> map = decode(
      {reinterpret_cast<const char*>(content.data()), content.size()});  // NOLINT: chars are bytes
  require(map.has_value());
  return *std::move(map);
}

}  // namespace

std::filesystem::path checkpoint_path(const std::filesystem::path& folder) {
  return folder / "checkpoint.msgpack";
}

CheckpointFile::CheckpointFile(std::filesystem::path path, const Graph& graph,
                               std::vector<NodeId> first_seeds, const RelaxationOptions& options)
    : path_(std::move(path)),
      graph_(graph),
      first_seeds_(std::move(first_seeds)),
      options_(options) {}

std::uint64_t CheckpointFile::graph_digest() {
  if (!graph_digest_) graph_digest_ = digest(graph_);
  return *graph_digest_;
}

// What the course of a relaxation depends on.
FlatMap CheckpointFile::describe_course() {
  return {{"graph", graph_digest()},
          {"first_seeds", digest(first_seeds_)},
          {"greedy", name_of(greedy_mode_names, options_.greedy)},
          {"microstep_skip", std::uint64_t{options_.microstep_skip}},
          {"macrostep_skip", std::uint64_t{options_.macrostep_skip}}};
}

void CheckpointFile::check_course(const FlatMap& content) {
  const std::pair<const char*, const char*> differences[] = {
      {"graph", "another mesh, or of another --graph, --norm, --vfield or --averaging"},
      {"first_seeds", "other first seeds: other --seeds, --init, --random-seed or --seeds-file"},
      {"greedy", "another --greedy"},
      {"microstep_skip", "another --no-microstep-skip"},
      {"macrostep_skip", "another --no-macrostep-skip"}};
  const FlatMap expected = describe_course();
  for (const auto& [name, difference] : differences) {
    const auto found = content.find(name);
    require(found != content.end());
    if (found->second == expected.at(name)) continue;
    throw InvalidInput(path_.string() + ": is the checkpoint of " + difference +
                       ": give the same, or remove it to begin anew");
  }
}

Checkpoint CheckpointFile::read() try {
  const FlatMap content = read_content(path_);
  check_course(content);
  Checkpoint checkpoint;
  checkpoint.seconds = field<double>(content, "seconds");
  require(std::isfinite(checkpoint.seconds) && checkpoint.seconds >= 0);
  checkpoint.state = {numbers_in<NodeId>(content, "seeds"),
                      numbers_in<NodeId>(content, "best_seeds"),
                      bits_in(content, "has_been_seed", graph_.node_count()),
                      numbers_in<Score>(content, "last_scores"), steps_in(content, graph_)};
  check_state(graph_, first_seeds_, checkpoint.state);
  return checkpoint;
} catch (const Damaged&) {
  throw InvalidInput(path_.string() +
                     ": is no checkpoint, or a damaged one: remove it to begin anew");
}

void CheckpointFile::write(const Checkpoint& checkpoint) {
  const RelaxationState& state = checkpoint.state;
  FlatMap content = describe_course();
  content["seconds"] = checkpoint.seconds;
  content["seeds"] = column(state.seeds);
  content["best_seeds"] = column(state.best_seeds);
  content["has_been_seed"] = column(state.has_been_seed);
  content["last_scores"] = column(state.last_scores);
  put_steps(content, state.steps);
  const std::string text = encode(content);
  const Bytes bytes(text.begin(), text.end());
  OutputFile file(path_);
  file.write(encode({{"format", format_name},
                     {"version", format_version},
                     {"program", program_name()},
                     {"checksum", checksum(bytes)},
                     {"content", bytes}}));
  file.sync();
  file.commit();
}

}  // namespace geolloyd

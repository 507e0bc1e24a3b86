#include "tools/run/checkpoint.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/lloyd/reference_engine.h"
#include "core/text/file_io.h"
#include "core/voronoi/fingerprint.h"
#include "geolloyd/errors.h"
#include "geolloyd/threads.h"
#include "tests/support/same_relaxation.h"
#include "tests/support/temporary_folder.h"
#include "tools/files/flat_map.h"
#include "tools/files/output_folder.h"
#include "tools/run/resumable.h"
#include "tools/system/build_facts.h"

namespace geolloyd {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Two grids side by side, and seeds in both.
Graph two_grids() {
  std::vector<UndirectedArc> links;
  for (const NodeId first : {0U, 200U}) {
    for (NodeId i = 0; i < 200; ++i) {
      if (i % 20 != 19) links.push_back({first + i, first + i + 1, 1.0});
      if (i + 20 < 200) links.push_back({first + i, first + i + 20, 1.0});
    }
  }
  return make_graph(links, std::vector<double>(400, 1.0));
}

class CheckpointTest : public testing::Test {
 protected:
  CheckpointTest() {
    const auto engine = make_reference_engine(graph_);
    RelaxationState state;
    state.seeds = first_;
    boundaries_ = {state};
    whole_ = relax(graph_, *engine, state, {}, {},
                   [&](const RelaxationState& s) { boundaries_.push_back(s); });
  }

  [[nodiscard]] CheckpointFile file() const { return {path_, graph_, first_, {}}; }

  // In the middle of one phase or the other.
  [[nodiscard]] const RelaxationState& state(Phase phase) const {
    std::size_t i = boundaries_.size() - 2;
    while (boundaries_[i].steps.back().phase != phase) --i;
    return boundaries_[i];
  }

  static std::string message(const std::function<void()>& action) {
    try {
      action();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "nothing thrown";
  }

  [[nodiscard]] std::string refusal() const {
    return message([&] { file().read(); });
  }

  // Changes a field, and what tells of damage.
  void forge(const char* name, FlatMap::mapped_type value) const {
    FlatMap outer = *decode(read_file(path_));
    const auto& bytes = std::get<Bytes>(outer["content"]);
    FlatMap content = *decode(std::string(bytes.begin(), bytes.end()));
    ASSERT_TRUE(content.contains(name)) << name;
    content[name] = std::move(value);
    const std::string text = encode(content);
    std::uint64_t sum = text.size();
    for (const char c : text) sum = chain(sum, static_cast<std::uint8_t>(c));
    outer["content"] = Bytes(text.begin(), text.end());
    outer["checksum"] = sum;
    write(encode(outer));
  }

  void write(const std::string& bytes) const { write_text_file(path_, bytes); }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "c";
  const Graph graph_ = two_grids();
  const std::vector<NodeId> first_ = {0, 1, 210, 2, 215};
  std::vector<RelaxationState> boundaries_;
  Relaxation whole_;
};

TEST_F(CheckpointTest, HoldsAllThatTheRestDependsOn) {
  ASSERT_GT(boundaries_.size(), 5U);
  double seconds = 0;
  for (const RelaxationState& state : boundaries_) {
    file().write({state, seconds});
    Checkpoint read = file().read();
    EXPECT_EQ(read.seconds, seconds);
    EXPECT_EQ(read.state.seeds, state.seeds);
    EXPECT_EQ(read.state.best_seeds, state.best_seeds);
    EXPECT_EQ(read.state.has_been_seed, state.has_been_seed);
    EXPECT_EQ(read.state.last_scores, state.last_scores);
    const auto engine = make_reference_engine(graph_);
    const Relaxation rest = relax(graph_, *engine, read.state, {});
    expect_same(whole_, rest);
    for (std::size_t i = 0; i < state.steps.size(); ++i) {
      EXPECT_EQ(rest.steps[i].seconds.free_search, state.steps[i].seconds.free_search);
    }
    seconds += 0.75;
  }
}

// Rounds of improvement may have moved seeds from one grid to the other.
TEST_F(CheckpointTest, HoldsRoundsOfImprovement) {
  RelaxationOptions options;
  options.improvement_rounds = 4;
  const auto engine = make_reference_engine(graph_);
  RelaxationState state;
  state.seeds = first_;
  std::vector<RelaxationState> states;
  const Relaxation whole = relax(graph_, *engine, state, options, {},
                                 [&](const RelaxationState& s) { states.push_back(s); });
  ASSERT_EQ(states.back().steps.back().phase, Phase::improvement);
  for (const RelaxationState& boundary : states) {
    file().write({boundary, 1});
    Checkpoint read = file().read();
    expect_same(whole, relax(graph_, *engine, read.state, options));
  }
}

TEST_F(CheckpointTest, IsRefusedWhereverItIsCutOff) {
  file().write({state(Phase::precise), 1});
  const std::string bytes = read_file(path_);
  for (int percent = 0; percent < 100; ++percent) {
    write(bytes.substr(0, bytes.size() * static_cast<std::size_t>(percent) / 100));
    EXPECT_NE(refusal().find("is no checkpoint, or a damaged one"), std::string::npos) << percent;
  }
  write(bytes + "x");
  EXPECT_NE(refusal().find("is no checkpoint, or a damaged one"), std::string::npos);
}

TEST_F(CheckpointTest, IsRefusedWhicheverBitIsWrong) {
  file().write({state(Phase::precise), 1});
  const std::string bytes = read_file(path_);
  // But for those of the program's name, which is for people.
  const std::size_t program = bytes.find(program_name());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 37) {
    if (bit / 8 >= program && bit / 8 < program + program_name().size()) continue;
    std::string wrong = bytes;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ 1 << bit % 8);
    write(wrong);
    ASSERT_NE(refusal(), "nothing thrown") << bit;
  }
}

TEST_F(CheckpointTest, IsRefusedWhereItMakesNoSense) {
  const auto ids = [](const std::vector<std::uint32_t>& nodes) {
    Bytes bytes;
    for (const std::uint32_t node : nodes) {
      for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(node >> 8 * i));
    }
    return bytes;
  };
  const std::vector<std::pair<const char*, FlatMap::mapped_type>> forgeries = {
      {"seeds", ids({0, 1, 210, 2, 400})},  // no such node
      {"seeds", ids({0, 1, 210, 1, 215})},  // twice the same
      {"seeds", ids({0, 1, 10, 2, 215})},   // another component
      {"seeds", ids({0, 1, 210, 2})},       // too few
      {"seeds", Bytes(19, 0)},              // no whole numbers
      {"seeds", std::string("0")},          // no bytes
      {"best_seeds", ids({0, 1, 210, 2, ~0U})},
      {"best_seeds", Bytes{}},
      {"has_been_seed", Bytes(49, 0)},
      {"last_scores", Bytes(64, 0)},
      {"last_scores", Bytes{}},
      {"step.phase", Bytes{}},
      {"step.phase", Bytes(state(Phase::precise).steps.size(), 2)},
      {"step.microsteps", Bytes(8 * state(Phase::precise).steps.size(), 0xff)},
      {"step.microsteps", Bytes(8 * state(Phase::precise).steps.size(), 0)},
      {"microstep.seeds_moved", Bytes{}},
      {"seconds", -1.0},
      {"seconds", std::uint64_t{1}}};
  for (std::size_t i = 0; i < forgeries.size(); ++i) {
    file().write({state(Phase::precise), 1});
    forge(forgeries[i].first, forgeries[i].second);
    EXPECT_NE(refusal().find("is no checkpoint, or a damaged one"), std::string::npos)
        << i << ": " << refusal();
  }
  file().write({state(Phase::greedy), 1});
  EXPECT_EQ(refusal(), "nothing thrown");
  forge("has_been_seed", Bytes(51, 0));
  EXPECT_NE(refusal(), "nothing thrown");
}

TEST_F(CheckpointTest, IsRefusedByAnotherRelaxation) {
  file().write({state(Phase::greedy), 1});
  const auto refusal_by = [&](const Graph& graph, const std::vector<NodeId>& first,
                              const RelaxationOptions& options) {
    return message([&] { CheckpointFile(path_, graph, first, options).read(); });
  };
  Graph other = graph_;
  ++other.length[7];
  EXPECT_NE(refusal_by(other, first_, {}).find("of another mesh"), std::string::npos);
  other = graph_;
  other.tick_length *= 2;
  EXPECT_NE(refusal_by(other, first_, {}).find("of another mesh"), std::string::npos);
  EXPECT_NE(refusal_by(graph_, {0, 1, 210}, {}).find("other --seeds"), std::string::npos);
  EXPECT_NE(refusal_by(graph_, {1, 0, 210, 2, 215}, {}).find("--init"), std::string::npos);
  RelaxationOptions options;
  options.greedy = GreedyMode::standard;
  EXPECT_NE(refusal_by(graph_, first_, options).find("another --greedy"), std::string::npos);
  options = {};
  options.microstep_skip = false;
  EXPECT_NE(refusal_by(graph_, first_, options).find("--no-microstep-skip"), std::string::npos);
  options = {};
  options.macrostep_skip = false;
  EXPECT_NE(refusal_by(graph_, first_, options).find("--no-macrostep-skip"), std::string::npos);
  options = {};
  options.max_macrosteps = 3;
  EXPECT_EQ(refusal_by(graph_, first_, options), "nothing thrown");
}

TEST_F(CheckpointTest, OfALaterProgramSaysWhose) {
  file().write({state(Phase::greedy), 1});
  FlatMap outer = *decode(read_file(path_));
  outer["version"] = std::uint64_t{2};
  outer["program"] = "geolloyd 7.8.9";
  write(encode(outer));
  EXPECT_NE(refusal().find("was written by geolloyd 7.8.9"), std::string::npos) << refusal();
}

// A disk may be full for a while: that is said, and the work goes on.
TEST_F(CheckpointTest, ThatCannotBeWrittenEndsNoRelaxation) {
  PreparedRun run;
  run.mesh_graph.graph = graph_;
  run.seeds = first_;
  ResumableRelaxation relaxation(run, {}, {folder_.path() / "missing", 0, false});
  Threads threads(1);
  ProgressLine progress{Console()};
  testing::internal::CaptureStderr();
  const EndedRelaxation ended = relaxation.relax(threads, progress, {});
  EXPECT_FALSE(relaxation.save(progress));
  EXPECT_NE(testing::internal::GetCapturedStderr().find("missing"), std::string::npos);
  expect_same(whole_, ended.relaxation);
}

TEST(FlatMap, ReadsWhatWasWritten) {
  const FlatMap map = {{"a", std::uint64_t{1} << 63}, {"b", 0.1}, {"c", std::string("text")},
                       {"d", Bytes(70'000, 7)},       {"e", 2.0}, {"f", Bytes{}}};
  EXPECT_EQ(decode(encode(map)), map);
  EXPECT_EQ(decode(encode({})), FlatMap{});
}

// MessagePack that is none of ours: sizes beyond all memory, maps deeper than the stack.
TEST(FlatMap, RefusesWhatIsNone) {
  const std::string key = {'\xa1', 'a'};
  std::string deep;
  for (int i = 0; i < 1'000'000; ++i) deep += "\x81" + key;
  const std::vector<std::string> all = {"",
                                        "\x01",
                                        deep,
                                        std::string(1'000'000, '\x91'),
                                        "\x81" + key + "\x80",
                                        "\x81" + key + "\xc6\xff\xff\xff\xff",
                                        "\x81" + key + "\xdb\xff\xff\xff\xff",
                                        "\x81" + key + "\xdd\xff\xff\xff\xff",
                                        "\x81" + key + "\xc9\xff\xff\xff\xff",
                                        "\xdf\xff\xff\xff\xff" + key + "\x01",
                                        "\x82" + key + "\x01" + key + "\x02",
                                        "\x81" + key + "\xff",
                                        "\x81" + key + "\xc0",
                                        "\x81" + key + "\xc1",
                                        "\x81" + key + "\xc3",
                                        "\x81\x01\x01"};
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(decode(all[i]), std::nullopt) << i;
}

}  // namespace
}  // namespace geolloyd

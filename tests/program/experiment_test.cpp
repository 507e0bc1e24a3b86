// The commands that measure: what they measure can only be judged by people, but what they count,
// and that they count the same for both engines, by tests.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/kernel_seconds.h"
#include "core/base/stopwatch.h"
#include "geolloyd/errors.h"
#include "tests/support/program.h"
#include "tests/support/sanitizers.h"
#include "tools/files/csv.h"
#include "tools/laboratory/batch.h"
#include "tools/laboratory/comparison.h"
#include "tools/system/machine.h"

namespace geolloyd {
namespace {

using nlohmann::json;

class Experiment : public Program {
 protected:
  // Runs a command on the mesh with a folder to write to, without pictures, and reads its JSON.
  json result_of(const std::string& command, const std::string& options) {
    outcome_ = geolloyd_with(command + " " + mesh_.string() + " --no-plot -o " + out().string() +
                             " " + options);
    EXPECT_EQ(outcome_.status, 0) << outcome_.text;
    return json::parse(read_file(out() / (command + ".json")));
  }

  Outcome outcome_;
};

TEST_F(Experiment, CompareTimesEveryCombinationAndFindsThemEqual) {
  const json result = result_of("compare",
                                "-k 20 --threads 1,3 --frontiers regions,delta,heap "
                                "--backends tbb,openmp --turns 2");
  ASSERT_EQ(result["runs"].size(), 1U + 2 * 3 * 2);
  std::set<std::string> ways;
  for (const json& run : result["runs"]) {
    EXPECT_EQ(run["equal"], true);
    EXPECT_EQ(run["fingerprint"], result["runs"][0]["fingerprint"]);
    EXPECT_EQ(run["turns"], run["engine"] == "reference" ? 1 : 2);
    EXPECT_LE(run["seconds"]["min"], run["seconds"]["median"]);
    EXPECT_LE(run["seconds"]["median"], run["seconds"]["max"]);
    EXPECT_GT(run["peak_memory_bytes"], 1'000'000);
    EXPECT_NEAR(run["speedup"].get<double>() * run["seconds"]["median"].get<double>(),
                result["runs"][0]["seconds"]["median"].get<double>(), 1e-9);
    EXPECT_NEAR(
        run["node_visits_per_second"].get<double>() * run["seconds"]["median"].get<double>(),
        result["steps"]["node_visits"].get<double>(), 1e-3);
    ways.insert(run["frontier"].dump() + run["backend"].dump() + run["threads"].dump());
  }
  EXPECT_EQ(ways.size(), result["runs"].size());
  EXPECT_EQ(lines_of(out() / "compare.csv").size(), result["runs"].size() + 1);
  EXPECT_NE(outcome_.text.find("equal"), std::string::npos);
}

TEST_F(Experiment, EfficiencyIsAgainstTheSameWithOneThread) {
  const json without_one = result_of("compare", "-k 20 --threads 2,4 --turns 1");
  for (const json& run : without_one["runs"]) {
    EXPECT_EQ(run["efficiency"].is_null(), run["engine"] == "parallel");
  }
  const json with_one = result_of("compare", "-k 20 --threads 1 --turns 1");
  for (const json& run : with_one["runs"]) {
    EXPECT_EQ(run["efficiency"], 1.0);
  }
}

TEST_F(Experiment, CompareNeedsNoReference) {
  const json result = result_of("compare", "-k 20 --threads 2 --turns 1 --no-reference");
  ASSERT_EQ(result["runs"].size(), 1U);
  EXPECT_EQ(result["runs"][0]["engine"], "parallel");
  EXPECT_TRUE(result["runs"][0]["speedup"].is_null());
}

TEST_F(Experiment, ProfileCountsTheSameForBothEngines) {
  const json result = result_of("profile", "-k 20");
  ASSERT_EQ(result["profiles"].size(), 2U);
  const json& reference = result["profiles"][0];
  const json& parallel = result["profiles"][1];
  EXPECT_EQ(reference["fingerprint"], parallel["fingerprint"]);
  ASSERT_EQ(reference["steps"].size(), parallel["steps"].size());
  for (std::size_t i = 0; i < reference["steps"].size(); ++i) {
    for (const char* key : {"phase", "step", "active_regions", "seeds_moved", "microsteps",
                            "node_visits", "energy"}) {
      EXPECT_EQ(reference["steps"][i][key], parallel["steps"][i][key]) << key << " " << i;
    }
  }
  EXPECT_EQ(lines_of(out() / "profile.csv").size(), 2 * reference["steps"].size() + 1);
}

// Kernels add up to steps, steps to phases, phases to no more than the run.
TEST_F(Experiment, ProfileAddsUp) {
  const json result = result_of("profile", "-k 20");
  for (const json& profile : result["profiles"]) {
    double in_phases = 0;
    std::size_t steps = 0;
    for (const json& phase : profile["phases"]) {
      double in_steps = 0;
      for (const json& step : profile["steps"]) {
        if (step["phase"] != phase["phase"]) continue;
        ++steps;
        double in_kernels = 0;
        for (const auto& [kernel, seconds] : step["kernel_seconds"].items()) {
          EXPECT_GE(seconds.get<double>(), -1e-9) << kernel;
          in_kernels += seconds.get<double>();
        }
        EXPECT_NEAR(in_kernels, step["seconds"], 1e-9);
        in_steps += in_kernels;
      }
      EXPECT_NEAR(in_steps, phase["seconds"], 1e-9);
      const json& kernels = phase["kernel_seconds"];
      EXPECT_NEAR(phase["search_share"].get<double>() * phase["seconds"].get<double>(),
                  kernels["free_search"].get<double>() + kernels["locked_search"].get<double>(),
                  1e-9);
      in_phases += in_steps;
    }
    EXPECT_EQ(steps, profile["steps"].size());
    EXPECT_LE(in_phases, profile["seconds"].get<double>());
    EXPECT_GT(in_phases, 0);
  }
}

// That kernels are timed at all, and as what they are.
TEST_F(Experiment, EveryKernelTakesTimeWhereItWorks) {
  const json result = result_of("profile", "-k 20");
  for (const json& profile : result["profiles"]) {
    const bool parallel = profile["engine"] == "parallel";
    for (const json& phase : profile["phases"]) {
      const json& kernels = phase["kernel_seconds"];
      const bool precise = phase["phase"] == "precise";
      for (const char* kernel : {"free_search", "subtree_sums", "scoring", "movement"}) {
        EXPECT_GT(kernels[kernel], 0) << kernel;
      }
      EXPECT_EQ(kernels["locked_search"] > 0, precise);
      EXPECT_EQ(kernels["gathering"] > 0, parallel);
      EXPECT_LT(kernels["other"], 0.5 * phase["seconds"].get<double>());
    }
  }
}

TEST_F(Experiment, RunsWithoutAnyStepHaveNoProfile) {
  const json result = result_of("profile", "-k 20 --max-greedy-steps 0 --max-macrosteps 0");
  EXPECT_TRUE(result["profiles"][0]["phases"].empty());
  EXPECT_EQ(outcome_.text.find("Dijkstra"), std::string::npos);
  result_of("compare", "-k 20 --turns 1 --max-greedy-steps 0 --max-macrosteps 0");
}

TEST_F(Experiment, ActiveRegionsAreThoseThatMoveAtAll) {
  const json result = result_of("profile", "-k 20 --engines parallel");
  const json& steps = result["profiles"][0]["steps"];
  EXPECT_GT(steps.front()["active_regions"], 0);
  EXPECT_EQ(steps.back()["seeds_moved"], 0);  // converged
  for (const json& step : steps) {
    EXPECT_LE(step["seeds_moved"], step["active_regions"]);
    EXPECT_LE(step["active_regions"], 20);
    if (step["phase"] == "greedy") {
      EXPECT_EQ(step["seeds_moved"], step["active_regions"]);
    }
  }
}

TEST_F(Experiment, ProfileSaysWhatDijkstraTakes) {
  result_of("profile", "-k 20 --greedy off --engines reference");
  EXPECT_NE(
      outcome_.text.find("Dijkstra (free search and locked search) in the reference engine: "),
      std::string::npos);
  EXPECT_NE(outcome_.text.find("% of the precise phase"), std::string::npos);
  EXPECT_EQ(outcome_.text.find("% of the greedy phase"), std::string::npos);
}

TEST_F(Experiment, BatchCountsTheSameInTurnAndTogether) {
  const std::string options = "-k 8,20 --batches 2 --graphs vertex,triangle";
  json in_turn = result_of("batch", options);
  for (const char* threads : {"1", "3"}) {
    json together = result_of("batch", options + " --together --threads " + threads);
    EXPECT_EQ(together["options"]["together"], true);
    ASSERT_EQ(together["rows"].size(), in_turn["rows"].size());
    for (std::size_t i = 0; i < in_turn["rows"].size(); ++i) {
      in_turn["rows"][i].erase("seconds");
      together["rows"][i].erase("seconds");
      EXPECT_EQ(together["rows"][i], in_turn["rows"][i]);
    }
  }
}

TEST_F(Experiment, BatchHasARowForEveryConfiguration) {
  const json result = result_of("batch", "-k 4..8,30 --batches 2 --graphs vertex,triangle,mixed");
  ASSERT_EQ(result["rows"].size(), 3U * 3 * 3 * 2 * 2);
  for (const json& row : result["rows"]) {
    EXPECT_EQ(row["batches"], 2);
    EXPECT_EQ(row["converged"], 2);
    for (const char* key : {"seconds", "greedy_steps", "macrosteps", "microsteps", "partitions",
                            "node_visits", "energy"}) {
      EXPECT_LE(row[key]["min"], row[key]["avg"].get<double>() * (1 + 1e-12)) << key;
      EXPECT_LE(row[key]["avg"], row[key]["max"].get<double>() * (1 + 1e-12)) << key;
    }
    EXPECT_EQ(row["greedy_steps"]["max"] == 0, row["greedy"] == "off");
  }
  EXPECT_EQ(lines_of(out() / "batch.csv").size(), result["rows"].size() + 1);
}

// Every run begins from its own first seeds, not from where the last one ended; the microstep
// switch changes no count of steps, and both engines count alike.
TEST_F(Experiment, BatchRunsDoNotDependOnEachOther) {
  const auto counts = [](json result) {
    for (json& row : result["rows"]) row.erase("seconds");
    return result["rows"];
  };
  const std::string options = "-k 20 --batches 2 --graphs vertex --macrostep-skip on";
  const json rows = counts(result_of("batch", options + " --greedy off,extended"));
  ASSERT_EQ(rows.size(), 4U);
  const json alone = counts(result_of("batch", options + " --greedy extended"));
  EXPECT_EQ(rows[2], alone[0]);
  EXPECT_EQ(rows[3], alone[1]);
  EXPECT_EQ(alone[0]["microsteps"], alone[1]["microsteps"]);
  EXPECT_LT(alone[0]["node_visits"]["max"], alone[1]["node_visits"]["min"]);
  EXPECT_EQ(counts(result_of("batch", options + " --greedy extended --engine reference")), alone);
}

TEST_F(Experiment, BatchesHaveOtherFirstSeeds) {
  const json result = result_of("batch",
                                "-k 20 --batches 3 --graphs vertex --greedy extended "
                                "--macrostep-skip on --microstep-skip on");
  EXPECT_LT(result["rows"][0]["energy"]["min"], result["rows"][0]["energy"]["max"]);
}

TEST_F(Experiment, AnswersBadOptionsWithOneLine) {
  const std::string mesh = mesh_.string();
  expect_complaint(geolloyd_with("compare " + mesh), "how many regions?");
  expect_complaint(geolloyd_with("compare " + mesh + " -k 5 --threads 0"), "--threads");
  expect_complaint(geolloyd_with("compare " + mesh + " -k 5 --frontiers regions,none"), "none");
  expect_complaint(geolloyd_with("profile " + mesh + " -k 5 --engines fast"), "fast");
  expect_complaint(geolloyd_with("batch " + mesh + " -k 8..4"), "8..4");
  expect_complaint(geolloyd_with("batch " + mesh + " -k few"), "few");
  expect_complaint(geolloyd_with("batch " + mesh + " -k 4000"), "4,000 seeds");
  expect_complaint(geolloyd_with("batch no.ply -k 4"), "no.ply");
}

TEST_F(Experiment, RefusesToOverwriteItsInput) {
  const fs::path seeds = folder_.write("compare.csv", "1\n2\n");
  expect_complaint(geolloyd_with("compare " + mesh_.string() + " --seeds-file " + seeds.string() +
                                 " -o " + folder_.path().string()),
                   "would be overwritten");
}

TEST_F(Experiment, RepeatsInListsCountOnce) {
  const json result = result_of("batch",
                                "-k 4,4..8,8 --batches 2 --graphs vertex,vertex "
                                "--greedy off,off --macrostep-skip on --microstep-skip on");
  ASSERT_EQ(result["rows"].size(), 2U);
  for (const json& row : result["rows"]) EXPECT_EQ(row["batches"], 2);
  EXPECT_EQ(result_of("compare", "-k 20 --threads 2,2 --turns 1")["runs"].size(), 2U);
}

// A triangle that is there eleven times is eleven nodes of the graph of triangles, but has three
// vertices: nothing is begun.
TEST_F(Experiment, BatchRefusesSeedsThatSomeGraphCannotHoldBeforeTheWork) {
  std::string off = "OFF\n12 12 0\n";
  for (int v = 0; v < 12; ++v) off += std::to_string(v % 4) + " " + std::to_string(v / 4) + " 0\n";
  for (int t = 0; t < 11; ++t) off += "3 0 1 4\n";
  off += "3 9 10 11\n";
  mesh_ = folder_.write("two.off", off);
  expect_complaint(geolloyd_with("batch " + mesh_.string() + " -k 8 --graphs triangle,vertex -o " +
                                 out().string()),
                   "fewer vertices than seeds");
  EXPECT_FALSE(fs::exists(out()));
}

// From a parent that holds much memory.
TEST_F(Experiment, PeakMemoryIsThatOfTheRunAlone) {
  const std::vector<char> large(std::size_t{300} << 20, 1);
  const json result = result_of("compare", "-k 20 --turns 1");
  EXPECT_LT(result["runs"][0]["peak_memory_bytes"], large.size() / 2);
}

TEST_F(Experiment, InterruptedCompareWritesWhatItHas) {
  const std::vector<std::string> arguments = {
      "compare", mesh_.string(), "-o",        out().string(), "-k", "20",
      "--turns", "1000000",      "--no-plot", "--threads",    "1"};
  Running running(arguments, folder_.path() / "text", out());
  ::sleep(2);  // for the first turn to end
  running.send(SIGINT);
  EXPECT_EQ(running.wait(), 130);
  const json result = json::parse(read_file(out() / "compare.json"));
  EXPECT_EQ(result["interrupted"], true);
  ASSERT_FALSE(result["runs"].empty());
  for (const json& run : result["runs"]) EXPECT_EQ(run["equal"], true);
  EXPECT_NE(read_file(folder_.path() / "text").find("INTERRUPTED"), std::string::npos);
}

TEST(Comparison, SpeedUpAndEfficiencyAreOfMedians) {
  Comparison comparison;
  comparison.contenders = {{EngineKind::reference, {}, {}, 1, {12.0}},
                           {EngineKind::parallel, {}, {}, 1, {3.0, 4.0, 9.0}},
                           {EngineKind::parallel, {}, {}, 4, {1.0, 3.0}},
                           {EngineKind::parallel, {}, Backend::openmp, 2, {5.0}}};
  auto& c = comparison.contenders;
  EXPECT_EQ(c[1].median(), 4.0);
  EXPECT_EQ(c[2].median(), 2.0);
  EXPECT_EQ(comparison.speedup(c[1]), 3.0);
  EXPECT_EQ(comparison.speedup(c[2]), 6.0);
  EXPECT_EQ(comparison.efficiency(c[2]), 0.5);
  EXPECT_EQ(comparison.efficiency(c[3]), std::nullopt);
  c.erase(c.begin());
  EXPECT_EQ(comparison.speedup(c[0]), std::nullopt);
}

TEST(Comparison, OneThatDiffersFromTheFirstIsNotEqual) {
  Comparison comparison;
  comparison.contenders.resize(3);
  comparison.contenders[0].fingerprint = comparison.contenders[1].fingerprint = 7;
  comparison.contenders[2].fingerprint = 8;
  EXPECT_TRUE(comparison.is_equal(comparison.contenders[1]));
  EXPECT_FALSE(comparison.is_equal(comparison.contenders[2]));
}

TEST(KernelTimes, AreSharedOutByThreadTime) {
  KernelSeconds of_threads;
  of_threads.locked_search = 6;
  of_threads.scoring = 2;
  KernelSeconds sum;
  sum.scoring = 1;
  share_out(4, of_threads, sum);
  EXPECT_EQ(sum.locked_search, 3);
  EXPECT_EQ(sum.scoring, 2);
  share_out(4, {}, sum);  // nobody worked
  EXPECT_EQ(total(sum), 5);
}

TEST(KernelTimes, SinceIsTheDifferenceAndTheRestIsOther) {
  KernelSeconds before;
  before.movement = 1;
  KernelSeconds now = before;
  now.movement = 3;
  now.gathering = 1;
  const KernelSeconds spent = since(before, now, 5);
  EXPECT_EQ(spent.movement, 2);
  EXPECT_EQ(spent.gathering, 1);
  EXPECT_EQ(spent.other, 2);
}

TEST(Laps, CountAsOftenAsTheyWeigh) {
  double once = 0;
  double thrice = 0;
  double never = 0;
  const Stopwatch watch;
  Laps laps;
  laps.begin(1);
  ::usleep(2000);
  laps.end(once);
  laps.begin(3);
  ::usleep(2000);
  laps.end(thrice);
  laps.begin(0);
  ::usleep(2000);
  laps.end(never);
  EXPECT_GE(once, 0.002);
  EXPECT_GE(thrice, 0.006);
  EXPECT_EQ(never, 0);
  EXPECT_LE(once + thrice / 3, watch.seconds());
}

TEST(SeedLadder, DoublesFromTheFirstToTheLast) {
  EXPECT_EQ(seed_ladder({"4..32", "5"}), (std::vector<std::size_t>{4, 5, 8, 16, 32}));
  EXPECT_EQ(seed_ladder({"3..13"}), (std::vector<std::size_t>{3, 6, 12}));
  EXPECT_EQ(seed_ladder({"7..7"}), (std::vector<std::size_t>{7}));
  for (const char* bad : {"", "0", "-4", "4..", "..4", "4...8", "8..4", "4.5", "four"}) {
    EXPECT_THROW(seed_ladder({bad}), InvalidInput) << bad;
  }
}

TEST(Csv, FlattensObjectsAndLeavesNullEmpty) {
  const Json rows = {{{"a", 1}, {"b", {{"c", 0.5}, {"d", "x"}}}, {"e", nullptr}},
                     {{"a", 2}, {"b", {{"c", 1.5}, {"d", "y"}}}, {"e", true}}};
  EXPECT_EQ(csv_text(rows), "a,b_c,b_d,e\n1,0.5,x,\n2,1.5,y,true\n");
  EXPECT_EQ(csv_text(Json::array()), "");
}

TEST(PeakMemory, CanBeForgotten) {
  if (under_address_sanitizer) GTEST_SKIP() << "AddressSanitizer keeps what is freed";
  { const std::vector<char> large(std::size_t{100} << 20, 1); }
  const std::uint64_t before = peak_memory_bytes();
  EXPECT_GT(before, std::uint64_t{100} << 20);
  forget_peak_memory();
  if (::access("/proc/self/clear_refs", W_OK) != 0) GTEST_SKIP() << "this system does not allow it";
  EXPECT_LT(peak_memory_bytes(), before);
}

}  // namespace
}  // namespace geolloyd

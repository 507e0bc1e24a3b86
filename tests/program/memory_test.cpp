#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/support/program.h"
#include "tests/support/sanitizers.h"
#include "tools/system/available_memory.h"
#include "tools/system/memory_estimate.h"
#include "tools/system/memory_limit.h"
#include "tools/system/progress.h"

namespace geolloyd {
namespace {

class AvailableMemory : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) const {
    const fs::path path = folder_.path() / file;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  [[nodiscard]] std::uint64_t found() const { return available_memory(folder_.path()); }

  TemporaryFolder folder_;
};

TEST_F(AvailableMemory, IsNoLimitWhereNothingIsKnown) {
  EXPECT_EQ(found(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_GT(available_memory(), 1'000'000U);
}

TEST_F(AvailableMemory, IsWhatTheMachineHasLeft) {
  write("proc/meminfo", "MemTotal:  100 kB\nMemFree:  1 kB\nMemAvailable:    5 kB\n");
  EXPECT_EQ(found(), 5U * 1024);
}

TEST_F(AvailableMemory, IsTheLeastOfNestedControlGroups) {
  write("proc/meminfo", "MemAvailable: 8 kB\n");
  write("proc/self/cgroup", "0::/jobs/one\n");
  write("sys/fs/cgroup/jobs/one/memory.max", "max\n");
  EXPECT_EQ(found(), 8U * 1024);
  write("sys/fs/cgroup/jobs/memory.max", "5000\n");
  EXPECT_EQ(found(), 5000U);
  write("sys/fs/cgroup/jobs/memory.current", "3000\n");
  EXPECT_EQ(found(), 2000U);
  write("sys/fs/cgroup/jobs/memory.stat",
        "anon 1\ninactive_file 900\nactive_file 500\nslab_reclaimable 100\nslab 7\n");
  EXPECT_EQ(found(), 3500U);
  write("sys/fs/cgroup/jobs/memory.high", "max\n");
  EXPECT_EQ(found(), 3500U);
  write("sys/fs/cgroup/jobs/memory.high", "4000\n");
  EXPECT_EQ(found(), 2500U);
  write("sys/fs/cgroup/jobs/one/memory.max", "700\n");
  EXPECT_EQ(found(), 700U);
  write("sys/fs/cgroup/jobs/one/memory.current", "800\n");
  EXPECT_EQ(found(), 0U);
}

TEST_F(AvailableMemory, KnowsTheFirstVersionOfControlGroups) {
  write("proc/meminfo", "MemAvailable: 8 kB\n");
  write("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/box\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(found(), 8U * 1024);
  write("sys/fs/cgroup/memory/box/memory.limit_in_bytes", "4000\n");
  write("sys/fs/cgroup/memory/box/memory.usage_in_bytes", "1000\n");
  EXPECT_EQ(found(), 3000U);
  write("sys/fs/cgroup/memory/box/memory.stat",
        "inactive_file 1\ntotal_inactive_file 300\ntotal_active_file 100\n");
  EXPECT_EQ(found(), 3400U);
}

// A container sees its own group as the root, whatever its path is called outside.
TEST_F(AvailableMemory, LooksAtTheRootWhereTheGroupIsNotToBeSeen) {
  write("proc/self/cgroup", "0::/outside/name\n");
  write("sys/fs/cgroup/memory.max", "6000\n");
  EXPECT_EQ(found(), 6000U);
}

TEST(MemoryText, IsShort) {
  EXPECT_EQ(memory_text(0), "0 MB");
  EXPECT_EQ(memory_text(812'300'000), "812 MB");
  EXPECT_EQ(memory_text(14'230'000'000), "14.2 GB");
}

TEST(MemoryLimit, AnnouncesALargeRunOnce) {
  testing::internal::CaptureStderr();
  ProgressLine progress{Console()};
  progress.announce_memory("small", 1'000'000'000);
  progress.announce_memory("first", 3'000'000'000);
  progress.announce_memory("second", 4'000'000'000);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "first: takes up to 3.0 GB of memory\n");
}

TEST(MemoryEstimate, GrowsWithEverythingThatIsAskedFor) {
  RunSize size;
  size.vertices = size.nodes = size.seeds = 1'000'000;
  size.triangles = 2'000'000;
  size.edges = size.links = 3'000'000;
  const std::uint64_t plain = memory_to_run(size);
  EXPECT_GT(plain, memory_to_check(size.vertices, size.triangles));
  const auto with = [&](auto change) {
    RunSize more = size;
    change(more);
    return memory_to_run(more);
  };
  EXPECT_GT(with([](RunSize& s) { s.links *= 4; }), plain);
  EXPECT_GT(with([](RunSize& s) { s.nodes *= 3; }), plain);
  EXPECT_GT(with([](RunSize& s) { s.has_ground_truth = true; }), plain);
  EXPECT_GT(with([](RunSize& s) { s.samples = 100'000'000; }), plain);
  EXPECT_GT(with([](RunSize& s) { s.threads = 64; }), plain);
  EXPECT_GT(with([](RunSize& s) { s.seeds = 1; }), plain - 1000 * size.seeds);
}

TEST(MemoryEstimate, OfARemeshGrowsWithEverythingThatIsAskedFor) {
  RemeshSize size;
  size.vertices = size.fine_vertices = 1'000'000;
  size.triangles = 2'000'000;
  size.edges = 3'000'000;
  size.remesh_vertices = 1000;
  const std::uint64_t plain = memory_to_remesh(size);
  EXPECT_GT(plain, memory_to_check(size.vertices, size.triangles));
  const auto with = [&](auto change) {
    RemeshSize more = size;
    change(more);
    return memory_to_remesh(more);
  };
  EXPECT_GT(with([](RemeshSize& s) { s.fine_vertices *= 2; }), plain);
  EXPECT_GT(with([](RemeshSize& s) { s.remesh_vertices *= 10; }), plain);
  EXPECT_GT(with([](RemeshSize& s) { s.samples = 100'000'000; }), plain);
  EXPECT_GT(with([](RemeshSize& s) { s.threads = 64; }), plain);
}

// Names the figure, and does nothing.
TEST_F(Program, RefusesWhatDoesNotFitIntoTheMemory) {
  const Outcome outcome = relax("--seeds 20 --memory-limit 30M");
  expect_complaint(outcome, "only 30 MB are allowed");
  EXPECT_NE(outcome.text.find("needs about"), std::string::npos);
  EXPECT_FALSE(fs::exists(out()));
  for (const std::string enough : {"1G", "1gb", "2000MiB", "1000000000", "1000000000b"}) {
    EXPECT_EQ(relax("--seeds 20 --memory-limit " + enough).status, 0) << enough;
  }
}

TEST_F(Program, EstimatesTheMemoryOfSeedsInAFileAsOfSeedsChosen) {
  const auto estimate = [&](const std::string& name) -> std::uint64_t {
    return nlohmann::json::parse(read_file(out(name) / "report.json"))["memory_estimate_bytes"];
  };
  ASSERT_EQ(relax("--seeds 50 --init farthest", "chosen").status, 0);
  std::string ids = "# fifty\n\n";
  const std::vector<std::string> lines = lines_of(out("chosen") / "seeds.csv");
  for (std::size_t i = 1; i < lines.size(); ++i)
    ids += lines[i].substr(0, lines[i].find(',')) + "\n";
  const fs::path file = folder_.write("ids.txt", ids);
  ASSERT_EQ(relax("--seeds-file " + file.string(), "given").status, 0);
  EXPECT_EQ(estimate("given"), estimate("chosen"));
}

TEST_F(Program, EveryCommandHeedsTheMemoryLimit) {
  const std::string mesh = mesh_.string();
  const std::string low = " --memory-limit 20M";
  for (const std::string& command :
       {"verify " + mesh + " -k 9", "compare " + mesh + " -k 9", "profile " + mesh + " -k 9",
        "batch " + mesh + " -k 9", "ground-truth " + mesh + " -k 9", "quality " + mesh,
        "info " + mesh, "render " + mesh + " -o p.png", "remesh " + mesh + " -n 9 -o r.ply",
        "verify " + mesh + " -n 9", "subdivide " + mesh + " -s midpoint -o fine.ply",
        std::string("generate torus -o t.ply")}) {
    expect_complaint(geolloyd_with(command + low), "only 20 MB are allowed");
  }
}

TEST_F(Program, RefusesFilesPicturesAndMeshesThatAreTooLargeBeforeTheWork) {
  const fs::path large = folder_.path() / "large.ply";
  std::ofstream(large) << "ply\n";
  fs::resize_file(large, 5'000'000'000);  // a hole
  expect_complaint(geolloyd_with("info " + large.string() + " --memory-limit 3G"), "5.0 GB");
  expect_complaint(geolloyd_with("render " + mesh_.string() + " --size 8192x8192 -o " +
                                 (folder_.path() / "p.png").string() + " --memory-limit 8G"),
                   "only 8.0 GB are allowed");
  const std::string fine = (folder_.path() / "fine.ply").string();
  expect_complaint(
      geolloyd_with("generate creature -t 1400000000 -o " + fine + " --memory-limit 8G"),
      "only 8.0 GB are allowed");
  std::string schemes;
  for (int i = 0; i < 12; ++i) schemes += " -s barycentric";
  expect_complaint(geolloyd_with("subdivide " + mesh_.string() + " -o " + fine + schemes +
                                 " --memory-limit 60M"),
                   "only 60 MB are allowed");
  EXPECT_FALSE(fs::exists(fine));
}

// The stacks of threads are large, but empty.
TEST_F(Program, StartsManyThreadsWithLittleMemory) {
  if (under_sanitizer) GTEST_SKIP();
  for (const std::string backend : {"tbb", "openmp"}) {
    const Outcome outcome = relax("-k 5 --threads 64 --memory-limit 120M --backend " + backend);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
  }
}

// As the shell, OpenMP and TBB have them: the largest counts.
TEST_F(Program, StartsThreadsWithStacksOfAnySize) {
  if (under_sanitizer) GTEST_SKIP();
  const std::string command = GEOLLOYD_PROGRAM " relax " + mesh_.string() + " -o " +
                              out().string() + " -k 5 --memory-limit 100M --threads ";
  for (const std::string& started :
       {"ulimit -S -s 1024; " + command + "64", "ulimit -S -s 65536; " + command + "16",
        "ulimit -S -s 65536; " + command + "16 --backend openmp",
        "OMP_STACKSIZE=256M " + command + "16 --backend openmp",
        "OMP_STACKSIZE=' 65536 ' " + command + "16 --backend openmp"}) {
    const Outcome outcome = run_shell("{ " + started + "; }");
    EXPECT_EQ(outcome.status, 0) << started << "\n" << outcome.text;
  }
}

TEST_F(Program, RefusesMoreThreadsThanTheShellHasRoomFor) {
  if (under_sanitizer) GTEST_SKIP();
  const std::string command =
      GEOLLOYD_PROGRAM " relax " + mesh_.string() + " -o " + out().string() + " -k 5 --threads ";
  for (const std::string limit : {"ulimit -v 600000; ", "ulimit -d 300000; "}) {
    for (const std::string backend : {"tbb", "openmp"}) {
      const std::string rest = " --backend " + backend + "; }";
      expect_complaint(run_shell("{ " + limit + command + "128" + rest),
                       "the stacks of 128 threads reserve 1.1 GB");
      EXPECT_FALSE(fs::exists(out()));
      const Outcome few = run_shell("{ " + limit + command + "2" + rest);
      EXPECT_EQ(few.status, 0) << few.text;
      fs::remove_all(out());
    }
  }
}

TEST_F(Program, GivesItsLimitToNoOtherProgram) {
  const fs::path python = folder_.write("python3", "#!/bin/sh\necho data $(ulimit -S -d) end\n");
  fs::permissions(python, fs::perms::owner_all);
  const Outcome expected = run_shell("sh " + python.string());
  const Outcome outcome =
      run_shell("PATH=" + folder_.path().string() + ":$PATH " GEOLLOYD_PROGRAM " compare " +
                mesh_.string() + " -k 5 --turns 1 --memory-limit 200M -o " + out().string());
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find(expected.text), std::string::npos) << outcome.text;
}

// No file size warns of it.
TEST_F(Program, MeetsTheLimitWhereNothingCouldBeForeseen) {
  if (under_sanitizer) GTEST_SKIP();
  const std::string endless = (folder_.path() / "endless.off").string();
  ASSERT_EQ(::mkfifo(endless.c_str(), 0600), 0);
  expect_complaint(
      run_shell("timeout 60 yes > " + endless + " 2>/dev/null & " GEOLLOYD_PROGRAM " info " +
                endless + " --memory-limit 100M"),
      "out of memory, of which 100 MB are allowed");
}

// Runs `command` with as little as it says that it needs, to the next MB.
Outcome run_with_least_memory(const std::string& command) {
  std::string limit = "20M";
  for (int tries = 0;; ++tries) {
    Outcome outcome = geolloyd_with(command + " --memory-limit " + limit);
    std::smatch figure;
    const bool refused =
        std::regex_search(outcome.text, figure, std::regex("needs about ([0-9]+) MB"));
    if (!refused || tries == 5) return outcome;
    limit = std::to_string(std::stoul(figure[1]) + 1) + "M";
  }
}

// Embree and the allocator reserve more than they touch, and only that is estimated.
TEST_F(Program, FinishesWithTheMemoryItAsksFor) {
  if (under_sanitizer) GTEST_SKIP();
  const std::string picture = (folder_.path() / "p.png").string();
  for (const std::string triangles : {"2000", "60000"}) {
    const std::string mesh = (folder_.path() / (triangles + ".ply")).string();
    ASSERT_EQ(geolloyd_with("generate creature -t " + triangles + " -o " + mesh).status, 0);
    const std::string relax = "relax " + mesh +
                              " -k 50 --max-greedy-steps 1 --max-macrosteps 1 -o " +
                              out().string() + " --threads ";
    for (const std::string& command :
         {relax + "2", relax + "2 -g vertex-dense", relax + "2 -g triangle",
          relax + "2 -g triangle-dense", relax + "2 -g mixed", relax + "2 -g vertex-far",
          relax + "2 -g vertex-far --norm linf --vfield cross", relax + "2 --engine reference",
          relax + "2 --frontier delta", relax + "1 --ground-truth", relax + "2 --ground-truth",
          relax + "16 --ground-truth", relax + "2 --backend openmp --ground-truth",
          relax + "2 -g triangle --dual-vertices centroids",
          relax + "2 --picture " + picture + " --size 256",
          "render " + mesh + " --size 256 -o " + picture, "quality " + mesh,
          "quality " + mesh + " --original " + mesh}) {
      const Outcome outcome = run_with_least_memory(command);
      EXPECT_EQ(outcome.status, 0) << command << "\n" << outcome.text;
    }
  }
}

// On a mesh so large that the program itself counts for little.
TEST_F(Program, HoldsNoMoreMemoryThanEstimatedAndNotMuchLess) {
  if (under_sanitizer) GTEST_SKIP();
  ASSERT_EQ(geolloyd_with("generate creature -t 200000 -o " + mesh_.string()).status, 0);
  for (const std::string options :
       {"vertex", "vertex-dense", "triangle", "triangle-dense", "mixed", "vertex-far",
        "vertex-far --norm linf --vfield cross", "vertex --engine reference",
        "vertex --frontier delta", "triangle --dual-vertices centroids", "vertex --ground-truth"}) {
    const Outcome outcome =
        relax("-k 500 --threads 2 --max-greedy-steps 2 --max-macrosteps 1 -g " + options);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    const auto report = nlohmann::json::parse(read_file(out() / "report.json"));
    const auto peak = report["peak_memory_bytes"].get<std::uint64_t>();
    const auto estimate = report["memory_estimate_bytes"].get<std::uint64_t>();
    EXPECT_LE(peak, estimate) << options;
    EXPECT_LT(estimate, 2 * peak + 64'000'000) << options;
  }
}

TEST_F(Program, FinishesARemeshWithTheMemoryItAsksFor) {
  if (under_sanitizer) GTEST_SKIP();
  ASSERT_EQ(geolloyd_with("generate creature -t 60000 -o " + mesh_.string()).status, 0);
  const std::string picture = (folder_.path() / "p.png").string();
  for (const std::string& options :
       {std::string("--threads 1"), std::string("--threads 16"), std::string("--engine reference"),
        "--size 256 --picture " + picture}) {
    const Outcome outcome = run_with_least_memory("remesh " + mesh_.string() + " -n 200 -o " +
                                                  out("r.ply").string() + " " + options);
    EXPECT_EQ(outcome.status, 0) << options << "\n" << outcome.text;
  }
}

// Where the mesh is what counts, and where the remesh is.
TEST_F(Program, HoldsNoMoreMemoryForARemeshThanEstimatedAndNotMuchLess) {
  if (under_sanitizer) GTEST_SKIP();
  for (const auto& [triangles, options] : {std::pair{"200000", "-n 100"}, {"2000", "-n 4000"}}) {
    ASSERT_EQ(geolloyd_with("generate creature -o " + mesh_.string() + " -t " + triangles).status,
              0);
    const Outcome outcome =
        geolloyd_with("remesh " + mesh_.string() + " -o " + out("r.ply").string() + " --report " +
                      out("r.json").string() + " --threads 2 " + options);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    const auto report = nlohmann::json::parse(read_file(out("r.json")));
    const auto peak = report["peak_memory_bytes"].get<std::uint64_t>();
    const auto estimate = report["memory_estimate_bytes"].get<std::uint64_t>();
    EXPECT_LE(peak, estimate) << options;
    EXPECT_LT(estimate, 2 * peak + 64'000'000) << options;
  }
}

}  // namespace
}  // namespace geolloyd

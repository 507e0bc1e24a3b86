#include <sys/resource.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/support/program.h"
#include "tests/support/sanitizers.h"
#include "tools/system/available_memory.h"
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

struct FrugalRun {
  int status = -1;
  std::string text;
  double asked = 0;  // MB
  double peak = 0;   // MB
};

FrugalRun run_with(double limit, const std::string& command, const fs::path& text) {
  const std::string size = std::to_string(std::lround(limit)) + "M";
  const std::string line = std::string("exec ") + GEOLLOYD_PROGRAM + " " + command +
                           " --memory-limit " + size + " > " + text.string() + " 2>&1";
  const pid_t id = ::fork();
  if (id == 0) {
    ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  ::wait4(id, &status, 0, &used);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(text), limit,
          static_cast<double>(used.ru_maxrss) * 1024e-6};
}

// With as little as it says that it needs, to the next MB.
FrugalRun run_with_least_memory(const std::string& command, const fs::path& text) {
  FrugalRun run = run_with(1, command, text);
  std::smatch figure;
  while (std::regex_search(run.text, figure, std::regex("needs about ([0-9]+) MB"))) {
    const double needed = std::stod(figure[1]) + 1;
    if (needed <= run.asked) break;
    run = run_with(needed, command, text);
  }
  return run;
}

class Frugality : public Program {
 protected:
  void SetUp() override {
    if (under_sanitizer) GTEST_SKIP();
    Program::SetUp();
  }

  // MESH and OUT in a command stand for files.
  void expect_frugal(const std::string& triangles, const std::vector<std::string>& commands) {
    const std::string mesh = (folder_.path() / (triangles + ".ply")).string();
    ASSERT_EQ(geolloyd_with("generate creature -t " + triangles + " -o " + mesh).status, 0);
    for (std::string command : commands) {
      command = std::regex_replace(command, std::regex("MESH"), mesh);
      command = std::regex_replace(command, std::regex("OUT"), out().string());
      expect_frugal(command);
    }
  }

  // The program itself and what the allocator keeps of what was freed: up to 60 MB.
  void expect_frugal(const std::string& command) {
    const FrugalRun run = run_with_least_memory(command, out("text"));
    EXPECT_EQ(run.status, 0) << command << "\n" << run.text;
    EXPECT_LE(run.peak, run.asked) << command;
    EXPECT_LE(run.asked, 1.2 * run.peak + 60) << command;
  }
};

const std::string relax_mesh = "relax MESH -o OUT --max-greedy-steps 1 --max-macrosteps 1 ";

TEST_F(Frugality, OfSmallMeshes) {
  expect_frugal("2000",
                {relax_mesh + "-k 50 --threads 1", relax_mesh + "-k 50 --threads 16",
                 relax_mesh + "-k 50 -g triangle --backend openmp --ground-truth",
                 relax_mesh + "-k 50 --picture OUT.png --size 256",
                 "remesh MESH -o OUT.ply -n 4000 --threads 16", "render MESH -o OUT.png --size 256",
                 "quality MESH --original MESH", "repair MESH -o OUT.ply", "info MESH"});
}

TEST_F(Frugality, OfRelax) {
  const std::string relax = relax_mesh + "--threads 2 ";
  expect_frugal("200000", {relax + "-k 1 -g triangle", relax + "-k 500", relax + "-k 20000",
                           relax + "-k 500 -g vertex-dense", relax + "-k 500 -g triangle",
                           relax + "-k 20000 -g triangle-dense", relax + "-k 500 -g mixed",
                           relax + "-k 500 -g vertex-far", relax + "-k 500 --vfield curvature",
                           relax + "-k 500 -g mixed --norm linf --vfield cross",
                           relax + "-k 500 --ground-truth", relax + "-k 500 --engine reference",
                           relax + "-k 500 -g triangle --dual-vertices centroids",
                           relax + "-k 500 --frontier delta --picture OUT.png --size 512"});
  expect_frugal("1000000", {relax + "-k 500 -g mixed"});
}

// A tessellation has properties.
TEST_F(Frugality, OfRemesh) {
  const std::string remesh = "remesh MESH -o OUT.ply --threads 2 -n ";
  expect_frugal("2000", {remesh + "10000", remesh + "10000 --features 20"});
  expect_frugal("200000", {relax_mesh + "-k 500", remesh + "500", remesh + "5000 --adapt 1",
                           remesh + "500 --vfield curvature", remesh + "500 --engine reference",
                           remesh + "500 --size 512 --picture OUT.png",
                           "remesh OUT/tessellation.ply -o OUT.ply --threads 2 -n 500"});
  expect_frugal("1000000", {remesh + "500"});
}

TEST_F(Frugality, OfOtherCommands) {
  expect_frugal("200000",
                {"info MESH", "quality MESH", "quality MESH --original MESH",
                 "repair MESH -o OUT.ply", "subdivide MESH -s midpoint -o OUT.ply",
                 "render MESH -o OUT.png --size 512", "render MESH -k 500 -o OUT.png --size 512"});
}

}  // namespace
}  // namespace geolloyd

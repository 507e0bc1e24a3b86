// Signals at any moment of any command, and runs that go on after them.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/formats/mesh_io.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"
#include "tests/support/sanitizers.h"

namespace geolloyd {
namespace {

const std::set<std::string> result_names = {"regions.csv", "dual.ply", "report.json", "seeds.csv",
                                            "tessellation.ply"};

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

// What kill -9 may leave in the instant in which a checkpoint takes the place of another.
void remove_temporary_names(const fs::path& folder) {
  for (const std::string& name : names_in(folder)) {
    if (name.starts_with(".geolloyd-") && name.ends_with(".part")) fs::remove(folder / name);
  }
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// What must not depend on when a run was left and by what it was resumed.
nlohmann::json course_in(const fs::path& folder) {
  nlohmann::json report = nlohmann::json::parse(read_file(folder / "report.json"));
  for (nlohmann::json& step : report["trace"]) step.erase("kernel_seconds");
  nlohmann::json course;
  for (const char* key :
       {"end", "interrupted", "fingerprint", "energy", "steps", "trace", "graph"}) {
    course[key] = report[key];
  }
  return course;
}

class Interruption : public Program {
 protected:
  // Long enough for signals to come in any stage of it.
  void SetUp() override {
    Program::SetUp();
    mesh_ = folder_.path() / "creature.ply";
    ASSERT_EQ(geolloyd_with("generate creature -t 20000 -o " + mesh_.string()).status, 0);
  }

  static std::size_t runs(std::size_t few, std::size_t many) {
    return std::getenv("GEOLLOYD_LONG_TESTS") != nullptr ? many : few;
  }

  [[nodiscard]] std::string command(const std::string& name,
                                    const std::string& checkpoint = "0") const {
    return "relax " + mesh_.string() + " -o " + out(name).string() +
           " --seeds 40 --init random --checkpoint " + checkpoint + " ";
  }

  // Starts it, sends the signal after a random share of `longest`, and returns how it ended.
  [[nodiscard]] int end_at_random(const std::string& arguments, int signal, double longest,
                                  std::uint64_t n) const {
    Running running(words_of(arguments), folder_.path() / "text");
    ::usleep(static_cast<useconds_t>(1e6 * longest * random_unit(random_seed, n)));
    running.send(signal);
    return running.wait();
  }

  // In seconds.
  static double duration_of(const std::string& arguments) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const Outcome outcome = geolloyd_with(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  void expect_complete(const std::string& name, const nlohmann::json& expected) const {
    EXPECT_EQ(names_in(out(name)), result_names);
    EXPECT_EQ(course_in(out(name)), expected);
    EXPECT_EQ(read_file(out(name) / "seeds.csv"), read_file(out("whole") / "seeds.csv"));
    EXPECT_EQ(read_file(out(name) / "regions.csv"), read_file(out("whole") / "regions.csv"));
    EXPECT_EQ(read_file(out(name) / "dual.ply"), read_file(out("whole") / "dual.ply"));
  }

  static constexpr std::uint64_t random_seed = 20;
};

TEST_F(Interruption, KilledAgainAndAgainEndsAsIfNeverKilled) {
  const double longest = duration_of(command("whole"));
  const nlohmann::json expected = course_in(out("whole"));
  const std::vector<std::string> engines = {"", "--engine reference", "--threads 1",
                                            "--backend openmp --frontier delta",
                                            "--threads 3 --frontier heap"};
  std::uint64_t n = 0;
  for (std::size_t run = 0; run < runs(2, 20); ++run) {
    const std::string name = "run" + std::to_string(run);
    for (std::size_t part = 0; part < 6; ++part, ++n) {
      SCOPED_TRACE(n);
      const bool has_checkpoint = names_in(out(name)).contains("checkpoint.msgpack");
      const int status = end_at_random(
          command(name) + engines[n % engines.size()] + (has_checkpoint ? " --resume" : ""),
          SIGKILL, longest, n);
      if (status == 0) break;
      ASSERT_EQ(status, -SIGKILL) << read_file(folder_.path() / "text");
      remove_temporary_names(out(name));
    }
    if (names_in(out(name)) != result_names) {
      const bool has_checkpoint = names_in(out(name)).contains("checkpoint.msgpack");
      const Outcome last = geolloyd_with(command(name) + (has_checkpoint ? " --resume" : ""));
      ASSERT_EQ(last.status, 0) << last.text;
    }
    expect_complete(name, expected);
  }
}

TEST_F(Interruption, LeavesNothingOrAMarkedResultThatCanBeResumed) {
  const double longest = duration_of(command("whole"));
  const nlohmann::json expected = course_in(out("whole"));
  std::map<int, int> count;
  for (std::size_t run = 0; run < runs(16, 100); ++run) {
    SCOPED_TRACE(run);
    const std::string name = "run" + std::to_string(run);
    const int signal = std::array{SIGINT, SIGTERM, SIGHUP}[run % 3];
    // Some checkpoints are those of the interrupt alone.
    const std::string checkpoint = run % 4 == 0 ? "60" : "0";
    const int status = end_at_random(command(name, checkpoint), signal, longest, run);
    ++count[status];
    if (status == -signal) {  // before the program itself began
      EXPECT_EQ(names_in(out(name)), std::set<std::string>{});
    } else if (status == 130 && !fs::exists(out(name))) {
      EXPECT_EQ(read_file(folder_.path() / "text"), "geolloyd: interrupted\n");
    } else if (status == 0) {
      expect_complete(name, expected);
    } else {
      ASSERT_EQ(status, 130) << read_file(folder_.path() / "text");
      std::set<std::string> names = result_names;
      names.insert("checkpoint.msgpack");
      EXPECT_EQ(names_in(out(name)), names);
      EXPECT_EQ(course_in(out(name))["interrupted"], true);
      EXPECT_NE(read_file(folder_.path() / "text").find("--resume"), std::string::npos);
      const Outcome rest = geolloyd_with(command(name) + " --resume");
      EXPECT_EQ(rest.status, 0) << rest.text;
      EXPECT_NE(rest.text.find("resumed"), std::string::npos);
      expect_complete(name, expected);
    }
  }
  EXPECT_GT(count[130], 0);
}

// A relaxation of a mesh that comes through a pipe, and so is read until the test closes that.
class Reading {
 public:
  explicit Reading(const fs::path& folder) : text_(folder / "text"), out_(folder / "out") {
    const fs::path pipe = folder / "pipe.off";
    EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    running_.emplace(
        std::vector<std::string>{"relax", pipe.string(), "-k", "1", "-o", out_.string()}, text_);
    mesh_.open(pipe);  // waits until the program opens it as well
  }

  void send(int signal) const { running_->send(signal); }
  void end_mesh() {
    mesh_ << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    mesh_.close();
  }
  int wait() { return running_->wait(); }
  [[nodiscard]] std::string text() const { return read_file(text_); }
  [[nodiscard]] const fs::path& out() const { return out_; }

 private:
  fs::path text_;
  fs::path out_;
  std::optional<Running> running_;
  std::ofstream mesh_;
};

TEST(Interrupts, BeforeTheRelaxationEndItAtOnceWithOneLine) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    Reading run(folder.path());
    run.send(signal);
    EXPECT_EQ(run.wait(), 130);
    EXPECT_EQ(run.text(), "geolloyd: interrupted\n");
    EXPECT_FALSE(fs::exists(run.out()));
  }
}

// Whatever the first one does, and until it ends in whatever way.
TEST_F(Program, RefusesASecondRunIntoAFolder) {
  fs::create_directory(out());
  Reading first(folder_.path());
  for (const std::string command : {"relax ", "compare ", "profile ", "batch ", "ground-truth "}) {
    expect_complaint(geolloyd_with(command + mesh_.string() + " -k 5 -o " + out().string()),
                     "/out: another run writes into this folder: wait for its end, or give");
  }
  expect_complaint(relax("-k 5 --frames " + out().string(), "other"), "/out: another run writes");
  EXPECT_EQ(names_in(out()), std::set<std::string>{});
  first.send(SIGKILL);
  first.wait();
  EXPECT_EQ(relax("-k 5 --size 64 --frames " + out().string()).status, 0);
}

TEST(Interrupts, LeaveARunUnderNohupAlone) {
  const TemporaryFolder folder;
  auto* const before = std::signal(SIGHUP, SIG_IGN);
  Reading run(folder.path());
  std::signal(SIGHUP, before);
  run.send(SIGHUP);
  ::usleep(50'000);
  run.end_mesh();
  EXPECT_EQ(run.wait(), 0) << run.text();
}

TEST_F(Interruption, GoesOnAmongItsFrames) {
  const auto with_frames = [&](const std::string& name) {
    return command(name) + " --size 64 --frames " + out(name + "-frames").string();
  };
  const double longest = duration_of(with_frames("whole"));
  int status = 0;
  for (std::uint64_t n = 0; status != 130; ++n) {
    ASSERT_LT(n, 50U) << "no interrupt came in time";
    fs::remove_all(out("run"));
    fs::remove_all(out("run-frames"));
    status = end_at_random(with_frames("run"), SIGINT, longest, n);
  }
  const Outcome rest = geolloyd_with(with_frames("run") + " --resume");
  ASSERT_EQ(rest.status, 0) << rest.text;
  expect_complete("run", course_in(out("whole")));
  EXPECT_EQ(names_in(out("run-frames")), names_in(out("whole-frames")));
  for (const std::string& frame : names_in(out("whole-frames"))) {
    EXPECT_EQ(read_file(out("run-frames") / frame), read_file(out("whole-frames") / frame))
        << frame;
  }
}

TEST_F(Interruption, ResumesOnlyWhatItIsTheCheckpointOf) {
  expect_complaint(relax("--seeds 40 --resume"), "no such checkpoint to go on from");
  ASSERT_FALSE(fs::exists(out()));
  const double longest = duration_of(command("whole"));
  for (std::uint64_t n = 0; !fs::exists(out("run") / "checkpoint.msgpack"); ++n) {
    ASSERT_LT(n, 50U) << "no signal came in time";
    const int status = end_at_random(command("run"), SIGKILL, longest, n);
    ASSERT_TRUE(status == 0 || status == -SIGKILL) << status;
  }
  const std::string checkpoint = read_file(out("run") / "checkpoint.msgpack");
  for (const std::string options : {"--greedy standard", "--random-seed 2", "-g triangle",
                                    "--norm linf", "--no-macrostep-skip"}) {
    expect_complaint(geolloyd_with(command("run") + "--resume " + options),
                     "checkpoint.msgpack: is the checkpoint of ");
  }
  const std::string whole_mesh = mesh_.string();
  mesh_ = folder_.path() / "torus.ply";
  expect_complaint(geolloyd_with(command("run") + "--resume"), "of another mesh");
  mesh_ = whole_mesh;
  EXPECT_EQ(read_file(out("run") / "checkpoint.msgpack"), checkpoint);
  const fs::path cut = out("run") / "checkpoint.msgpack";
  fs::resize_file(cut, checkpoint.size() / 2);
  expect_complaint(geolloyd_with(command("run") + "--resume"), "a damaged one");
}

// Nothing, or a whole remesh that says whether it is the best so far; no earlier file is lost.
TEST_F(Interruption, LeavesNothingOrAMarkedRemesh) {
  if (under_sanitizer) GTEST_SKIP() << "takes ten minutes under a sanitizer";
  const fs::path folder = folder_.path() / "r";
  fs::create_directory(folder);
  const auto remesh = [&](const std::string& vertices) {
    return "remesh " + mesh_.string() + " -n " + vertices + " -o " + (folder / "r.ply").string() +
           " --map " + (folder / "r.csv").string() + " --report " + (folder / "r.json").string();
  };
  const auto bytes = [&](const char* name) { return read_file(folder / name); };
  const double longest = duration_of(remesh("800"));
  const std::string whole = bytes("r.ply");
  ASSERT_EQ(geolloyd_with(remesh("100")).status, 0);
  const std::string earlier = bytes("r.ply");
  std::size_t marked = 0;
  for (std::size_t run = 0; run < runs(12, 100) || marked == 0; ++run) {
    SCOPED_TRACE(run);
    ASSERT_LT(run, 200U) << "no interrupt came in time";
    const int signal = std::array{SIGINT, SIGTERM, SIGHUP}[run % 3];
    const int status = end_at_random(remesh("800"), signal, longest, 3000 + run);
    const std::string text = read_file(folder_.path() / "text");
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"r.csv", "r.json", "r.ply"}));
    const bool is_earlier = bytes("r.ply") == earlier;
    if (status == -signal) {  // before the program itself began
      EXPECT_TRUE(is_earlier);
      continue;
    }
    if (status == 130 && is_earlier) {
      EXPECT_EQ(text, "geolloyd: interrupted\n");
      continue;
    }
    const nlohmann::json report = nlohmann::json::parse(bytes("r.json"));
    const Mesh made = read(folder / "r.ply").mesh;
    EXPECT_EQ(made.vertex_count(), report["remesh"]["vertices"]);
    EXPECT_EQ(lines_of(folder / "r.csv").size(), made.vertex_count() + 1);
    EXPECT_EQ(report["remesh"]["has_input_topology"], true);
    EXPECT_EQ(report["interrupted"], status == 130);
    EXPECT_EQ(text.find("INTERRUPTED, best state so far") != std::string::npos, status == 130);
    if (status == 130) {
      ++marked;
    } else {
      EXPECT_EQ(status, 0) << text;
      EXPECT_EQ(bytes("r.ply"), whole);
    }
    ASSERT_EQ(geolloyd_with(remesh("100")).status, 0);
  }
}

// Other commands end at once, or mark what they have: no file is ever there in part.
TEST_F(Interruption, LeavesNoFileHalfWrittenWhateverTheCommand) {
  if (under_sanitizer) GTEST_SKIP() << "takes more than a minute under a sanitizer";
  ASSERT_EQ(geolloyd_with(command("whole")).status, 0);
  const std::string mesh = mesh_.string();
  const std::string seeds = " --seeds-file " + (out("whole") / "seeds.csv").string();
  const std::string target = (folder_.path() / "target").string();
  const auto is_json = [](const fs::path& p) { return nlohmann::json::accept(read_file(p)); };
  const auto is_mesh = [](const fs::path& p) { return read(p).mesh.triangle_count() > 1000; };
  const auto is_png = [](const fs::path& p) {
    return read_file(p).find("IEND") != std::string::npos;
  };
  using Check = std::function<bool(const fs::path&)>;
  const std::vector<std::pair<std::string, Check>> commands = {
      {"generate creature -t 40000 -o " + target + "/m.ply", is_mesh},
      {"generate icosphere -t 60000 -o " + target + "/m.obj", is_mesh},
      {"subdivide " + mesh + " -s midpoint -o " + target + "/m.stl", is_mesh},
      {"quality " + mesh + " --original " + mesh + " --samples 50000 --output " + target +
           "/q.json",
       is_json},
      {"render " + mesh + seeds + " --size 400 --panel regions --panel dual -o " + target +
           "/p.png",
       is_png},
      {"ground-truth " + mesh + seeds + " --output " + target + "/g", {}},
      {"verify " + mesh + " -n 80", {}},
      {"compare " + mesh + " -k 10 --threads 1,2 --backends tbb --no-plot -o " + target + "/c",
       {}}};
  std::uint64_t n = 1000;
  for (const auto& [arguments, check] : commands) {
    fs::create_directory(target);
    const double longest = duration_of(arguments);
    for (std::size_t run = 0; run < runs(2, 20); ++run, ++n) {
      SCOPED_TRACE(arguments + ", " + std::to_string(n));
      fs::remove_all(target);
      fs::create_directory(target);
      const int signal = run % 2 == 0 ? SIGINT : SIGTERM;
      const int status = end_at_random(arguments, signal, longest, n);
      EXPECT_TRUE(status == 0 || status == -signal || status == 130) << status;
      for (const auto& entry : fs::recursive_directory_iterator(target)) {
        const std::string name = entry.path().filename();
        EXPECT_EQ(name.find(".part"), std::string::npos) << name;
        const bool is_whole = entry.is_directory() ||
                              (entry.path().extension() == ".json" ? is_json(entry.path())
                                                                   : !check || check(entry.path()));
        EXPECT_TRUE(is_whole) << name;
      }
    }
    fs::remove_all(target);
  }
}

}  // namespace
}  // namespace geolloyd

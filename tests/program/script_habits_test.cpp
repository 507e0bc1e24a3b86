// What scripts rely on: JSON on the standard output, silence, exit codes.
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace geolloyd {
namespace {

class ScriptHabits : public Program {
 protected:
  [[nodiscard]] std::string in(const std::string& name) const { return out(name).string(); }

  // Each command that judges or makes something, with options that make it short.
  [[nodiscard]] std::vector<std::string> commands_with_figures() const {
    const std::string mesh = mesh_.string();
    return {"info " + mesh,
            "quality " + mesh,
            "remesh " + mesh + " -n 12 -o " + in("remesh.ply"),
            "relax " + mesh + " -k 8 -o " + in("result"),
            "repair " + mesh + " -o " + in("repaired.ply"),
            "ground-truth " + mesh + " -k 8",
            "verify " + mesh + " -k 8",
            "verify " + mesh + " -n 12",
            "compare " + mesh + " -k 8 --turns 1 --threads 1",
            "profile " + mesh + " -k 8",
            "batch " + mesh + " -k 8 --batches 1 --graphs vertex --greedy off",
            "remesh-all " + mesh + " -n 12 -o " + in("all"),
            "generate torus -t 500 -o " + in("t.ply"),
            "subdivide " + mesh + " -s midpoint -o " + in("s.ply"),
            "convert " + mesh + " " + in("c.obj")};
  }
};

TEST_F(ScriptHabits, JsonIsAllThatIsPrinted) {
  for (const std::string& command : commands_with_figures()) {
    const Outcome outcome = geolloyd_with(command + " --json");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    const auto json = nlohmann::json::parse(outcome.text, nullptr, false);
    ASSERT_TRUE(json.is_object()) << command << "\n" << outcome.text;
    EXPECT_FALSE(json.empty()) << command;
  }
}

TEST_F(ScriptHabits, JsonIsTheReport) {
  const std::string report = in("report.json");
  const Outcome printed = geolloyd_with("remesh " + mesh_.string() + " -n 12 -o " + in("r.ply") +
                                        " --json --report " + report);
  auto expected = nlohmann::json::parse(read_file(report));
  auto found = nlohmann::json::parse(printed.text);
  for (auto* json : {&expected, &found}) {
    for (const char* changing : {"seconds", "peak_memory_bytes"}) json->erase(changing);
  }
  EXPECT_EQ(found, expected);
}

// Of a folder's file and the standard output.
TEST_F(ScriptHabits, JsonIsWhatTheFolderHolds) {
  const std::string mesh = mesh_.string();
  const std::string folder = " --no-plot --json -o " + in("folder");
  for (const auto& [command, options] : std::vector<std::pair<std::string, std::string>>{
           {"compare", " -k 8 --turns 1 --threads 1"},
           {"profile", " -k 8"},
           {"batch", " -k 8 --batches 1 --graphs vertex --greedy off"}}) {
    std::string line = command;
    const Outcome outcome = geolloyd_with(line.append(" ").append(mesh).append(options) + folder);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(outcome.text, read_file(out("folder") / (command + ".json"))) << command;
  }
}

TEST_F(ScriptHabits, JsonOfMeshesThatFailIsPrintedAllTheSame) {
  const Outcome outcome =
      run_shell("(" GEOLLOYD_PROGRAM " remesh-all " + mesh_.string() + " " + in("missing.ply") +
                " -n 12 --json -o " + in("all") + " 2>/dev/null)");
  EXPECT_EQ(outcome.status, 2);
  const auto json = nlohmann::json::parse(outcome.text, nullptr, false);
  ASSERT_TRUE(json.is_object()) << outcome.text;
  EXPECT_EQ(json["done"], 1);
  EXPECT_EQ(json["failed"], 1);
}

TEST_F(ScriptHabits, QuietPrintsErrorsOnly) {
  std::vector<std::string> commands = commands_with_figures();
  const std::string mesh = mesh_.string();
  commands.push_back("render " + mesh + " --size 64 -o " + in("p.png"));
  for (const std::string& command : commands) {
    const Outcome outcome = geolloyd_with(command + " --quiet");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_EQ(outcome.text, "") << command;
  }
  expect_complaint(geolloyd_with("info --quiet " + in("missing.ply")), "cannot open");
}

TEST_F(ScriptHabits, JsonThatCannotBePrintedIsAnError) {
  const Outcome outcome =
      run_shell("(" GEOLLOYD_PROGRAM " quality " + mesh_.string() + " --json >/dev/full)");
  expect_complaint(outcome, "standard output: cannot write: No space left on device");
}

TEST_F(ScriptHabits, AVtpFileHasANameThatProgramsKnow) {
  const std::string relax = "relax " + mesh_.string() + " -k 8 -o " + in("result") + " --vtp ";
  for (const char* name : {"regions", "regions.ply", "regions.vtk"}) {
    expect_complaint(geolloyd_with(relax + in(name)), "give a name that ends with .vtp");
  }
  expect_complaint(geolloyd_with(relax + in("nowhere/regions.vtp")), "regions.vtp: ");
  EXPECT_EQ(geolloyd_with(relax + in("regions.vtp")).status, 0);
  EXPECT_NE(read_file(in("regions.vtp")).find("Name=\"distance\""), std::string::npos);
}

// The table in tools/commands/conventions.md; 130 is in interruption_test.cpp.
TEST_F(ScriptHabits, ExitCodesAreThoseOfTheTable) {
  const std::string mesh = mesh_.string();
  EXPECT_EQ(geolloyd_with("info " + mesh).status, 0);
  EXPECT_EQ(geolloyd_with("--help").status, 0);
  for (const std::string& wrong : std::vector<std::string>{
           "", "no-such-command", "info", "info --no-such-option " + mesh,
           "info " + in("missing.ply"), "remesh " + mesh + " -n 0 -o " + in("r.ply"),
           "remesh " + mesh + " -n 12 -o " + in("no such folder") + "/r.ply",
           "remesh " + mesh + " -n 12 -o " + in("r.xyz"), "relax " + mesh + " -k 8 -o " + mesh,
           "quality --memory-limit 1K " + mesh}) {
    EXPECT_EQ(geolloyd_with(wrong).status, 2) << wrong;
  }
}

}  // namespace
}  // namespace geolloyd

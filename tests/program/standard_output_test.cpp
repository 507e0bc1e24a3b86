// Meshes that commands write to standard output, and what else they print then.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

#include "core/formats/mesh_io.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

class StandardOutput : public Program {
 protected:
  [[nodiscard]] std::string in(const std::string& name) const { return out(name).string(); }

  // Each command that writes one mesh, but for where.
  [[nodiscard]] std::vector<std::string> commands() const {
    const std::string mesh = mesh_.string();
    return {"remesh " + mesh + " -n 12", "repair " + mesh, "subdivide " + mesh + " -s midpoint",
            "generate torus -t 500"};
  }

  // The mesh in "mesh", all else in the outcome.
  [[nodiscard]] Outcome sent(const std::string& command) const {
    return run_shell("(" GEOLLOYD_PROGRAM " " + command + " -o - >" + in("mesh") + ")");
  }

  // That a file of this name would have the same bytes.
  void expect_sent_as(const std::string& command, const std::string& format,
                      const std::string& options) const {
    const Outcome outcome = sent(command + options);
    ASSERT_EQ(outcome.status, 0) << command << "\n" << outcome.text;
    ASSERT_EQ(geolloyd_with(command + " --quiet -o " + in("file." + format)).status, 0);
    EXPECT_EQ(read_file(out("mesh")), read_file(out("file." + format))) << command << options;
  }
};

TEST_F(StandardOutput, HasTheMeshAndNothingElse) {
  for (const std::string& command : commands()) {
    expect_sent_as(command, "ply", "");
    EXPECT_NE(sent(command).text.find("standard output"), std::string::npos) << command;
    EXPECT_EQ(sent(command + " --quiet").text, "") << command;
    EXPECT_GT(fs::file_size(out("mesh")), 0U);
  }
  EXPECT_FALSE(fs::exists("-"));
}

TEST_F(StandardOutput, HasTheFormatThatIsSaid) {
  const std::string command = "subdivide " + mesh_.string() + " -s midpoint";
  for (const char* format : {"ply", "obj", "off", "stl", "glb", "gltf", "msh", "mesh", "vtp"}) {
    expect_sent_as(command, format, std::string(" --output-format ") + format);
  }
  expect_sent_as(command, "obj", " --format obj");
  expect_sent_as(command, "off", " --format obj --output-format off");
  // As a file may have one that its name does not tell.
  const std::string obj = in("file.obj");
  ASSERT_EQ(geolloyd_with(command + " -o " + obj).status, 0);
  ASSERT_EQ(geolloyd_with(command + " --output-format obj -o " + in("x.dat")).status, 0);
  EXPECT_EQ(read_file(in("x.dat")), read_file(obj));
  ASSERT_EQ(geolloyd_with(command + " --output-format ply -o " + in("x.obj")).status, 0);
  EXPECT_EQ(read_file(in("x.obj")), read_file(obj));
  expect_complaint(geolloyd_with(command + " --format obj -o " + in("y.dat")),
                   "unknown extension '.dat'");
}

TEST_F(StandardOutput, GoesThroughPipes) {
  const std::string program = GEOLLOYD_PROGRAM;
  const Outcome outcome =
      run_shell(program + " generate torus -t 2000 --quiet -o - | " + program +
                " remesh - --format ply -n 100 --quiet -o - --output-format obj | " + program +
                " info - --format obj");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("OBJ: 100 vertices"), std::string::npos) << outcome.text;
}

TEST_F(StandardOutput, HasFilesBesideIt) {
  const Outcome outcome = sent("remesh " + mesh_.string() + " -n 100 --map " + in("map.csv") +
                               " --report " + in("report.json"));
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(read(folder_.write("m.ply", read_file(out("mesh")))).mesh.vertex_count(), 100U);
  EXPECT_EQ(lines_of(out("map.csv")).size(), 101U);
  EXPECT_TRUE(fs::exists(out("report.json")));
  EXPECT_EQ(sent("repair " + mesh_.string() + " --report " + in("repair.json")).status, 0);
  EXPECT_TRUE(fs::exists(out("repair.json")));
}

TEST_F(StandardOutput, ThatNobodyReadsToItsEndIsOneLine) {
  const Outcome outcome =
      run_shell("({ " GEOLLOYD_PROGRAM
                " generate torus -t 50000 -o -; echo status $? >&2; } | head -c 10 >/dev/null)");
  EXPECT_EQ(outcome.text, "geolloyd: standard output: cannot write: Broken pipe\nstatus 2\n");
}

TEST_F(StandardOutput, ThatCannotBeWrittenIsOneLine) {
  for (const std::string& command : commands()) {
    const std::string start = "(" GEOLLOYD_PROGRAM " " + command + " -o - ";
    expect_complaint(run_shell(start + ">/dev/full)"),
                     "standard output: cannot write: No space left on device");
    expect_complaint(run_shell(start + ">&-)"),
                     "standard output: cannot write: Bad file descriptor");
    expect_complaint(run_shell(start + "--json)"), "standard output: takes the mesh or --json");
  }
}

TEST_F(StandardOutput, ThatIsATerminalGetsTextOnly) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(::grantpt(terminal), 0);
  ASSERT_EQ(::unlockpt(terminal), 0);
  const std::string name = ::ptsname(terminal);
  const auto on_terminal = [&](const std::string& options) {
    return run_shell("(" GEOLLOYD_PROGRAM " generate cube -t 12 -o - " + options + " >" + name +
                     ")");
  };
  for (const char* format : {"ply", "stl", "glb", "vtp"}) {
    expect_complaint(on_terminal(std::string("--output-format ") + format),
                     "is binary, and this is a terminal");
  }
  EXPECT_EQ(on_terminal("--quiet --output-format off").status, 0);
  ::close(terminal);
}

}  // namespace
}  // namespace geolloyd

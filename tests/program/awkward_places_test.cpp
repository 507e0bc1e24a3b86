// Places that cannot be read or written, full disks, lost output: one line and exit status 2, and
// all that was there before is there as it was, with nothing half-written beside it.
#include <map>
#include <string>

#include "core/formats/mesh_io.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"

namespace geolloyd {
namespace {

// Every file and folder below, with what a file holds. A pipe's, device's or link's name will do.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool is_plain = fs::is_regular_file(entry.symlink_status());
    found[entry.path().string()] = is_plain ? read_file(entry.path()) : "";
  }
  return found;
}

// What a user without rights runs the program by: nothing, or a way to become one. None: "".
std::string as_user() {
  if (::geteuid() != 0) return "env";
  const std::string nobody = "setpriv --reuid 65534 --regid 65534 --clear-groups";
  return run_shell(nobody + " " GEOLLOYD_PROGRAM " --version").status == 0 ? nobody : "";
}

// Commands run by sh in a folder of their own that anyone may write into. "$P" is the program.
class Places : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::permissions(folder_.path(), fs::perms::all);
  }

  [[nodiscard]] Outcome sh(const std::string& commands) const {
    return run_shell("cd '" + folder_.path().string() + "' && P='" GEOLLOYD_PROGRAM "' && { " +
                     commands + "; }");
  }

  // That `commands` end in a complaint and change nothing: not even an empty folder is left.
  void expect_untouched(const std::string& commands, const std::string& complaint) const {
    const auto before = contents(folder_.path());
    expect_complaint(sh(commands), complaint);
    EXPECT_EQ(before, contents(folder_.path()));
  }
};

struct BadPlace {
  const char* name;
  const char* before;  // makes the place
  const char* command;
  const char* complaint;

  friend void PrintTo(const BadPlace& row, std::ostream* out) { *out << row.name; }
};

class BadPlaces : public Places, public testing::WithParamInterface<BadPlace> {};

TEST_P(BadPlaces, AreAnsweredWithOneLineAndStayAsTheyWere) {
  const BadPlace& row = GetParam();
  const Outcome made = sh(row.before);
  ASSERT_EQ(made.status, 0) << made.text;
  expect_untouched(row.command, row.complaint);
}

// clang-format off
const BadPlace bad_places[] = {
    {"MissingInput", ":", "$P relax missing.ply -k 4 -o out", "missing.ply: cannot open: No such file"},
    {"InputIsAFolder", "mkdir a.ply", "$P relax a.ply -k 4 -o out", "a.ply: cannot read: Is a directory"},
    {"InputIsBelowAFile", ":", "$P relax torus.ply/a.ply -k 4 -o out", "cannot open: Not a directory"},
    {"InputLinksToItself", "ln -s a.ply a.ply", "$P relax a.ply -k 4 -o out", "a.ply: cannot open"},
    {"InputIsADevice", "ln -s /dev/zero a.ply", "$P info a.ply", "a.ply: cannot read: a device"},
    {"InputIsAnEmptyPipe", "mkfifo a.ply", "{ : > a.ply & } ; $P info a.ply", "a.ply: byte 0: the file is empty"},
    {"SeedsAreADevice", ":", "$P relax torus.ply --seeds-file /dev/zero -o out", "/dev/zero: cannot read: a device"},
    {"SeedsAreAFolder", ":", "$P relax torus.ply --seeds-file . -o out", "cannot read: Is a directory"},
    {"FieldIsMissing", ":", "$P relax torus.ply -k 4 --vfield no.vfield -o out", "no.vfield: cannot open"},
    {"FieldIsADevice", ":", "$P render torus.ply --panel field --vfield /dev/zero -o a.png", "/dev/zero: cannot read: a device"},
    {"OriginalIsAFolder", "mkdir a.ply", "$P quality torus.ply --original a.ply -o a.json", "a.ply: cannot read: Is a directory"},
    {"OutputIsAFile", "touch out", "$P relax torus.ply -k 4 -o out", "out: cannot make folder"},
    {"OutputIsBelowAFile", "touch out", "$P relax torus.ply -k 4 -o out/deeper", "cannot make folder: Not a directory"},
    {"OutputIsBelowADevice", ":", "$P relax torus.ply -k 4 -o /dev/null/deeper", "cannot make folder"},
    {"OutputLinksNowhere", "ln -s no/where out", "$P relax torus.ply -k 4 -o out", "out: cannot make folder"},
    {"NameTooLong", ":", "$P relax torus.ply -k 4 -o $(printf %0300d 0)", "cannot open: File name too long"},
    {"NameOfResumedTooLong", ":", "$P relax torus.ply -k 4 --resume -o $(printf %0300d 0)", "cannot open: File name too long"},
    {"NameOfComparedTooLong", ":", "$P compare torus.ply -k 4 -o $(printf %0300d 0)", "cannot make folder: File name too long"},
    {"NothingToResume", "mkdir out", "$P relax torus.ply -k 4 --resume -o out", "out/checkpoint.msgpack: no such checkpoint"},
    {"UnfinishedRun", "mkdir out; echo x > out/checkpoint.msgpack", "$P relax no.ply -k 4 -o out", "out/checkpoint.msgpack: is of an unfinished run: go on with --resume, or remove it"},
    {"ResultOverItsSeeds", "$P relax torus.ply -k 4 -o out >log", "$P relax torus.ply --seeds-file out/seeds.csv -o out", "out/seeds.csv: would be overwritten"},
    {"OutputFileIsAFolder", "mkdir -p out/report.json", "$P relax torus.ply -k 4 -o out", "out/report.json: cannot write: Is a directory"},
    {"OutputFileIsADevice", "mkdir out; ln -s /dev/full out/seeds.csv", "$P relax torus.ply -k 4 -o out", "out/seeds.csv: cannot write: not a regular file"},
    {"OutputFileIsAPipe", "mkfifo a.png", "$P render torus.ply -o a.png", "a.png: cannot write: not a regular file"},
    {"OutputFileIsFolderOfCompare", "mkdir -p out/compare.json", "$P compare torus.ply -k 4 -o out", "out/compare.json: cannot write"},
    {"OutputFileIsFolderOfProfile", "mkdir -p out/profile.csv", "$P profile torus.ply -k 4 -o out", "out/profile.csv: cannot write"},
    {"OutputFileIsFolderOfBatch", "mkdir -p out/batch.json", "$P batch torus.ply -k 4 -o out", "out/batch.json: cannot write"},
    {"OutputFileIsFolderOfGroundTruth", "mkdir -p out/ground-truth.json", "$P ground-truth torus.ply -k 4 -o out", "out/ground-truth.json: cannot write"},
    {"PictureInNoFolder", ":", "$P relax torus.ply -k 4 -o out --picture no/a.png", "no/a.png: cannot write: No such file"},
    {"NameOfPictureTooLong", ":", "$P relax torus.ply -k 4 -o out --picture $(printf %0300d 0)", "cannot write: File name too long"},
    {"PictureIsAResult", ":", "$P relax torus.ply -k 4 -o out --picture out/report.json", "would be overwritten"},
    {"PictureIsTheMesh", ":", "$P render torus.ply -o ./torus.ply", "would be overwritten"},
    {"PictureIsTheSeeds", "echo 0 > seeds", "$P relax torus.ply --seeds-file seeds -o out --picture seeds", "would be overwritten"},
    {"PictureAmongTheFrames", ":", "$P relax torus.ply -k 4 -o out --frames . --picture 000-greedy.png", "is in the folder of the frames"},
    {"FramesOfAnotherRun", "mkdir f; echo x > f/000-greedy.png", "$P relax torus.ply -k 4 -o out --frames f", "f/000-greedy.png: is a frame of another run"},
    {"FramesInAFile", "touch f", "$P relax torus.ply -k 4 -o out --frames f", "f: cannot make folder"},
    {"ResultOverItsMesh", "mkdir out; cp torus.ply out/tessellation.ply", "$P relax out/tessellation.ply -k 4 -o out", "would be overwritten"},
    {"ResultOverItsMeshByALink", "mkdir out; ln torus.ply out/dual.ply", "$P relax torus.ply -k 4 -o out", "would be overwritten"},
    {"ResultOverItsField", "{ echo k1; for i in $(seq 1000); do echo 1 1 1 0 0 0 1 0; done; } > seeds.csv", "$P relax torus.ply -k 4 --vfield seeds.csv -o .", "would be overwritten"},
    {"FinerMeshOverItsMesh", ":", "$P subdivide torus.ply -s midpoint -o torus.ply", "torus.ply: would be overwritten"},
    {"FinerMeshOverItsMeshByALink", "ln -s torus.ply a.ply", "$P subdivide a.ply -s midpoint -o torus.ply", "a.ply: would be overwritten"},
    {"IssuesOverTheirFigures", ":", "$P quality torus.ply -o a.json --issues a.json", "a.json: would be overwritten"},
    {"IssuesOverTheirMesh", ":", "$P repair torus.ply -o a.ply --issues torus.ply", "torus.ply: would be overwritten"},
    {"FiguresOverTheirMesh", ":", "$P quality torus.ply -o torus.ply", "torus.ply: would be overwritten"},
    {"TableOverItsSeeds", "echo 0 > compare.csv", "$P compare torus.ply --seeds-file compare.csv -o .", "would be overwritten"},
    {"FullForRelax", ":", "ulimit -f 16; $P relax torus.ply -k 4 -o out", "cannot write: File too large"},
    {"FullForRelaxInNewFolders", "mkdir a", "ulimit -f 16; $P relax torus.ply -k 4 -o a/new/out", "cannot write: File too large"},
    {"FullForAnotherRelax", "$P relax torus.ply -k 9 -o out >log", "ulimit -f 16; $P relax torus.ply -k 4 -o out", "cannot write: File too large"},
    {"FullForTheReportOnly", "$P generate torus -t 20 -o a.ply && $P relax a.ply -k 9 -o out", "ulimit -f 8; $P relax a.ply -k 4 -o out", "out/report.json: cannot write: File too large"},
    {"FullForFrames", ":", "ulimit -f 2; $P relax torus.ply -k 4 -o out --frames f --size 200", "f/000-precise.png: cannot write: File too large"},
    {"FullForRender", ":", "ulimit -f 2; $P render torus.ply -o a.png --size 200", "a.png: cannot write: File too large"},
    {"FullForGenerate", ":", "ulimit -f 16; $P generate torus -t 2000 -o a.ply", "a.ply: cannot write: File too large"},
    {"FullForSubdivide", ":", "ulimit -f 16; $P subdivide torus.ply -s midpoint -o a.stl", "a.stl: cannot write: File too large"},
    {"FullForQuality", ":", "ulimit -f 1; $P quality torus.ply -o a.json", "a.json: cannot write: File too large"},
    {"FullForGroundTruth", ":", "ulimit -f 8; $P ground-truth torus.ply -k 4 -o out", "cannot write: File too large"},
    {"FullForCompare", ":", "ulimit -f 1; $P compare torus.ply -k 4 --turns 1 -o out", "cannot write: File too large"},
    {"FullForProfile", ":", "ulimit -f 1; $P profile torus.ply -k 4 -o out", "cannot write: File too large"},
    {"FullForBatch", ":", "ulimit -f 1; $P batch torus.ply -k 4 --batches 1 --graphs vertex -o out", "cannot write: File too large"},
    {"RemeshOverItsMesh", ":", "$P remesh torus.ply -n 40 -o ./torus.ply", "torus.ply: would be overwritten"},
    {"RemeshOverItsMeshByALink", "ln -s torus.ply a.ply", "$P remesh a.ply -n 40 -o torus.ply", "a.ply: would be overwritten"},
    {"MapOverItsMesh", ":", "$P remesh torus.ply -n 40 -o r.ply --map torus.ply", "torus.ply: would be overwritten"},
    {"ReportOverItsRemesh", ":", "$P remesh torus.ply -n 40 -o r.ply --report ./r.ply", "r.ply: would be overwritten"},
    {"ReportOverItsMap", ":", "$P remesh torus.ply -n 40 -o r.ply --map a --report a", "a: would be overwritten"},
    {"PictureOverItsReport", ":", "$P remesh torus.ply -n 40 -o r.ply --report a --picture a", "a: would be overwritten"},
    {"RemeshIsAFolder", "mkdir r.ply", "$P remesh torus.ply -n 40 -o r.ply", "r.ply: cannot write: Is a directory"},
    {"RemeshInNoFolder", ":", "$P remesh no.ply -n 40 -o no/r.ply", "no/r.ply: cannot write: No such file"},
    {"MapInNoFolder", ":", "$P remesh no.ply -n 40 -o r.ply --map no/a.csv", "no/a.csv: cannot write: No such file"},
    {"ReportInNoFolder", ":", "$P remesh no.ply -n 40 -o r.ply --report no/a.json", "no/a.json: cannot write: No such file"},
    {"PictureOfRemeshInNoFolder", ":", "$P remesh no.ply -n 40 -o r.ply --picture no/a.png", "no/a.png: cannot write: No such file"},
    {"MapIsADevice", ":", "$P remesh torus.ply -n 40 -o r.ply --map /dev/full", "/dev/full: cannot write: not a regular file"},
    {"FullForRemesh", ":", "ulimit -f 2; $P remesh torus.ply -n 400 -o r.ply", "r.ply: cannot write: File too large"},
    {"FullForTheReportOfRemesh", ":", "ulimit -f 8; $P remesh torus.ply -n 40 -o r.ply --report a.json", "a.json: cannot write: File too large"},
    {"FullForTheSummary", ":", "$P info torus.ply >/dev/full", "standard output: cannot write: No space left on device"},
    {"FullForALongTable", ":", "$P batch torus.ply -k 4 --batches 1 --max-macrosteps 1 >/dev/full", "standard output: cannot write"},
    {"FullForHelp", ":", "$P relax --help >/dev/full", "standard output: cannot write"},
    {"SummaryIntoAClosedStream", ":", "$P info torus.ply >&-", "standard output: cannot write: Bad file descriptor"},
};
// clang-format on

INSTANTIATE_TEST_SUITE_P(All, BadPlaces, testing::ValuesIn(bad_places),
                         [](const auto& row) { return std::string(row.param.name); });

struct ForbiddenPlace {
  const char* name;
  const char* before;
  const char* command;  // "$U" before the program makes it that of a user without rights
  const char* complaint;

  friend void PrintTo(const ForbiddenPlace& row, std::ostream* out) { *out << row.name; }
};

class ForbiddenPlaces : public Places, public testing::WithParamInterface<ForbiddenPlace> {
 protected:
  void TearDown() override { (void)sh("chmod -R u+rwX ."); }
};

TEST_P(ForbiddenPlaces, AreAnsweredWithOneLineAndStayAsTheyWere) {
  const std::string user = as_user();
  if (user.empty()) GTEST_SKIP() << "cannot become a user without rights who may run the program";
  const ForbiddenPlace& row = GetParam();
  ASSERT_EQ(sh(row.before).status, 0);
  const Outcome outcome = sh("U='" + user + "'; " + row.command);
  EXPECT_EQ(sh("chmod -R u+rwX .").status, 0);
  expect_complaint(outcome, row.complaint);
  for (const auto& [path, bytes] : contents(folder_.path())) {
    EXPECT_EQ(path.find(".part"), std::string::npos);
    EXPECT_EQ(path.find("report.json"), std::string::npos);
  }
}

// clang-format off
const ForbiddenPlace forbidden_places[] = {
    {"UnreadableInput", "cp torus.ply a.ply; chmod 0 a.ply", "$U $P relax a.ply -k 4 -o out", "a.ply: cannot open: Permission denied"},
    {"InputInAClosedFolder", "mkdir a; cp torus.ply a; chmod 0 a", "$U $P info a/torus.ply", "a/torus.ply: cannot open: Permission denied"},
    {"UnreadableSeeds", "echo 0 > s; chmod 0 s", "$U $P relax torus.ply --seeds-file s -o out", "s: cannot open: Permission denied"},
    {"ResumedInAClosedFolder", "mkdir out; touch out/checkpoint.msgpack; chmod 0 out", "$U $P relax torus.ply -k 4 --resume -o out", "out/checkpoint.msgpack: cannot open: Permission denied"},
    {"OutputInAClosedFolder", "mkdir out; chmod 0 out", "$U $P relax torus.ply -k 4 -o out", "out/checkpoint.msgpack: cannot open: Permission denied"},
    {"ReadOnlyOutputFolder", "mkdir out; chmod 555 out", "$U $P relax torus.ply -k 4 -o out", "out/tessellation.ply: cannot write: Permission denied"},
    {"FolderInAReadOnlyFolder", "mkdir a; chmod 555 a", "$U $P relax torus.ply -k 4 -o a/out", "a/out: cannot make folder: Permission denied"},
    {"PictureInAReadOnlyFolder", "mkdir a; chmod 555 a", "$U $P relax torus.ply -k 4 -o out --picture a/a.png", "a/a.png: cannot write: Permission denied"},
    {"MeshInAReadOnlyFolder", "mkdir a; chmod 555 a", "$U $P generate torus -t 100000000 -o a/a.ply", "a/a.ply: cannot write: Permission denied"},
    {"FramesThatCannotBeListed", "mkdir f; chmod 333 f", "$U $P relax torus.ply -k 4 -o out --frames f", "f: cannot read: Permission denied"},
};
// clang-format on

INSTANTIATE_TEST_SUITE_P(All, ForbiddenPlaces, testing::ValuesIn(forbidden_places),
                         [](const auto& row) { return std::string(row.param.name); });

// A real one, where the system lets us mount it. 16 KB hold some of the files and not all.
TEST_F(Places, AFullDiskKeepsWhatItHad) {
  const std::string mount =
      "unshare -rm sh -c 'mkdir disk; mount -t tmpfs -o size=64k none disk && cd disk && ";
  if (sh(mount + "true'").status != 0) GTEST_SKIP() << "not allowed to mount a file system";
  const Outcome outcome = sh("export P; " + mount +
                             "echo kept > old && $P relax ../torus.ply -k 4 -o out;"
                             "echo status $?; find . | sort; cat old'");
  EXPECT_NE(outcome.text.find("cannot write: No space left on device\nstatus 2\n.\n./old\nkept\n"),
            std::string::npos)
      << outcome.text;
}

// Nothing that is printed may end in a file that took the number of a closed stream.
TEST_F(Places, ClosedStreamsSpoilNoFile) {
  ASSERT_EQ(relax("--seeds 20").status, 0);
  EXPECT_EQ(sh("$P relax torus.ply -k 20 -o closed <&- >&- 2>&-").status, 2);
  for (const char* name : {"tessellation.ply", "seeds.csv", "regions.csv", "dual.ply"}) {
    EXPECT_EQ(read_file(out("closed") / name), read_file(out() / name)) << name;
  }
}

TEST_F(Places, ALostSummaryLosesNoResult) {
  expect_complaint(sh("$P relax torus.ply -k 20 -o out >/dev/full"), "standard output: ");
  EXPECT_EQ(lines_of(out() / "seeds.csv").size(), 21U);
  EXPECT_TRUE(fs::exists(out() / "report.json"));
  (void)sh("$P relax torus.ply -k 20 -o pipe | true");
  EXPECT_TRUE(fs::exists(out("pipe") / "report.json"));
}

TEST_F(Places, ALostPictureLosesNoResult) {
  ASSERT_EQ(relax("--seeds 20", "whole").status, 0);
  expect_complaint(sh("ulimit -f 120; $P relax torus.ply -k 20 -o out --picture a.png --size 600"),
                   "a.png: cannot write: File too large");
  EXPECT_FALSE(fs::exists(folder_.path() / "a.png"));
  EXPECT_TRUE(fs::exists(out() / "report.json"));
  for (const char* name : {"tessellation.ply", "seeds.csv", "regions.csv", "dual.ply"}) {
    EXPECT_EQ(read_file(out() / name), read_file(out("whole") / name)) << name;
  }
}

TEST_F(Places, APictureMayHaveTheLongestNameThereCanBe) {
  const std::string name(255, 'x');
  EXPECT_EQ(sh("$P relax torus.ply -k 4 -o out --size 64 --picture " + name).status, 0);
  EXPECT_NE(read_file(folder_.path() / name).find("IEND"), std::string::npos);
}

TEST_F(Places, APipeIsAsGoodAsAFile) {
  const Outcome outcome = sh("mkfifo a.ply; { cat torus.ply > a.ply & }; $P info a.ply");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("2,000 triangles"), std::string::npos) << outcome.text;
}

// A file that may not be written, in a folder that may, is replaced: it is the folder's to say.
TEST_F(Places, AReadOnlyFileIsReplaced) {
  EXPECT_EQ(sh("$P relax torus.ply -k 9 -o out >log && chmod 444 out/* && "
               "$P relax torus.ply -k 20 -o out")
                .status,
            0);
  EXPECT_EQ(lines_of(out() / "seeds.csv").size(), 21U);
}

TEST_F(Places, ResultsKeepTheirModesAndLinks) {
  const Outcome outcome =
      sh("$P relax torus.ply -k 9 -o out >log && chmod 640 out/* && mkdir far && "
         "for f in seeds.csv report.json; do mv out/$f far; ln -s ../far/$f out; done; "
         "$P relax torus.ply -k 20 -o out >log && stat -L -c %a out/* | uniq && "
         "stat -c %F out/seeds.csv out/report.json | uniq && ls out far | wc -w");
  EXPECT_EQ(outcome.text, "640\nsymbolic link\n9\n");
  EXPECT_EQ(lines_of(folder_.path() / "far" / "seeds.csv").size(), 21U);
}

TEST_F(Places, NamesOfFoldersMayHoldAnything) {
  for (const std::string name : {"là bas", "two\nlines", "not \xff utf-8", "-dash", "a'b"}) {
    const fs::path folder = folder_.path() / name;
    Outcome outcome = sh("$P relax torus.ply -k 4 -o \"" + folder.string() + "\"");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(lines_of(folder / "seeds.csv").size(), 5U);
    outcome =
        sh("$P relax torus.ply --seeds-file \"" + (folder / "seeds.csv").string() + "\" -o again");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
  }
}

// Numbers are read and written with a point, wherever the user lives.
TEST_F(Places, ADecimalCommaChangesNothing) {
  const std::string german = "LOCPATH=$PWD LC_ALL=de_DE.UTF-8 ";
  const Outcome made = sh("localedef -i de_DE -f UTF-8 ./de_DE.UTF-8");
  const Outcome comma = sh(german + "locale decimal_point");
  if (comma.text != ",\n") GTEST_SKIP() << "no locale with a decimal comma: " << made.text;
  ASSERT_EQ(relax("--seeds 20").status, 0);
  ASSERT_EQ(sh(german + "$P subdivide torus.ply -s midpoint -o fine.obj").status, 0);
  ASSERT_EQ(sh("$P subdivide torus.ply -s midpoint -o plain.obj").status, 0);
  EXPECT_EQ(read_file(folder_.path() / "fine.obj"), read_file(folder_.path() / "plain.obj"));
  const Outcome outcome = sh(german + "$P relax torus.ply -k 20 -o german");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  for (const char* name : {"tessellation.ply", "seeds.csv", "regions.csv", "dual.ply"}) {
    EXPECT_EQ(read_file(out("german") / name), read_file(out() / name)) << name;
  }
  EXPECT_EQ(sh(german + "$P relax torus.ply --seeds-file german/seeds.csv -o again").status, 0);
}

}  // namespace
}  // namespace geolloyd

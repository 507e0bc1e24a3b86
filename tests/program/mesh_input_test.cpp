// Meshes that come packed, through standard input or under names that do not tell what they are.
#include "core/formats/mesh_io.h"
#include "core/text/file_writer.h"
#include "tests/support/program.h"
#include "tests/support/sanitizers.h"

namespace geolloyd {
namespace {

class MeshInput : public Program {
 protected:
  // The torus under another name, and so in another format.
  [[nodiscard]] fs::path torus_as(const char* name) const {
    write(out(name), read(mesh_).mesh);
    return out(name);
  }

  [[nodiscard]] std::string subdivided(const std::string& input, const std::string& options,
                                       const char* name) const {
    const Outcome outcome = geolloyd_with("subdivide " + options + " -s midpoint -o " +
                                          out(name).string() + " " + input);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return read_file(out(name));
  }
};

TEST_F(MeshInput, MayBePackedOrComeThroughStandardInput) {
  const std::string expected = subdivided(mesh_.string(), "", "from_file.ply");
  for (const char* name : {"t.ply.gz", "t.ply.zst"}) {
    const std::string packed = torus_as(name).string();
    EXPECT_EQ(subdivided(packed, "", "from_packed.ply"), expected);
    EXPECT_EQ(subdivided("< " + packed, "- --format ply", "from_stream.ply"), expected);
  }
  EXPECT_EQ(subdivided("< " + mesh_.string(), "- --format ply", "from_stream.ply"), expected);
  const Outcome piped =
      run_shell("cat " + mesh_.string() + " | " + GEOLLOYD_PROGRAM + " info - --format ply");
  EXPECT_EQ(piped.status, 0) << piped.text;
}

TEST_F(MeshInput, OfAnyNameHasTheFormatThatIsSaid) {
  const fs::path other = out("torus.dat");
  fs::copy_file(mesh_, other);
  const std::string name = other.string();
  EXPECT_EQ(geolloyd_with("info " + name + " --format ply").status, 0);
  expect_complaint(geolloyd_with("info " + name), "unknown extension '.dat'");
  // What a name tells is not changed.
  EXPECT_EQ(geolloyd_with("info " + mesh_.string() + " --format obj").status, 0);
}

TEST_F(MeshInput, FromStandardInputIsRefusedInOneLine) {
  const std::string file = mesh_.string();
  expect_complaint(geolloyd_with("info - < " + file), "standard input: say what it is");
  expect_complaint(geolloyd_with("info - --format obj < " + file), "standard input: ");
  expect_complaint(geolloyd_with("info - --format ply < /dev/null"),
                   "standard input: cannot read: a device, not a file");
  expect_complaint(geolloyd_with("info - --format ply < " + folder_.path().string()),
                   "standard input: cannot read: Is a directory");
  expect_complaint(geolloyd_with("info - --format ply <&-"), "standard input: cannot read");
}

TEST_F(MeshInput, ThatUnpacksToMoreThanTheMemoryLimitEndsInOneLine) {
  if (under_sanitizer) GTEST_SKIP();
  for (const char* name : {"bomb.ply.gz", "bomb.ply.zst"}) {
    FileWriter bomb(out(name));
    const std::string zeros(1'000'000, '0');
    for (int i = 0; i < 400; ++i) bomb.text(zeros);
    bomb.commit();
    EXPECT_LT(fs::file_size(out(name)), 1'000'000U);
    expect_complaint(geolloyd_with("info --memory-limit 100M " + out(name).string()),
                     "more than the 100000000 bytes that are allowed");
  }
}

TEST_F(MeshInput, OfAFolderMayBePacked) {
  fs::create_directory(out("meshes"));
  ASSERT_EQ(geolloyd_with("generate torus -t 200 -o " + mesh_.string()).status, 0);
  (void)torus_as("meshes/a.ply.gz");
  (void)torus_as("meshes/b.off.zst");
  const std::string start = "remesh-all " + out("meshes").string() + " --vertices 12 -o ";
  const Outcome same = geolloyd_with(start + out("same").string());
  EXPECT_EQ(same.status, 0) << same.text;
  EXPECT_EQ(read(out("same") / "a.ply.gz").mesh.positions,
            read(out("same") / "b.off.zst").mesh.positions);
  const Outcome other = geolloyd_with(start + out("other").string() + " --format obj");
  EXPECT_EQ(other.status, 0) << other.text;
  EXPECT_TRUE(fs::exists(out("other") / "a.obj"));
  EXPECT_TRUE(fs::exists(out("other") / "b.obj"));
}

}  // namespace
}  // namespace geolloyd

// The pictures of the whole program.
#include <string>

#include "tests/support/program.h"

namespace geolloyd {
namespace {

class Pictures : public Program {
 protected:
  [[nodiscard]] Outcome render(const std::string& options) const {
    return geolloyd_with("render " + mesh_.string() + " -o " + png().string() + " " + options);
  }

  [[nodiscard]] fs::path png() const { return folder_.path() / "p.png"; }

  // Width and height, from the file's header; that it is whole, from its end.
  static std::pair<unsigned, unsigned> size_of(const fs::path& path) {
    const std::string bytes = read_file(path);
    const auto number_at = [&](std::size_t place) {
      unsigned number = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        number = number << 8 | static_cast<unsigned char>(bytes.at(place + i));
      }
      return number;
    };
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
    return {number_at(16), number_at(20)};
  }
};

TEST_F(Pictures, AreAsLargeAsWasAsked) {
  EXPECT_EQ(render("--size 200x100").status, 0);
  EXPECT_EQ(size_of(png()), (std::pair{200U, 100U}));
  EXPECT_EQ(render("--size 200 --view front").status, 0);
  EXPECT_EQ(size_of(png()).first, 200U);
  EXPECT_NEAR(size_of(png()).second, 200, 8);  // a torus about the shortest side
}

TEST_F(Pictures, ShowSeveralPanelsOfAllGraphs) {
  for (const std::string graph : {"vertex", "triangle-dense", "mixed"}) {
    const Outcome outcome =
        render("--seeds 9 --size 400x300 --panel surface --panel mesh -g " + graph +
               " --panel 'trees=Bäume' --panel regions= --panel ground-truth");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(outcome.text, "");
    EXPECT_EQ(size_of(png()), (std::pair{400U, 300U}));
  }
}

TEST_F(Pictures, HaveTheCameraOfAnotherMesh) {
  const std::string other = (folder_.path() / "other.ply").string();
  ASSERT_EQ(geolloyd_with("generate cube -t 300 -o " + other).status, 0);
  ASSERT_EQ(render("--size 200").status, 0);
  const std::string own = read_file(png());
  ASSERT_EQ(render("--size 200 --view-of " + mesh_.string()).status, 0);
  EXPECT_EQ(read_file(png()), own);
  ASSERT_EQ(geolloyd_with("render " + other + " --size 200 -o " + png().string()).status, 0);
  const auto size = size_of(png());
  ASSERT_EQ(render("--size 200 --view-of " + other).status, 0);
  EXPECT_EQ(size_of(png()), size);
  EXPECT_NE(read_file(png()), own);
  expect_complaint(render("--view-of no.ply"), "no.ply: cannot open");
  expect_complaint(
      geolloyd_with("render " + mesh_.string() + " -o " + other + " --view-of " + other),
      "would be overwritten");
}

// The same as `render` of the remesh with the camera of the mesh.
TEST_F(Pictures, OfARemeshHaveTheCameraOfItsMesh) {
  const std::string remesh = (folder_.path() / "r.ply").string();
  const std::string after = (folder_.path() / "after.png").string();
  ASSERT_EQ(geolloyd_with("remesh " + mesh_.string() + " -n 300 --size 200 -o " + remesh +
                          " --picture " + after)
                .status,
            0);
  ASSERT_EQ(geolloyd_with("render " + remesh + " --panel mesh --size 200 --view-of " +
                          mesh_.string() + " -o " + png().string())
                .status,
            0);
  EXPECT_EQ(read_file(png()), read_file(after));
}

TEST_F(Pictures, RefuseWhatMakesNoSense) {
  expect_complaint(render("--panel regions"), "how many regions?");
  expect_complaint(render("--panel field"), "which field?");
  expect_complaint(render("--panel nothing"), "give one of surface, mesh");
  expect_complaint(render("--size 0x0"), "--size 0x0: give WIDTH");
  expect_complaint(render("--size 1e9x1e9"), "--size 1e9x1e9: give WIDTH");
  expect_complaint(render("--view upwards"), "--view upwards: give front");
  expect_complaint(render("--panel 'mesh=\xff'"), "UTF-8");
  expect_complaint(geolloyd_with("render " + mesh_.string() + " -o /nowhere/p.png"),
                   "/nowhere/p.png: cannot write");
  const std::string before = read_file(mesh_);
  expect_complaint(geolloyd_with("render " + mesh_.string() + " -o " + mesh_.string()),
                   "would be overwritten");
  EXPECT_EQ(read_file(mesh_), before);
  EXPECT_FALSE(fs::exists(png()));
  expect_complaint(relax("--seeds 4 --view upwards"), "--view upwards: give front");
}

TEST_F(Pictures, AreDrawnOfEveryStep) {
  const std::string options = "--seeds 5 --init random --size 128 --frames " + out("film").string();
  const Outcome outcome = relax(options);
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_TRUE(fs::exists(out("film") / "000-greedy.png"));
  const auto frames = std::distance(fs::directory_iterator(out("film")), fs::directory_iterator());
  EXPECT_NE(outcome.text.find(std::to_string(frames) + " frames"), std::string::npos);
  EXPECT_EQ(size_of(out("film") / "000-greedy.png").first, 128U);
  expect_complaint(relax(options), "is a frame of another run");
  EXPECT_EQ(relax("--seeds 5 --init random", "plain").status, 0);
  EXPECT_EQ(lines_of(out("plain") / "seeds.csv"), lines_of(out() / "seeds.csv"));
}

}  // namespace
}  // namespace geolloyd

#include "tools/view/session/session_model.h"

#include <gtest/gtest.h>

#include <set>

#include "geolloyd/errors.h"
#include "tests/view/bundle_reader.h"
#include "tests/view/session_fixture.h"

namespace geolloyd {
namespace {

class SessionModelTest : public SessionFixture {
 protected:
  [[nodiscard]] std::vector<InputId> seed_ids() const {
    std::vector<InputId> ids;
    for (const NodeId s : model_->tessellation().seeds()) {
      ids.push_back(model_->tessellation().start().mesh_graph.input_id[s]);
    }
    return ids;
  }

  // An id that is no seed.
  [[nodiscard]] InputId free_id() const {
    const std::vector<InputId> ids = seed_ids();
    const std::set<InputId> taken(ids.begin(), ids.end());
    InputId id = 0;
    while (taken.count(id) != 0) ++id;
    return id;
  }
};

TEST_F(SessionModelTest, ARunHasTheFingerprintOfTheCommand) {
  open(torus(600, 1), 12);
  expect_reproducible();  // before the first step
  run();
  EXPECT_EQ(state()["phase"], "done");
  EXPECT_EQ(state()["command_line"].get<std::string>().find("--max"), std::string::npos);
  expect_reproducible();
}

TEST_F(SessionModelTest, SoHasEachStopOnTheWay) {
  open(torus(600, 1), 12);
  run(1);
  expect_reproducible();  // in the greedy phase
  perform(R"({"do":"macrostep"})");
  EXPECT_EQ(state()["phase"], "precise");
  expect_reproducible();
  EXPECT_THROW(perform(R"({"do":"greedy_step"})"), InvalidInput);
  run();
  expect_reproducible();
}

TEST_F(SessionModelTest, SoHaveOtherOptions) {
  open(torus(600, 1), 12);
  for (const char* command :
       {R"({"do":"set","graph":"mixed","seed_count":9})",
        R"({"do":"set","field":"curvature","init":"farthest","greedy":"auto"})",
        R"({"do":"set","graph":"triangle-dense","norm":"linf","field":"cross","random_seed":5})"}) {
    SCOPED_TRACE(command);
    perform(command);
    EXPECT_EQ(state()["step"], 0);
    run(3);
    expect_reproducible();
  }
}

TEST_F(SessionModelTest, SoHaveSeedsThatWereEdited) {
  open(torus(600, 1), 12, GreedyMode::off);
  run(1);
  perform(R"({"do":"add_seed","id":)" + std::to_string(free_id()) + "}");
  perform(R"({"do":"move_seed","region":3,"id":)" + std::to_string(free_id()) + "}");
  perform(R"({"do":"remove_seed","region":0})");
  EXPECT_EQ(state()["seeds"], 12);
  EXPECT_EQ(state()["step"], 0);
  run();
  perform(R"({"do":"save","what":"result"})");
  expect_reproducible();
  const Json report = Json::parse(read_file(output_ / "report.json"));
  EXPECT_EQ(report["fingerprint"], state()["fingerprint"]);
  perform(R"({"do":"reset"})");
  EXPECT_EQ(state()["seeds"], 12);
  expect_reproducible();
}

TEST_F(SessionModelTest, SeedsGoWhereTheyAreMoved) {
  open(icosphere(500), 8);
  const std::vector<InputId> before = seed_ids();
  const InputId id = free_id();
  perform(R"({"do":"move_seed","region":2,"id":)" + std::to_string(id) + "}");
  std::vector<InputId> expected = before;
  expected[2] = id;
  EXPECT_EQ(seed_ids(), expected);
  const InputId other = free_id();
  perform(R"({"do":"add_seed","id":)" + std::to_string(other) + "}");
  expected.push_back(other);
  EXPECT_EQ(seed_ids(), expected);
  perform(R"({"do":"remove_seed","region":1})");
  expected[1] = expected.back();
  expected.pop_back();
  EXPECT_EQ(seed_ids(), expected);
  perform(R"({"do":"set","graph":"vertex-dense"})");  // the same vertices
  EXPECT_EQ(seed_ids(), expected);
  perform(R"({"do":"choose_seeds"})");
  EXPECT_EQ(seed_ids(), before);
}

TEST_F(SessionModelTest, MicrostepsAddUpToTheMacrostep) {
  open(torus(2000, 1), 10, GreedyMode::off);
  perform(R"({"do":"macrostep"})");
  const std::vector<InputId> after = seed_ids();
  const Json fingerprint = state()["fingerprint"];
  perform(R"({"do":"reset"})");
  std::size_t microsteps = 0;
  do {
    const std::vector<InputId> before = seed_ids();
    perform(R"({"do":"microstep"})");
    ++microsteps;
    ASSERT_LT(microsteps, 1000U);
    EXPECT_NE(seed_ids(), before);
    EXPECT_EQ(state()["fingerprint"].is_null(), state()["step"] == 0);
  } while (state()["step"] == 0);
  EXPECT_GT(microsteps, 1U);
  EXPECT_EQ(seed_ids(), after);
  EXPECT_EQ(state()["fingerprint"], fingerprint);
  perform(R"({"do":"microstep"})");
  perform(R"({"do":"macrostep"})");  // the rest of it
  EXPECT_EQ(state()["step"], 2);
}

TEST_F(SessionModelTest, WhatCannotBeDoneChangesNothing) {
  open(torus(600, 1), 12);
  run(2);
  const std::string taken = std::to_string(seed_ids().front());
  const Json before = facts();
  for (const std::string& command : {
           std::string(R"({"do":"add_seed","id":4000000000})"),
           R"({"do":"add_seed","id":)" + taken + "}",
           std::string(R"({"do":"move_seed","region":4000000000,"id":0})"),
           R"({"do":"move_seed","region":0,"id":)" + taken + "}",
           std::string(R"({"do":"remove_seed","region":12})"),
           std::string(R"({"do":"set","graph":"hexagons"})"),
           std::string(R"({"do":"set","graph":3})"),
           std::string(R"({"do":"set","colour":"red"})"),
           std::string(R"({"do":"set","field":"/etc/passwd"})"),
           std::string(R"({"do":"set","seed_count":0})"),
           std::string(R"({"do":"set","seed_count":4294967295})"),
           std::string(R"({"do":"set","seed_count":2.5})"),
           std::string(R"({"do":"set","random_seed":-1})"),
           std::string(R"({"do":"set","norm":"linf","seed_count":"all"})"),
       }) {
    SCOPED_TRACE(command);
    EXPECT_THROW(perform(command), InvalidInput);
    EXPECT_EQ(facts(), before);
  }
}

TEST_F(SessionModelTest, AComponentKeepsASeed) {
  Mesh two = icosphere(80);
  const Mesh one = two;
  const auto first = static_cast<VertexId>(one.vertex_count());
  for (const Vec3& p : one.positions) two.positions.emplace_back(p + Vec3(5, 0, 0));
  for (const auto& [a, b, c] : one.triangles) {
    two.triangles.push_back({a + first, b + first, c + first});
  }
  open(two, 2);
  const Json before = facts();
  EXPECT_THROW(perform(R"({"do":"remove_seed","region":0})"), InvalidInput);
  const InputId other = seed_ids()[0] < first ? first + 1 : 1;
  EXPECT_THROW(perform(R"({"do":"move_seed","region":0,"id":)" + std::to_string(other) + "}"),
               InvalidInput);
  EXPECT_EQ(facts(), before);
}

TEST_F(SessionModelTest, ARemeshHasTheFingerprintOfTheCommand) {
  open(torus(2000, 1), 5);
  perform(R"({"do":"remesh","vertices":60})");
  const Json remesh = state()["remesh"];
  EXPECT_GE(remesh["vertices"], 60);
  EXPECT_EQ(remesh["fingerprint"], fingerprint_of(remesh["command_line"]));
  perform(R"({"do":"save","what":"result"})");
  EXPECT_EQ(read_file(output_ / "remesh.ply"), read_file(folder_.path() / "again.ply"));
}

// Sites are seen on the surface, about as many as are wanted in the end.
TEST_F(SessionModelTest, TheSitesOfARemeshAreSeenMoving) {
  open(icosphere(5000), 5);
  std::set<double> energies;
  std::size_t sites = 0;
  model_->perform(parse_command(R"({"do":"remesh","vertices":60})"), [&] {
    const BundleReader bundle(model_->bundle("sites"));
    const std::vector<double> places = bundle.array("sites");
    sites = places.size() / 3;
    EXPECT_EQ(sites, model_->remesh()->progress.sites);
    for (std::size_t i = 0; i < places.size(); i += 3) {
      const Vec3 site(places[i], places[i + 1], places[i + 2]);
      const double scale = bundle.header().at("scale");
      EXPECT_NEAR(norm(site) * scale, 1, 0.2);
    }
    energies.insert(model_->remesh()->progress.energy_ratio);
    return true;
  });
  EXPECT_GE(sites, 60U);
  EXPECT_GT(energies.size(), 3U);
  EXPECT_FALSE(state()["layers"].contains("sites"));
}

TEST_F(SessionModelTest, RegionsKeepTheirColoursWhileSeedsMove) {
  open(torus(600, 1), 12);
  const auto palette = [this] { return BundleReader(model_->bundle("regions")).array("palette"); };
  const std::vector<double> before = palette();
  run(3);
  EXPECT_EQ(palette(), before);
  perform(R"({"do":"add_seed","id":)" + std::to_string(free_id()) + "}");
  EXPECT_EQ(palette().size(), before.size() + 3);
}

TEST_F(SessionModelTest, LayersGoWithTheSeedsTheyBelongTo) {
  open(torus(600, 1), 12);
  perform(R"({"do":"truth"})");
  perform(R"({"do":"dual"})");
  for (const char* layer : {"mesh", "regions", "trees", "truth", "dual"}) {
    EXPECT_FALSE(model_->bundle(layer).empty()) << layer;
  }
  const Json before = state()["layers"];
  perform(R"({"do":"macrostep"})");
  EXPECT_GT(state()["layers"]["regions"], before["regions"]);
  for (const char* layer : {"truth", "dual", "field", "remesh", "../mesh", ""}) {
    EXPECT_THROW((void)model_->bundle(layer), InvalidInput) << layer;
  }
}

TEST_F(SessionModelTest, WithoutAFolderNothingIsSaved) {
  open(icosphere(80), 3);
  SessionModel other(load_input(folder_.path() / "mesh.ply", threads_.executor()), options_, {},
                     threads_);
  EXPECT_THROW(
      other.perform(parse_command(R"({"do":"save","what":"result"})"), [] { return true; }),
      InvalidInput);
  EXPECT_TRUE(other.state(nullptr, false)["output"].is_null());
}

}  // namespace
}  // namespace geolloyd

// The command remesh-all, and the queue of meshes that it has.
#include <atomic>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "core/formats/mesh_io.h"
#include "core/text/file_io.h"
#include "tests/support/program.h"
#include "tests/support/sanitizers.h"
#include "tools/files/csv.h"
#include "tools/run/work_queue.h"

namespace geolloyd {
namespace {

class RemeshingAll : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    fs::create_directory(meshes());
  }

  [[nodiscard]] fs::path meshes() const { return folder_.path() / "meshes"; }

  // By the shape's name and number of triangles, in the folder of meshes.
  void generate(const std::string& shape, int triangles, const std::string& name) const {
    ASSERT_EQ(geolloyd_with("generate " + shape + " -t " + std::to_string(triangles) + " -o " +
                            (meshes() / name).string())
                  .status,
              0);
  }

  void generate_some() const {
    generate("creature", 1000, "a.ply");
    generate("torus", 1000, "a.obj");
    generate("torus", 500, "b.off");
    generate("plane", 700, "c.stl");
  }

  [[nodiscard]] Outcome remesh_all(const std::string& options,
                                   const std::string& name = "out") const {
    return geolloyd_with("remesh-all " + meshes().string() + " -o " + out(name).string() + " " +
                         options);
  }

  [[nodiscard]] static nlohmann::json record_of(const fs::path& folder) {
    return nlohmann::json::parse(read_file(folder / "remesh-all.json"));
  }
};

TEST_F(RemeshingAll, MakesTheRemeshesOfRemesh) {
  generate_some();
  const std::vector<std::string> names = {"a.obj", "a.ply", "b.off", "c.stl"};
  for (const std::string& name : names) {
    const std::string files = (meshes() / name).string() + " -o " + out(name).string();
    ASSERT_EQ(geolloyd_with("remesh " + files + " -n 60").status, 0);
  }
  std::vector<std::string> all_teams = {"--threads 7 --memory-limit 80M", "--threads 1",
                                        "--threads 2", "--threads 3 --backend openmp"};
  if (under_sanitizer) all_teams.resize(1);  // each takes half a minute there
  for (const std::string& teams : all_teams) {
    const Outcome outcome = remesh_all("-n 60 " + teams);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find("4 meshes: 4 remeshed, 0 failed;"), std::string::npos)
        << outcome.text;
    for (const std::string& name : names) {
      EXPECT_EQ(read_file(out(name)), read_file(out() / name)) << name << " " << teams;
    }
  }
}

TEST_F(RemeshingAll, RecordsEachMesh) {
  generate_some();
  ASSERT_EQ(remesh_all("-n 60 --reports").status, 0);
  const nlohmann::json record = record_of(out());
  EXPECT_EQ(record["meshes"], 4);
  EXPECT_EQ(record["done"], 4);
  EXPECT_EQ(record["failed"], 0);
  EXPECT_EQ(record["interrupted"], false);
  ASSERT_EQ(record["rows"].size(), 4U);
  const nlohmann::json& row = record["rows"][1];
  EXPECT_EQ(row["input"], (meshes() / "a.ply").string());
  EXPECT_EQ(row["output"], (out() / "a.ply").string());
  EXPECT_EQ(row["triangles"], read(meshes() / "a.ply").mesh.triangle_count());
  EXPECT_EQ(row["error"], nullptr);
  const auto report = nlohmann::json::parse(read_file(out() / "a.ply.json"));
  EXPECT_EQ(row["remesh_vertices"], report["remesh"]["vertices"]);
  EXPECT_EQ(row["fingerprint"], report["fingerprint"]);
  EXPECT_EQ(lines_of(out() / "remesh-all.csv").size(), 5U);
}

TEST_F(RemeshingAll, GoesOnPastBadMeshes) {
  generate_some();
  std::ofstream(meshes() / "cut.ply") << "ply\nformat ascii 1.0\nelement vertex 3\n";
  std::ofstream(meshes() / "flat.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
  std::ofstream(meshes() / "notes.txt") << "no mesh";
  const Outcome outcome = remesh_all("-n 60");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.text.find("6 meshes: 4 remeshed, 2 failed;"), std::string::npos)
      << outcome.text;
  EXPECT_NE(outcome.text.find("flat.obj: no triangle with an area"), std::string::npos)
      << outcome.text;
  EXPECT_NE(outcome.text.find("geolloyd: 2 of 6 meshes have no remesh: see"), std::string::npos)
      << outcome.text;
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(out())) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"a.obj", "a.ply", "b.off", "c.stl", "remesh-all.csv",
                                          "remesh-all.json"}));
  EXPECT_EQ(record_of(out())["failed"], 2);
}

TEST_F(RemeshingAll, RefusesWhatWouldReplaceAnInputOrAnother) {
  generate_some();
  expect_complaint(remesh_all("-n 60 --format ply"), "would both become");
  expect_complaint(
      geolloyd_with("remesh-all " + meshes().string() + " -n 100 -o " + meshes().string()),
      "would be overwritten");
  fs::create_directory(out("twins"));
  fs::copy(meshes() / "a.ply", out("twins") / "a.ply");
  expect_complaint(geolloyd_with("remesh-all " + (meshes() / "a.ply").string() + " " +
                                 out("twins").string() + " -n 100 -o " + out().string()),
                   "would both become");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(RemeshingAll, RefusesWrongOptions) {
  expect_complaint(remesh_all("-n 60"), "no mesh in this folder");
  generate_some();
  expect_complaint(remesh_all(""), "how fine?");
  expect_complaint(remesh_all("-n 60 --vfield field.csv"), "belongs to one mesh");
  expect_complaint(remesh_all("-n 60 --map map.csv"), "--map");
  expect_complaint(geolloyd_with("remesh-all nowhere -n 100 -o " + out().string()),
                   "nowhere: no such folder");
}

// Whole files, or none.
TEST_F(RemeshingAll, EndsInGoodOrder) {
  for (int i = 0; i < 8; ++i) generate("creature", 4000, std::to_string(i) + ".ply");
  for (const int signal : {SIGINT, SIGKILL}) {
    const std::string name = "out" + std::to_string(signal);
    Running running({"remesh-all", meshes().string(), "-n", "1500", "-o", out(name).string()},
                    folder_.path() / "text", out(name));
    while (!fs::exists(out(name) / "remesh-all.json")) ::usleep(1000);
    ::usleep(under_sanitizer ? 1'500'000 : 300'000);
    running.send(signal);
    const int status = running.wait();
    if (signal == SIGINT) {
      EXPECT_TRUE(status == 130 || status == 0) << status;
      EXPECT_EQ(record_of(out(name))["interrupted"], status == 130);
    }
    for (const auto& entry : fs::directory_iterator(out(name))) {
      if (!has_mesh_name(entry.path())) continue;
      EXPECT_EQ(read(entry.path()).mesh.vertex_count(), 1500U);
    }
  }
}

// Works that hold memory, and ask for more than they were thought to.
TEST(WorkQueue, NeverHoldsMoreThanIsAllowed) {
  constexpr std::uint64_t allowed = 100;
  for (const std::size_t threads : {1U, 2U, 5U}) {
    Scheduler scheduler(threads);
    std::vector<QueuedWork> meshes;
    for (std::uint64_t i = 0; i < 40; ++i) meshes.push_back({i, 1 + i * 7 % 60});
    meshes.push_back({1000, 5000});
    std::vector<std::atomic<int>> done(meshes.size());
    std::atomic<std::uint64_t> held = 0;
    WorkQueue queue(meshes, allowed, scheduler);
    queue.run([&](std::size_t mesh, MemoryShare& share) {
      const std::uint64_t needed = mesh % 3 == 0 ? 90 : 10 + mesh % 40;
      share.become(needed);
      EXPECT_LE(held += needed, allowed);
      ::usleep(100);
      held -= needed;
      ++done[mesh];
    });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(WorkQueue, BeginsWithTheMostWork) {
  Scheduler scheduler(1);
  std::vector<std::size_t> order;
  WorkQueue queue({{3, 0}, {9, 0}, {5, 0}, {9, 0}}, 1, scheduler);
  queue.run([&](std::size_t mesh, MemoryShare&) { order.push_back(mesh); });
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 3, 2, 0}));
}

TEST(WorkQueue, EndsWithTheErrorOfAWork) {
  Scheduler scheduler(2);
  WorkQueue queue(std::vector<QueuedWork>(10), 1, scheduler);
  EXPECT_THROW(queue.run([](std::size_t, MemoryShare&) { throw std::runtime_error("expected"); }),
               std::runtime_error);
}

TEST(Csv, QuotesWhatWouldEndACell) {
  EXPECT_EQ(csv_text(Json::parse(R"([{"a": "x, \"y\"", "b": 1}, {"a": "plain", "b": null}])")),
            "a,b\n\"x, \"\"y\"\"\",1\nplain,\n");
}

}  // namespace
}  // namespace geolloyd

#pragma once

// A session on a small mesh in a file, and the program on that file.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/shapes/shapes.h"
#include "geolloyd/threads.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"
#include "tools/run/input.h"
#include "tools/view/session/saving.h"
#include "tools/view/session/session_model.h"

namespace geolloyd {

class SessionFixture : public testing::Test {
 protected:
  void open(const Mesh& mesh, std::size_t seeds, GreedyMode greedy = GreedyMode::extended) {
    const std::filesystem::path file = folder_.path() / "mesh.ply";
    FileWriter writer(file);
    write(writer, mesh);
    writer.commit();
    options_.seeds.count = seeds;
    options_.seeds.init = SeedInit::random;  // leaves something to do
    options_.greedy = greedy;
    output_ = folder_.path() / "saved";
    folders_.push_back(prepare_saving(output_, {}));
    model_ = std::make_unique<SessionModel>(load_input(file, threads_.executor()), options_,
                                            output_, threads_);
  }

  [[nodiscard]] Json state() { return model_->state(nullptr, false); }

  /// But for what every command changes.
  [[nodiscard]] Json facts() {
    Json facts = state();
    facts.erase("revision");
    facts.erase("message");
    return facts;
  }

  void perform(const std::string& command) {
    model_->perform(parse_command(command), [] { return true; });
  }

  /// Takes all steps there are, at most so many.
  void run(std::size_t steps = 1000) {
    for (std::size_t i = 0; i < steps && !model_->is_done(); ++i) {
      ASSERT_TRUE(model_->take_step([] { return true; }));
    }
  }

  /// What the program prints as fingerprint for this command line, with another output.
  std::string fingerprint_of(std::string command_line) {
    const std::string name = "geolloyd ";
    EXPECT_EQ(command_line.rfind(name, 0), 0U);
    const std::size_t place = command_line.rfind("--output ");
    const bool is_relax = command_line.rfind("geolloyd relax", 0) == 0;
    const std::string target = (folder_.path() / (is_relax ? "again" : "again.ply")).string();
    const Outcome outcome = geolloyd_with(command_line.substr(name.size(), place - name.size()) +
                                          " --output " + target);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    const std::string word = "fingerprint ";
    const std::size_t at = outcome.text.find(word);
    EXPECT_NE(at, std::string::npos) << outcome.text;
    const std::size_t begin = outcome.text.find_first_not_of(' ', at + word.size());
    return outcome.text.substr(begin, 16);
  }

  void expect_reproducible() {
    const Json now = state();
    ASSERT_TRUE(now["fingerprint"].is_string());
    EXPECT_EQ(now["fingerprint"], fingerprint_of(now["command_line"])) << now["command_line"];
  }

  TemporaryFolder folder_;
  std::filesystem::path output_;
  std::vector<MadeFolders> folders_;
  Threads threads_{2};
  SessionOptions options_;
  std::unique_ptr<SessionModel> model_;
};

}  // namespace geolloyd

// The command `view` as a process: what it prints, and how it ends.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "tests/support/program.h"
#include "tests/view/http_fixture.h"

namespace geolloyd {
namespace {

class ViewCommand : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    const Outcome outcome = geolloyd_with("view none.ply --no-open");
    if (outcome.text.find("without its viewer") == std::string::npos) return;
    expect_complaint(outcome, "tools/install-dependencies --viewer");
    GTEST_SKIP() << "the program was built without its viewer";
  }

  // Once it is there.
  [[nodiscard]] std::string address_in(const fs::path& text) const {
    const std::string begin = "http://127.0.0.1:";
    for (int i = 0; i < 3000; ++i) {
      const std::string printed = fs::exists(text) ? read_file(text) : "";
      const std::size_t at = printed.find(begin);
      if (at != std::string::npos && printed.find("Ctrl-C") != std::string::npos) {
        return printed.substr(at, printed.find('\n', at) - at);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return "";
  }
};

TEST_F(ViewCommand, AnswersAtTheAddressItPrintsUntilAnInterrupt) {
  const fs::path text = out("text");
  Running running({"view", mesh_.string(), "--no-open", "--seeds", "20"}, text);
  const std::string address = address_in(text);
  const std::size_t sign = address.find("/#");
  ASSERT_NE(sign, std::string::npos) << address;
  const std::string host = address.substr(7, sign - 7);
  const std::string token = address.substr(sign + 2);
  const Client client(static_cast<std::uint16_t>(std::stoi(host.substr(host.find(':') + 1))));
  client.send("GET /api/state HTTP/1.1\r\nHost: " + host + "\r\nX-Geolloyd-Token: " + token +
              "\r\n\r\n");
  EXPECT_NE(client.receive_all().find("\"seeds\":20"), std::string::npos);
  running.send(SIGINT);
  EXPECT_EQ(running.wait(), 130);
  EXPECT_EQ(read_file(text).find("terminate"), std::string::npos);
}

TEST_F(ViewCommand, RefusesWhatCannotBeShownOrSaved) {
  expect_complaint(geolloyd_with("view none.ply --no-open"), "none.ply");
  const std::string mesh = mesh_.string() + " --no-open ";
  expect_complaint(geolloyd_with("view " + mesh + "--seeds 0"), "--seeds");
  expect_complaint(geolloyd_with("view " + mesh + "--seeds 100000"), "seeds");
  expect_complaint(geolloyd_with("view " + mesh + "--vfield none.csv"), "none.csv");
  expect_complaint(geolloyd_with("view " + mesh + "--output /proc/none"), "/proc/none");
  const fs::path seeds = folder_.write("picture.png", "0\n1\n");
  expect_complaint(geolloyd_with("view " + mesh + "--seeds-file " + seeds.string() + " --output " +
                                 folder_.path().string()),
                   "would be overwritten");
}

}  // namespace
}  // namespace geolloyd

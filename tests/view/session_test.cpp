#include "tools/view/session/session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>

#include "tests/view/session_fixture.h"

namespace geolloyd {
namespace {

// The session's thread, and tests that wait for it.
class SessionTest : public SessionFixture {
 protected:
  void begin() {
    session_ = std::make_unique<Session>(*model_, [this] { ++changes_; });
  }

  template <class Ask>
  SessionAnswer answer(Ask&& ask) {
    auto promise = std::make_shared<std::promise<SessionAnswer>>();
    ask([promise](SessionAnswer a) { promise->set_value(std::move(a)); });
    return promise->get_future().get();
  }

  SessionAnswer command(const std::string& text) {
    return answer([&](AnswerCallback done) { session_->command(text, std::move(done)); });
  }

  SessionAnswer bundle(const std::string& name) {
    return answer([&](AnswerCallback done) { session_->bundle(name, std::move(done)); });
  }

  [[nodiscard]] Json latest() const { return Json::parse(session_->state()); }

  template <class Holds>
  void wait_until(Holds&& holds) {
    while (!holds(latest())) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  std::atomic<int> changes_ = 0;
  std::unique_ptr<Session> session_;
};

TEST_F(SessionTest, ARunThatIsPausedAgainAndAgainIsTheSame) {
  open(torus(6000, 1), 60);
  run();
  const Json whole = facts();
  perform(R"({"do":"reset"})");
  begin();
  for (int i = 0; i < 200 && latest()["phase"] != "done"; ++i) {
    EXPECT_EQ(command(R"({"do":"run"})").status, 200);
    std::this_thread::sleep_for(std::chrono::milliseconds(i % 7));
    EXPECT_EQ(command(R"({"do":"pause"})").status, 200);
    EXPECT_FALSE(latest()["running"].get<bool>());
    EXPECT_TRUE(latest()["fingerprint"].is_string());
  }
  command(R"({"do":"run"})");
  wait_until([](const Json& state) { return state["phase"] == "done" && !state["running"]; });
  EXPECT_EQ(latest()["fingerprint"], whole["fingerprint"]);
  EXPECT_EQ(latest()["energies"], whole["energies"]);
}

TEST_F(SessionTest, BundlesAreServedAmidARun) {
  open(torus(6000, 1), 60);
  begin();
  command(R"({"do":"run"})");
  std::uint64_t before = 0;
  while (latest()["running"]) {
    EXPECT_EQ(bundle("regions").status, 200);
    const Json state = latest();
    EXPECT_GE(state["revision"].get<std::uint64_t>(), before);
    before = state["revision"];
  }
  EXPECT_EQ(bundle("regions").status, 200);
  EXPECT_EQ(bundle("no-such").status, 404);
  EXPECT_GT(changes_, 1);
}

TEST_F(SessionTest, CommandsFromTwoSidesAreDoneOneAfterTheOther) {
  open(torus(2000, 1), 40);
  begin();
  const auto steps = [this] {
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(command(R"({"do":"reset"})").status, 200);
      EXPECT_EQ(command(R"({"do":"macrostep"})").status, 200);
    }
  };
  std::thread other(steps);
  steps();
  other.join();
  EXPECT_EQ(command(R"({"do":"reset"})").status, 200);
  EXPECT_EQ(latest()["step"], 0);
}

TEST_F(SessionTest, ARefusedCommandLeavesAMessage) {
  open(icosphere(80), 3);
  begin();
  EXPECT_EQ(command("{").status, 400);
  EXPECT_TRUE(latest()["message"].is_null());
  const SessionAnswer refused = command(R"({"do":"remove_seed","region":9})");
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(latest()["message"]["kind"], "error");
  EXPECT_EQ(latest()["message"]["text"], Json::parse(refused.body)["error"]);
}

TEST_F(SessionTest, ARemeshCanBeStopped) {
  open(torus(20000, 1), 4);
  begin();
  EXPECT_EQ(command(R"({"do":"remesh","vertices":2000})").status, 200);
  while (!latest()["task"].is_null()) {
    if (latest()["remesh"].is_null() || latest()["remesh"]["iteration"] == 0) continue;
    const int status = command(R"({"do":"reset"})").status;
    EXPECT_TRUE(status == 409 || status == 200);
    EXPECT_EQ(command(R"({"do":"stop"})").status, 200);
  }
  EXPECT_EQ(bundle("remesh").status, 200);
}

TEST_F(SessionTest, EndsInTheMiddleOfARun) {
  open(torus(6000, 1), 60);
  begin();
  command(R"({"do":"run"})");
  session_.reset();
  EXPECT_GT(changes_, 0);
}

}  // namespace
}  // namespace geolloyd

// What a browser asks of a session, over a connection.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "tests/view/bundle_reader.h"
#include "tests/view/http_fixture.h"

namespace geolloyd {
namespace {

class Http : public HttpFixture {};

TEST_F(Http, ServesTheAppWithHeadersThatKeepOthersOut) {
  serve();
  for (const char* path : {"/", "/app.js", "/app.css"}) {
    const std::string response =
        answer_to(std::string("GET ") + path + " HTTP/1.1\r\nHost: localhost:PORT\r\n\r\n");
    EXPECT_EQ(status_of(response), 200) << path;
    EXPECT_NE(response.find("Content-Security-Policy: default-src 'self'"), std::string::npos);
    EXPECT_NE(response.find("X-Content-Type-Options: nosniff"), std::string::npos);
    EXPECT_NE(response.find("Cross-Origin-Resource-Policy: same-origin"), std::string::npos);
    EXPECT_NE(response.find("Referrer-Policy: no-referrer"), std::string::npos);
    EXPECT_EQ(response.find("Access-Control"), std::string::npos);
  }
  EXPECT_EQ(body_of(get("/")), "<title>viewer</title>");
}

TEST_F(Http, CommandsChangeTheState) {
  serve();
  const Json before = Json::parse(body_of(get("/api/state")));
  EXPECT_EQ(before["step"], 0);
  EXPECT_EQ(status_of(post(R"({"do":"macrostep"})")), 200);
  const Json after = Json::parse(body_of(get("/api/state")));
  EXPECT_EQ(after["step"], 1);
  EXPECT_LT(after["energy"], before["energy"]);
  EXPECT_EQ(status_of(post(R"({"do":"remove_seed","region":99})")), 409);
  EXPECT_EQ(status_of(post("{}")), 400);
}

TEST_F(Http, BundlesCanBeRead) {
  serve();
  const BundleReader mesh(body_of(get("/api/mesh")));
  const BundleReader regions(body_of(get("/api/layer/regions")));
  EXPECT_EQ(mesh.entry("positions")["count"], regions.entry("region")["count"]);
  EXPECT_EQ(regions.entry("seeds")["count"], 12);
  EXPECT_EQ(status_of(get("/api/layer/truth")), 404);
}

TEST_F(Http, EventsTellOfChanges) {
  serve();
  const Client one(port());
  const Client other(port());
  for (const Client* client : {&one, &other}) {
    client->send(
        filled("GET /api/events HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n"
               "X-Geolloyd-Token: TOKEN\r\n\r\n"));
    EXPECT_NE(client->receive_until("\n\n").find("text/event-stream"), std::string::npos);
  }
  EXPECT_EQ(status_of(post(R"({"do":"run"})")), 200);
  for (const Client* client : {&one, &other}) {
    EXPECT_NE(client->receive_until("\"phase\":\"done\"").find("\"phase\":\"done\""),
              std::string::npos);
  }
}

// A browser that is killed or does not read any more keeps nobody else from the session.
TEST_F(Http, ListenersThatGoLeaveTheirPlace) {
  serve();
  for (int i = 0; i < 20; ++i) {
    const Client client(port());
    client.send(
        filled("GET /api/events HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n"
               "X-Geolloyd-Token: TOKEN\r\n\r\n"));
    std::string head;
    for (int again = 0; again < 200 && head.empty(); ++again) {
      head = client.receive_until("\n\n");
      if (status_of(head) == 503) break;
    }
    if (status_of(head) == 503) {  // the earlier one has just gone
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      continue;
    }
    EXPECT_EQ(status_of(head), 200);
  }
  EXPECT_EQ(status_of(get("/api/state")), 200);
}

TEST_F(Http, NoMoreThanFourListen) {
  serve();
  std::vector<std::unique_ptr<Client>> clients;
  for (std::size_t i = 0; i < most_listeners; ++i) {
    clients.push_back(std::make_unique<Client>(port()));
    clients.back()->send(
        filled("GET /api/events HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n"
               "X-Geolloyd-Token: TOKEN\r\n\r\n"));
    EXPECT_EQ(status_of(clients.back()->receive_until("\n\n")), 200);
  }
  EXPECT_EQ(status_of(get("/api/events")), 503);
  EXPECT_EQ(status_of(get("/api/state")), 200);
}

TEST_F(Http, EndsWhenNobodyHasBeenThereForAWhile) {
  HttpServerOptions options;
  options.idle_seconds = 0.3;
  serve(options);
  EXPECT_EQ(status_of(get("/api/state")), 200);
  thread_.join();
  EXPECT_FALSE(Client(port()).is_connected() && status_of(get("/")) == 200);
}

TEST_F(Http, TokensDiffer) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = random_token();
    EXPECT_EQ(token.size(), 32U);
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100U);
  EXPECT_TRUE(same_secret("abc", "abc"));
  EXPECT_FALSE(same_secret("abc", "abd"));
  EXPECT_FALSE(same_secret("abc", "ab"));
  EXPECT_FALSE(same_secret("", "a"));
}

}  // namespace
}  // namespace geolloyd

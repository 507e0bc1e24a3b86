// Whoever is not the viewer gets nothing, whatever he sends, and keeps nobody from it.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/view/http_fixture.h"

namespace geolloyd {
namespace {

struct Attack {
  const char* what;
  std::string request;
  int status;  // 0: the connection ends without an answer
};

std::string with_host(const std::string& host) {
  return "GET /api/state HTTP/1.1\r\nHost: " + host + "\r\nX-Geolloyd-Token: TOKEN\r\n\r\n";
}

std::string with(const std::string& headers, const std::string& first = "GET /api/state") {
  return first + " HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n" + headers + "\r\n";
}

const std::string key_header = "X-Geolloyd-Token: TOKEN\r\n";
const std::string post_command = "POST /api/command";
const std::string run_body = "Content-Length: 12\r\n\r\n{\"do\":\"run\"}";

std::vector<Attack> attacks() {
  const std::string json = "Content-Type: application/json\r\n";
  std::vector<Attack> list = {
      {"rebinding", with_host("evil.example:PORT"), 403},
      {"rebinding to the name with a dot", with_host("localhost.:PORT"), 403},
      {"rebinding with the name inside", with_host("127.0.0.1.evil.example:PORT"), 403},
      {"host without a port", with_host("127.0.0.1"), 403},
      {"host with another port", with_host("127.0.0.1:1"), 403},
      {"host in IPv6", with_host("[::1]:PORT"), 403},
      {"host as a number", with_host("2130706433:PORT"), 403},
      {"host 0.0.0.0", with_host("0.0.0.0:PORT"), 403},
      {"host in capitals", with_host("LOCALHOST:PORT"), 403},
      {"host with a user", with_host("a@127.0.0.1:PORT"), 403},
      {"empty host", with_host(""), 403},
      {"no host", "GET /api/state HTTP/1.1\r\n" + key_header + "\r\n", 403},
      {"no host in HTTP/1.0", "GET /api/state HTTP/1.0\r\n" + key_header + "\r\n", 403},
      {"two hosts", with("Host: evil.example\r\n" + key_header), 403},
      {"no token", with(""), 403},
      {"empty token", with("X-Geolloyd-Token:\r\n"), 403},
      {"wrong token", with("X-Geolloyd-Token: 00000000000000000000000000000000\r\n"), 403},
      {"part of the token", with("X-Geolloyd-Token: 0\r\n"), 403},
      {"token and more", with("X-Geolloyd-Token: TOKENTOKEN\r\n"), 403},
      {"two tokens", with(key_header + key_header), 403},
      {"token in the address", with("", "GET /api/state?token=TOKEN"), 403},
      {"token as a cookie", with("Cookie: token=TOKEN\r\n"), 403},
      {"another origin", with("Origin: http://evil.example\r\n" + key_header), 403},
      {"origin null, as of a sandbox or a file", with("Origin: null\r\n" + key_header), 403},
      {"origin of another port", with("Origin: http://127.0.0.1:1\r\n" + key_header), 403},
      {"origin by https", with("Origin: https://127.0.0.1:PORT\r\n" + key_header), 403},
      {"origin and host of the attacker",
       "GET / HTTP/1.1\r\nHost: evil.example:PORT\r\nOrigin: http://evil.example:PORT\r\n\r\n",
       403},
      {"two origins",
       with("Origin: http://127.0.0.1:PORT\r\nOrigin: http://evil.example\r\n" + key_header), 403},
      {"cross-site fetch", with("Sec-Fetch-Site: cross-site\r\n" + key_header), 403},
      {"same-site fetch", with("Sec-Fetch-Site: same-site\r\n" + key_header), 403},
      {"a script that another page loads", with("Sec-Fetch-Site: cross-site\r\n", "GET /app.js"),
       403},
      {"preflight",
       with("Origin: http://evil.example\r\nAccess-Control-Request-Method: POST\r\n",
            "OPTIONS /api/command"),
       405},
      {"a form of text", with(key_header + "Content-Type: text/plain\r\n" + run_body, post_command),
       415},
      {"a form",
       with(key_header + "Content-Type: application/x-www-form-urlencoded\r\n" + run_body,
            post_command),
       415},
      {"a form with files",
       with(key_header + "Content-Type: multipart/form-data\r\n" + run_body, post_command), 415},
      {"no type", with(key_header + run_body, post_command), 415},
      {"two types",
       with(key_header + json + "Content-Type: text/plain\r\n" + run_body, post_command), 415},
      {"type that begins well",
       with(key_header + "Content-Type: application/jsonx\r\n" + run_body, post_command), 415},
      {"a command by GET", with(key_header, "GET /api/command"), 405},
      {"GET with a body", with(key_header + "Content-Length: 2\r\n\r\n{}"), 400},
      {"PUT", with(key_header, "PUT /api/command"), 405},
      {"DELETE", with(key_header, "DELETE /api/state"), 405},
      {"TRACE", with(key_header, "TRACE /"), 405},
      {"HEAD", with(key_header, "HEAD /"), 405},
      {"CONNECT", with(key_header, "CONNECT evil.example:443"), 405},
      {"POST elsewhere", with(key_header + json + run_body, "POST /api/state"), 405},
      {"an unknown path", with(key_header, "GET /etc/passwd"), 404},
      {"a path that climbs", with(key_header, "GET /../../../../etc/passwd"), 404},
      {"a path that climbs, encoded", with(key_header, "GET /%2e%2e/%2e%2e/etc/passwd"), 404},
      {"a layer that climbs", with(key_header, "GET /api/layer/../../etc/passwd"), 404},
      {"a layer of nobody", with(key_header, "GET /api/layer/"), 404},
      {"a question", with(key_header, "GET /?x"), 404},
      {"an address as path", with(key_header, "GET http://127.0.0.1:PORT/api/state"), 400},
      {"a star as path", with(key_header, "GET *"), 400},
      {"chunks",
       with(key_header + json +
                "Transfer-Encoding: chunked\r\n\r\nc\r\n{\"do\":\"run\"}\r\n0\r\n\r\n",
            post_command),
       400},
      {"two lengths",
       with(key_header + json + "Content-Length: 12\r\nContent-Length: 2\r\n\r\n{\"do\":\"run\"}",
            post_command),
       400},
      {"length and chunks",
       with(key_header + json + "Transfer-Encoding: chunked\r\n" + run_body, post_command), 400},
      {"a negative length", with(key_header + json + "Content-Length: -1\r\n", post_command), 400},
      {"a huge length",
       with(key_header + json + "Content-Length: 99999999999999999999\r\n", post_command), 400},
      {"a body too long", with(key_header + json + "Content-Length: 1000001\r\n", post_command),
       413},
      {"a header too long", with("X: " + std::string(9000, 'x') + "\r\n" + key_header), 431},
      {"a path too long", with(key_header, "GET /" + std::string(9000, 'x')), 431},
      {"many headers",
       [] {
         std::string headers;
         for (int i = 0; i < 3000; ++i) headers += "a:b\r\n";
         return with(headers + key_header);
       }(),
       431},
      {"no HTTP", "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", 400},
      {"HTTP/0.9", "GET /\r\n\r\n", 400},
      {"HTTP/2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", 400},
      {"a zero byte", with(key_header + std::string("X: a\0b\r\n", 8)), 400},
      {"a folded header", with("X: a\r\n b\r\n" + key_header), 200},
      {"a header without a colon", with("X\r\n" + key_header), 400},
      {"a blank before the colon", with("Host : evil.example\r\n" + key_header), 400},
      {"lines that end in LF", "GET /api/state HTTP/1.1\nHost: 127.0.0.1:PORT\n\n", 400},
      {"a response", "HTTP/1.1 200 OK\r\n\r\n", 400},
      {"WebSocket",
       with(key_header + "Upgrade: websocket\r\nConnection: Upgrade\r\n", "GET /api/socket"), 404},
  };
  return list;
}

class HttpAttacks : public HttpFixture {};

TEST_F(HttpAttacks, GetNothingAndChangeNothing) {
  serve();
  const std::string before = session_->state();
  for (const Attack& attack : attacks()) {
    SCOPED_TRACE(attack.what);
    const std::string response = answer_to(attack.request);
    EXPECT_EQ(status_of(response), attack.status) << response.substr(0, 300);
    if (attack.status != 200) {
      EXPECT_EQ(response.find("\"revision\""), std::string::npos);
    }
    EXPECT_EQ(response.find(token_), std::string::npos);
    EXPECT_EQ(response.find("Access-Control"), std::string::npos);
  }
  EXPECT_EQ(session_->state(), before);
  EXPECT_EQ(status_of(get("/api/state")), 200);
}

// Headers that drip in, bodies that stay away, responses that nobody takes.
TEST_F(HttpAttacks, SlowClientsAreLeft) {
  HttpServerOptions options;
  options.patience_seconds = 0.3;
  serve(options);
  const Client silent(port());
  const Client half(port());
  half.send("GET / HT");
  const Client bodiless(port());
  bodiless.send(
      filled("POST /api/command HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\nX-Geolloyd-Token: TOKEN\r\n"
             "Content-Type: application/json\r\nContent-Length: 12\r\n\r\n"));
  const Client dripping(port());
  int drops = 0;
  while (drops < 1000 && dripping.send("a")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ++drops;
  }
  EXPECT_LT(drops, 1000);
  for (const Client* client : {&silent, &half, &bodiless}) EXPECT_EQ(client->receive_all(), "");
  EXPECT_EQ(status_of(get("/api/state")), 200);
}

TEST_F(HttpAttacks, AThousandConnectionsKeepNobodyOut) {
  rlimit files{};
  ::getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
  ::setrlimit(RLIMIT_NOFILE, &files);
  serve();
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 1000; ++i) {
    clients.push_back(std::make_unique<Client>(port()));
    if (!clients.back()->is_connected()) break;
  }
  int answered = 0;
  for (int i = 0; i < 10; ++i) answered += status_of(get("/api/state")) == 200 ? 1 : 0;
  EXPECT_EQ(answered, 10);
  EXPECT_EQ(status_of(post(R"({"do":"macrostep"})")), 200);
}

// What was sent after a request is no request.
TEST_F(HttpAttacks, OneRequestAConnection) {
  serve();
  const std::string request = with("", "GET /");
  const std::string response = answer_to(request + request);
  EXPECT_EQ(status_of(response), 200);
  EXPECT_EQ(response.find("HTTP/1.1", 1), std::string::npos);
}

TEST_F(HttpAttacks, AnswersOnThisMachineAlone) {
  serve();
  std::ifstream table("/proc/net/tcp");
  const std::string ending = [this] {
    char text[8];
    std::snprintf(text, sizeof text, ":%04X", port());
    return std::string(text);
  }();
  int found = 0;
  for (std::string line; std::getline(table, line);) {
    std::istringstream words(line);
    std::string number;
    std::string local;
    std::string remote;
    std::string stage;
    words >> number >> local >> remote >> stage;
    if (stage != "0A" || local.find(ending) == std::string::npos) continue;
    EXPECT_EQ(local, "0100007F" + ending);
    ++found;
  }
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace geolloyd

#pragma once

// A served session, and what somebody sends to it, byte by byte.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "tests/view/session_fixture.h"
#include "tools/view/http/http_server.h"
#include "tools/view/session/session.h"

namespace geolloyd {

/// A connection to a port of this machine.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    constexpr timeval patience{20, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    is_connected_ =
        ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  Client(Client&& other) noexcept
      : socket_(std::exchange(other.socket_, -1)), is_connected_(other.is_connected_) {}
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  Client& operator=(Client&&) = delete;
  ~Client() {
    if (socket_ >= 0) ::close(socket_);
  }

  [[nodiscard]] bool is_connected() const { return is_connected_; }

  /// False where the other side has gone.
  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  /// Some bytes; none at the end.
  [[nodiscard]] std::string receive() const {
    std::string bytes(65536, '\0');
    const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }

  [[nodiscard]] std::string receive_all() const {
    std::string all;
    for (std::string part = receive(); !part.empty(); part = receive()) all += part;
    return all;
  }

  /// Until a text comes, or the end.
  [[nodiscard]] std::string receive_until(std::string_view text) const {
    std::string all;
    while (all.find(text) == std::string::npos) {
      const std::string part = receive();
      if (part.empty()) break;
      all += part;
    }
    return all;
  }

 private:
  int socket_;
  bool is_connected_ = false;
};

class HttpFixture : public SessionFixture {
 protected:
  void serve(HttpServerOptions options = {}) {
    open(torus(600, 1), 12);
    options.should_end = [this] { return should_end_.load(); };
    server_ = std::make_unique<HttpServer>(options);
    session_ = std::make_unique<Session>(*model_, [this] { server_->notify(); });
    token_ = random_token();
    site_ = std::make_unique<HttpSite>(HttpGuard{server_->port(), token_},
                                       HttpAssets{"<title>viewer</title>", "\"script\"", "body{}"},
                                       *session_);
    thread_ = std::thread([this] { server_->serve(*site_); });
  }

  void TearDown() override {
    should_end_ = true;
    if (thread_.joinable()) thread_.join();
    session_.reset();
  }

  [[nodiscard]] std::uint16_t port() const { return server_->port(); }

  /// With PORT and TOKEN put in.
  [[nodiscard]] std::string filled(std::string text) const {
    for (const auto& [mark, value] :
         {std::pair<std::string, std::string>{"PORT", std::to_string(port())}, {"TOKEN", token_}}) {
      for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;) {
        text.replace(at, mark.size(), value);
        at += value.size();
      }
    }
    return text;
  }

  [[nodiscard]] std::string answer_to(const std::string& text) const {
    const Client client(port());
    client.send(filled(text));
    return client.receive_all();
  }

  [[nodiscard]] std::string get(const std::string& path) const {
    return answer_to("GET " + path +
                     " HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\nX-Geolloyd-Token: TOKEN\r\n\r\n");
  }

  [[nodiscard]] std::string post(const std::string& body) const {
    return answer_to(
        "POST /api/command HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n"
        "Origin: http://127.0.0.1:PORT\r\nSec-Fetch-Site: same-origin\r\n"
        "X-Geolloyd-Token: TOKEN\r\nContent-Type: application/json\r\n"
        "Content-Length: " +
        std::to_string(body.size()) + "\r\n\r\n" + body);
  }

  /// 0 where there was no answer.
  static int status_of(const std::string& response) {
    return response.rfind("HTTP/1.1 ", 0) == 0 ? std::stoi(response.substr(9, 3)) : 0;
  }

  static std::string body_of(const std::string& response) {
    const std::size_t end = response.find("\r\n\r\n");
    return end == std::string::npos ? "" : response.substr(end + 4);
  }

  std::atomic<bool> should_end_ = false;
  std::unique_ptr<HttpServer> server_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<HttpSite> site_;
  std::string token_;
  std::thread thread_;
};

}  // namespace geolloyd

#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "tools/view/http/http_reader.h"
#include "tools/view/http/http_site.h"

namespace geolloyd {

/// One connection: a request, its response, the end. Or events, until either side ends them.
/// All in the thread of its server.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  enum class Stage { reading, answering, listening, closing };

  /// What a server wants to know of its connections, and decides.
  struct Owner {
    HttpSite& site;
    std::chrono::milliseconds patience;
    std::function<void()> seen;        ///< somebody with the token was here
    std::function<bool()> may_listen;  ///< there is room for one more who listens to events
    std::function<void(const std::shared_ptr<HttpConnection>&)> closed;  ///< called once
  };

  HttpConnection(boost::asio::ip::tcp::socket socket, const Owner& owner);

  void start();
  void close();
  [[nodiscard]] Stage stage() const { return stage_; }
  /// Its request is not there, and nothing of it waits to be read.
  [[nodiscard]] bool is_silent() const;
  /// The state has changed: it is sent to those who listen, at most 20 times a second.
  void tell_state() { has_news_ = true; }

 private:
  using Self = std::shared_ptr<HttpConnection>;

  void read();
  void answer();
  void respond(const HttpResponse& response);
  void listen();
  void send(std::string text, void (HttpConnection::*then)());
  void send_rest();
  void tick();
  void sent() {}
  void watch_for_end();
  void drain();
  void limit(std::chrono::milliseconds time);

  boost::asio::ip::tcp::socket socket_;
  const Owner& owner_;
  boost::asio::steady_timer deadline_;
  boost::asio::steady_timer pace_;  // of events
  HttpReader reader_;
  std::array<char, 16384> buffer_{};
  std::string text_;  // that is being sent
  std::size_t sent_ = 0;
  void (HttpConnection::*then_)() = nullptr;
  Stage stage_ = Stage::reading;
  std::size_t drained_ = 0;
  int silent_ticks_ = 0;
  bool is_sending_ = false;
  bool has_news_ = false;
  bool is_closed_ = false;
};

}  // namespace geolloyd

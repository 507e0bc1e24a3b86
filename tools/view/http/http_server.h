#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "tools/view/http/http_site.h"

namespace geolloyd {

struct HttpServerOptions {
  double idle_seconds = 600;     ///< without a page or a computation, after which it ends
  double patience_seconds = 10;  ///< for a request to come, and for each part of a response to go
  std::function<bool()> should_end = [] { return false; };  ///< asked ten times a second
};

inline constexpr std::size_t most_connections = 8;
inline constexpr std::size_t most_listeners = 4;  ///< to events

/// A server on 127.0.0.1, at a port that the system chooses (Boost.Asio). All runs in the thread
/// that calls serve(). Where more connections come than there may be, the oldest that has sent no
/// request yet gives way; where there is none, new ones wait. It must outlive the session that it
/// serves.
class HttpServer {
 public:
  /// Listens. Throws IoError.
  explicit HttpServer(HttpServerOptions options = {});
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  [[nodiscard]] std::uint16_t port() const;
  /// Until it should end, or nobody has been there for a while.
  void serve(HttpSite& site);
  /// From any thread: the state has changed.
  void notify();

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace geolloyd

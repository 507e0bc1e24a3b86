#pragma once

#include <functional>
#include <string_view>

#include "tools/view/http/http_guard.h"
#include "tools/view/http/http_message.h"
#include "tools/view/session/session.h"

namespace geolloyd {

/// The three files of the browser's part.
struct HttpAssets {
  std::string_view index;
  std::string_view script;
  std::string_view style;
};

/// Answers requests: the three files, and a session below /api/ (README.md lists it). Paths are
/// compared, never opened.
class HttpSite {
 public:
  using Done = std::function<void(HttpResponse)>;

  /// `session` must live on.
  HttpSite(HttpGuard guard, const HttpAssets& assets, Session& session);

  /// Calls `done` once, from any thread. Returns whether the request passed the guard and had the
  /// token.
  bool answer(const HttpRequest& request, Done done);
  /// For those who listen to events.
  [[nodiscard]] std::string state() const { return session_.state(); }
  [[nodiscard]] bool is_busy() const { return session_.is_busy(); }

 private:
  void answer_session(const HttpRequest& request, Done done);

  HttpGuard guard_;
  HttpAssets assets_;
  Session& session_;
};

}  // namespace geolloyd

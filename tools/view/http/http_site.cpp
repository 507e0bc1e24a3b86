#include "tools/view/http/http_site.h"

#include <string>
#include <utility>

namespace geolloyd {
namespace {

HttpResponse file_of(const HttpAssets& assets, std::string_view target) {
  if (target == "/") return {200, "text/html; charset=utf-8", std::string(assets.index), false};
  if (target == "/app.js") {
    return {200, "text/javascript; charset=utf-8", std::string(assets.script), false};
  }
  if (target == "/app.css") {
    return {200, "text/css; charset=utf-8", std::string(assets.style), false};
  }
  return http_error(404, "nothing is here");
}

// The answer of a session as a response; a bundle where it is one.
AnswerCallback as_response(HttpSite::Done done, const char* type) {
  return [done = std::move(done), type](SessionAnswer answer) {
    done({answer.status, answer.status == 200 ? type : "application/json", std::move(answer.body),
          false});
  };
}

}  // namespace

HttpSite::HttpSite(HttpGuard guard, const HttpAssets& assets, Session& session)
    : guard_(std::move(guard)), assets_(assets), session_(session) {}

bool HttpSite::answer(const HttpRequest& request, Done done) {
  if (auto refusal = refuse(request, guard_)) {
    done(std::move(*refusal));
    return false;
  }
  const bool is_for_session = request.target.starts_with("/api/");
  if (is_for_session) {
    answer_session(request, std::move(done));
  } else if (request.method == "GET") {
    done(file_of(assets_, request.target));
  } else {
    done(http_error(405, "give GET"));
  }
  return is_for_session;
}

void HttpSite::answer_session(const HttpRequest& request, Done done) {
  constexpr std::string_view layers = "/api/layer/";
  constexpr const char* bundle = "application/octet-stream";
  const std::string_view target = request.target;
  if ((target == "/api/command") != (request.method == "POST")) {
    done(http_error(405, "give POST for commands, GET for all else"));
  } else if (target == "/api/command") {
    session_.command(request.body, as_response(std::move(done), "application/json"));
  } else if (target == "/api/state") {
    done({200, "application/json", session_.state(), false});
  } else if (target == "/api/events") {
    done({200, "text/event-stream", "", true});
  } else if (target == "/api/mesh") {
    session_.bundle("mesh", as_response(std::move(done), bundle));
  } else if (target.starts_with(layers) && target != "/api/layer/mesh") {
    session_.bundle(target.substr(layers.size()), as_response(std::move(done), bundle));
  } else {
    done(http_error(404, "nothing is here"));
  }
}

}  // namespace geolloyd

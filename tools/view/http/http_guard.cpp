#include "tools/view/http/http_guard.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstddef>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// The two names of this machine that a browser resolves by itself.
bool is_here(std::string_view name, std::string_view scheme, std::uint16_t port) {
  for (const char* host : {"127.0.0.1", "localhost"}) {
    if (name == fmt::format("{}{}:{}", scheme, host, port)) return true;
  }
  return false;
}

bool is_json(std::string_view type) {
  return type == "application/json" || type == "application/json; charset=utf-8" ||
         type == "application/json;charset=utf-8" || type == "application/json;charset=UTF-8";
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  ssize_t got = 0;
  do {
    got = ::getrandom(bytes.data(), bytes.size(), 0);
  } while (got < 0 && errno == EINTR);
  if (got != static_cast<ssize_t>(bytes.size())) {
    throw IoError("no random numbers from the system for the viewer's token");
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  volatile unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = static_cast<unsigned char>(difference | (a[i] ^ b[i]));
  }
  return difference == 0;
}

std::optional<HttpResponse> refuse(const HttpRequest& request, const HttpGuard& guard) {
  const bool is_post = request.method == "POST";
  if (!is_post && request.method != "GET") return http_error(405, "give GET or POST");
  if (request.count("host") != 1 || !is_here(request.value("host"), "", guard.port)) {
    return http_error(403, "this is another host: open the address that geolloyd printed");
  }
  if (request.count("origin") > 1 ||
      (request.count("origin") == 1 && !is_here(request.value("origin"), "http://", guard.port))) {
    return http_error(403, "another page may not ask");
  }
  const std::string_view site = request.value("sec-fetch-site");
  if (request.count("sec-fetch-site") > 1 ||
      (request.count("sec-fetch-site") == 1 && site != "same-origin" && site != "none")) {
    return http_error(403, "another page may not ask: open the address that geolloyd printed");
  }
  if (!request.target.starts_with("/")) return http_error(400, "the target is no path");
  const bool is_for_session = request.target.starts_with("/api/");
  if (is_for_session && (request.count("x-geolloyd-token") != 1 ||
                         !same_secret(request.value("x-geolloyd-token"), guard.token))) {
    return http_error(403, "the token is missing or wrong: open the address that geolloyd printed");
  }
  if (request.count("transfer-encoding") > 0) return http_error(400, "give a content length");
  if (!is_post && !request.body.empty()) return http_error(400, "GET has no body");
  if (is_post && (request.count("content-type") != 1 || !is_json(request.value("content-type")))) {
    return http_error(415, "give application/json");
  }
  return std::nullopt;
}

}  // namespace geolloyd

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geolloyd {

/// A request as a browser sent it, whoever that is.
struct HttpRequest {
  std::string method;
  std::string target;
  std::vector<std::pair<std::string, std::string>> headers;  ///< names in lower case
  std::string body;

  /// How often a header is there, by its name in lower case.
  [[nodiscard]] std::size_t count(std::string_view name) const;
  /// Of the first one; empty where there is none.
  [[nodiscard]] std::string_view value(std::string_view name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  bool is_events = false;  ///< states follow one another, as long as anybody listens
};

/// {"error": text}.
HttpResponse http_error(int status, std::string_view text);

/// Status line and headers, with all that keeps other pages from having any of it. The connection
/// ends with the response.
std::string http_head(const HttpResponse& response);

}  // namespace geolloyd

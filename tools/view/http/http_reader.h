#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include "tools/view/http/http_message.h"

namespace geolloyd {

inline constexpr std::size_t most_header_bytes = 8192;
inline constexpr std::size_t most_body_bytes = 1'000'000;

/// Reads one request from bytes as they come (Boost.Beast).
class HttpReader {
 public:
  HttpReader();
  ~HttpReader();
  HttpReader(const HttpReader&) = delete;
  HttpReader& operator=(const HttpReader&) = delete;

  /// Returns true once the request is complete, or is none.
  bool put(std::string_view bytes);
  /// Response to a malformed request, or one that is too large.
  [[nodiscard]] const std::optional<HttpResponse>& refusal() const { return refusal_; }
  [[nodiscard]] bool is_complete() const;
  /// Of a complete one, once.
  HttpRequest take();

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::optional<HttpResponse> refusal_;
};

}  // namespace geolloyd

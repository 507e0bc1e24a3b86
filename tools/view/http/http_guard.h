#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tools/view/http/http_message.h"

namespace geolloyd {

/// What a request must know and may come from.
struct HttpGuard {
  std::uint16_t port = 0;
  std::string token;
};

/// 128 random bits of the system, in hexadecimal digits.
std::string random_token();

/// Compares all of two texts of one length, however early they differ.
bool same_secret(std::string_view a, std::string_view b);

/// What to answer to a request that is not the viewer's own: of another method; for another host
/// than this one, as after DNS rebinding; from another page; without the token, where it is for the
/// session; or a change that a form could have sent. Nothing where it is to be answered.
std::optional<HttpResponse> refuse(const HttpRequest& request, const HttpGuard& guard);

}  // namespace geolloyd

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace geolloyd {

/// The bytes as base64 text (RFC 4648), with = at its end.
std::string to_base64(std::string_view bytes);

/// The bytes that base64 text stands for; nothing where it is none. Padding may be missing.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace geolloyd

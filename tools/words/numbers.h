#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace geolloyd {

/// The number that a text is, in decimal digits; nothing where the text is anything more or less.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace geolloyd

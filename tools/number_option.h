#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

namespace geolloyd {

/// Makes `option` take whole numbers from `least` to `most`, in decimal digits: CLI11 by itself
/// reads 010 as eight and -1 as a huge number.
inline CLI::Option* whole_number(CLI::Option* option, std::uint64_t least,
                                 std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  const auto read = [least, most](std::string& text) -> std::string {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && number >= least && number <= most) {
      text = std::to_string(number);
      return "";
    }
    return "'" + text + "': give a whole number from " + std::to_string(least) + " to " +
           std::to_string(most);
  };
  return option->transform(CLI::Validator(read, ""))->type_name("NUMBER");
}

/// What is wrong with `text` as a time in seconds, or nothing: CLI11 by itself takes nan.
inline std::string complaint_about_seconds(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool is_time = error == std::errc() && stop == end && std::isfinite(number) && number >= 0;
  return is_time ? "" : "'" + text + "': give a number of seconds, 0 or more";
}

}  // namespace geolloyd

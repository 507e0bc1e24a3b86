#include "tools/cli/number_option.h"

#include <CLI/CLI.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

namespace geolloyd {

CLI::Option* whole_number(CLI::Option* option, std::uint64_t least, std::uint64_t most) {
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

CLI::Option* byte_count(CLI::Option* option) {
  const auto read = [](std::string& text) -> std::string {
    constexpr std::string_view prefixes = "KMGT";
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    std::string unit(stop, end);
    for (char& c : unit) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const std::size_t power = unit.empty() || unit == "B" ? 0 : prefixes.find(unit[0]) + 1;
    const std::string rest = power == 0 ? "" : unit.substr(1);
    bool is_size = error == std::errc() && number > 0 &&
                   (unit.empty() || unit == "B" || power > 0) &&
                   (rest.empty() || rest == "B" || rest == "IB");
    for (std::size_t i = 0; is_size && i < power; ++i) {
      is_size = !__builtin_mul_overflow(number, rest == "IB" ? 1024U : 1000U, &number);
    }
    if (!is_size) return "'" + text + "': give a whole number of bytes above 0, or like 800M or 8G";
    text = std::to_string(number);
    return "";
  };
  return option->transform(CLI::Validator(read, ""))->type_name("SIZE");
}

CLI::Option* time_in_seconds(CLI::Option* option) {
  const auto check = [](const std::string& text) -> std::string {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    const bool is_time =
        error == std::errc() && stop == end && std::isfinite(number) && number >= 0;
    return is_time ? "" : "'" + text + "': give a number of seconds, 0 or more";
  };
  return option->check(CLI::Validator(check, ""))->type_name("SECONDS");
}

}  // namespace geolloyd

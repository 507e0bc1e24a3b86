#include "tools/cli/number_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "tools/words/numbers.h"

namespace geolloyd {

CLI::Option* whole_number(CLI::Option* option, std::uint64_t least, std::uint64_t most) {
  const auto read = [least, most](std::string& text) -> std::string {
    const auto number = parse_number<std::uint64_t>(text);
    if (number && *number >= least && *number <= most) {
      text = std::to_string(*number);
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
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const auto given = parse_number<std::uint64_t>(std::string_view(text).substr(0, digits));
    std::uint64_t number = given.value_or(0);
    std::string unit = text.substr(digits);
    for (char& c : unit) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const std::size_t power = unit.empty() || unit == "B" ? 0 : prefixes.find(unit[0]) + 1;
    const std::string rest = power == 0 ? "" : unit.substr(1);
    bool is_size = number > 0 && (unit.empty() || unit == "B" || power > 0) &&
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

CLI::Option* positive_number(CLI::Option* option) {
  const auto check = [](const std::string& text) -> std::string {
    const auto number = parse_number<double>(text);
    const bool is_positive = number && std::isfinite(*number) && *number > 0;
    return is_positive ? "" : "'" + text + "': give a number above 0";
  };
  return option->check(CLI::Validator(check, ""));
}

CLI::Option* time_in_seconds(CLI::Option* option) {
  const auto check = [](const std::string& text) -> std::string {
    const auto number = parse_number<double>(text);
    const bool is_time = number && std::isfinite(*number) && *number >= 0;
    return is_time ? "" : "'" + text + "': give a number of seconds, 0 or more";
  };
  return option->check(CLI::Validator(check, ""))->type_name("SECONDS");
}

}  // namespace geolloyd

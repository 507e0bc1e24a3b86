#include "tools/view/session/json_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geolloyd/errors.h"

namespace geolloyd {

std::string name_among(const std::string& key, const Json& value,
                       const std::vector<std::string>& names) {
  if (value.is_string()) {
    const auto& name = value.get_ref<const std::string&>();
    if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  }
  throw InvalidInput(fmt::format("{}: give one of {}", key, fmt::join(names, ", ")));
}

std::uint64_t whole_number_in(const std::string& key, const Json& value, std::uint64_t least,
                              std::uint64_t most) {
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    if (number >= least && number <= most) return number;
  }
  throw InvalidInput(fmt::format("{}: give a whole number from {} to {}", key, least, most));
}

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/files/json.h"

namespace geolloyd {

// Values of a JSON object that somebody sent. Each throws InvalidInput, in one line that opens with
// the key and quotes nothing that was sent.

/// A string that is one of the names.
std::string name_among(const std::string& key, const Json& value,
                       const std::vector<std::string>& names);

/// A whole number from `least` to `most`.
std::uint64_t whole_number_in(const std::string& key, const Json& value, std::uint64_t least,
                              std::uint64_t most);

}  // namespace geolloyd

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace geolloyd {

using Json = nlohmann::ordered_json;

/// Indented text. Names that are not UTF-8 get replacement characters.
std::string json_text(const Json& json);

}  // namespace geolloyd

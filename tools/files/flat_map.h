#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace geolloyd {

/// Named numbers, texts and bytes: what a checkpoint is made of.
using FlatMap =
    std::map<std::string,
             std::variant<std::uint64_t, double, std::string, std::vector<std::uint8_t>>>;

/// As MessagePack.
std::string encode(const FlatMap& map);
/// Nothing where the bytes are not one such map and nothing more, whatever else they are.
std::optional<FlatMap> decode(std::string_view bytes);

}  // namespace geolloyd

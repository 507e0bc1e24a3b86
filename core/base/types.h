#pragma once

#include <array>
#include <cstdint>

#include "geolloyd/types.h"

namespace geolloyd {

using NodeId = std::uint32_t;  ///< graph node, in spatial order; never leaves the library
using ArcId = std::uint32_t;   ///< position in a graph's arc arrays

/// Two ids, the smaller first.
constexpr std::array<std::uint32_t, 2> ascending(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::array{a, b} : std::array{b, a};
}

__extension__ using Uint128 = unsigned __int128;

}  // namespace geolloyd

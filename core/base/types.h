#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace geolloyd {

// All ids are dense, zero-based and 32 bits wide.
using VertexId = std::uint32_t;    ///< mesh vertex, in input order
using TriangleId = std::uint32_t;  ///< mesh triangle, in input order
using NodeId = std::uint32_t;      ///< graph node, in spatial order
using ArcId = std::uint32_t;       ///< position in a graph's arc arrays
using RegionId = std::uint32_t;    ///< index of the seed that owns the region

/// Stands for "none" wherever an id is expected.
inline constexpr std::uint32_t no_id = std::numeric_limits<std::uint32_t>::max();

/// Two ids, the smaller first.
constexpr std::array<std::uint32_t, 2> ascending(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::array{a, b} : std::array{b, a};
}

__extension__ using Uint128 = unsigned __int128;

}  // namespace geolloyd

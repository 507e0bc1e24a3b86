#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "geolloyd/types.h"

namespace geolloyd {

/// Two engines gave different results.
struct Disagreement : std::runtime_error {
  Disagreement(const std::string& what, std::uint32_t at) : std::runtime_error(what), node(at) {}
  std::uint32_t node;  ///< of the graph, where first; no_id: it is no matter of one node
};

}  // namespace geolloyd

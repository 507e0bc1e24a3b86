#pragma once

#include <utility>

#include "parallel/engine/parallel_engine.h"

namespace geolloyd {

/// All but the automatic one, which is one of these.
inline constexpr std::pair<const char*, Frontier> frontiers[] = {
    {"heap", Frontier::heap}, {"delta", Frontier::delta}, {"regions", Frontier::regions}};

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <limits>

#include "tools/cli/cli_fwd.h"

namespace geolloyd {

// Each makes an option take numbers of one kind only: CLI11 by itself reads 010 as eight, -1 as a
// huge number, and nan as any other.

/// From `least` to `most`, in decimal digits.
CLI::Option* whole_number(CLI::Option* option, std::uint64_t least,
                          std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
/// Above 0, like 800M, 8G or 8GiB; the option itself gets the number of bytes.
CLI::Option* byte_count(CLI::Option* option);
/// Above 0, and finite.
CLI::Option* positive_number(CLI::Option* option);
/// 0 or more, and finite.
CLI::Option* time_in_seconds(CLI::Option* option);

}  // namespace geolloyd

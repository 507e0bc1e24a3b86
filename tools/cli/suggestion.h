#pragma once

#include <span>
#include <string>
#include <string_view>

namespace geolloyd {

/// Which of the names a mistyped word was probably meant to be: the first of those that differ from
/// it by the fewest letters inserted, left out, replaced or swapped with their neighbour. Empty
/// where all differ by more than a third of the word.
std::string closest_name(std::string_view word, std::span<const std::string> names);

}  // namespace geolloyd

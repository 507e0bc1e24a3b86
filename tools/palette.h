#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace geolloyd {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// Colours that are easy to tell apart side by side.
inline constexpr std::array<Colour, 8> palette = {{{78, 121, 167},
                                                   {242, 142, 43},
                                                   {89, 161, 79},
                                                   {225, 87, 89},
                                                   {176, 122, 161},
                                                   {237, 201, 72},
                                                   {118, 183, 178},
                                                   {156, 117, 95}}};
inline constexpr std::uint32_t palette_size = palette.size();
inline constexpr Colour no_region_colour = {128, 128, 128};

/// The palette, and beyond it pastel hues a golden angle apart.
inline Colour palette_colour(std::uint32_t number) {
  if (number < palette_size) return palette[number];
  const double hue = 2.399963229728653 * number;
  const auto channel = [hue](double phase) {
    return static_cast<std::uint8_t>(160 + 90 * std::cos(hue + phase));
  };
  return {channel(0), channel(2.0944), channel(4.1888)};
}

}  // namespace geolloyd

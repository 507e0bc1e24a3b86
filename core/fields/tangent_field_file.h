#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/fields/tangent_field.h"

namespace geolloyd {

/// One space per vertex, from a .vfield file: any header lines, then the line of column names "k1
/// k2 k1v_x ...", then eight numbers per vertex (two magnitudes, tangent, bitangent). Throws
/// InvalidInput naming the line where something is malformed, missing or too much.
std::vector<TangentSpace> read_tangent_field(const std::filesystem::path& path,
                                             std::size_t vertex_count);
/// What it makes of a file that holds `text`; `name` opens every message.
std::vector<TangentSpace> parse_tangent_field(std::string_view text, std::string_view name,
                                              std::size_t vertex_count);

}  // namespace geolloyd

#pragma once

#include <filesystem>

#include "tools/run_record.h"

namespace geolloyd {

/// A PNG of the tessellation: regions in the colours of tessellation.ply, borders between them,
/// seeds as dots, on a transparent ground. Seen from the side, a little from above: along the
/// shortest side of the bounding box, with the middle one upright.
void write_picture(const std::filesystem::path& path, const RunRecord& run);

}  // namespace geolloyd

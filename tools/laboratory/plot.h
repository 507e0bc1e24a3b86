#pragma once

#include <filesystem>

namespace geolloyd {

/// Has bench/plot.py draw a result file into pictures beside it; it prints their names, or on
/// standard error what it lacks. No picture is no failure: it can be drawn later.
void draw_plot(const std::filesystem::path& result_file);

}  // namespace geolloyd

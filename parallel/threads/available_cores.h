#pragma once

#include <cstddef>
#include <filesystem>

namespace geolloyd {

/// How many threads of this process can run at once, 1 at least: as many as there are cores that it
/// may run on, or fewer where its control groups grant it less.
std::size_t available_cores();

/// How many whole cores the control groups grant, 1 at least; the largest number where they set no
/// limit. `root` is for tests.
std::size_t granted_cores(const std::filesystem::path& root = "/");

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <filesystem>

namespace geolloyd {

// What the system says of memory, bytes; the largest number where nothing is known or limited.

/// What it can give: MemAvailable, or less where a control group (version 1 or 2) or the shell
/// (ulimit) allows less. `root` is for tests.
std::uint64_t available_memory(const std::filesystem::path& root = "/");

/// What this process may still reserve, used or not, once it asks for all that the shell allows.
std::uint64_t reservable_memory();

/// What RLIMIT_DATA counts of this process now; 0 where that is not known.
std::uint64_t data_held();

}  // namespace geolloyd

#pragma once

#include <filesystem>

namespace geolloyd {

/// Keeps other runs from writing into this folder until the process ends, however it ends; nothing
/// is left in the folder. Locking it again does nothing, nor does locking where a file system knows
/// no locks or the folder cannot be opened. Throws InvalidInput where another run has locked it.
void lock_folder(const std::filesystem::path& folder);

}  // namespace geolloyd

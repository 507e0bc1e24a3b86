#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace geolloyd {

/// That a file can be written, and would not replace one of `others`. Throws Error.
void check_target(const std::filesystem::path& target,
                  std::span<const std::filesystem::path> others);

/// Makes the folder, locks it (folder_lock.h) and checks each target in it, before hours of work
/// depend on it.
void prepare_folder(const std::filesystem::path& folder, std::span<const char* const> names,
                    std::span<const std::filesystem::path> others);

/// Where there is one.
void remove_file(const std::filesystem::path& path);

/// Replaces a file as a whole.
void write_text_file(const std::filesystem::path& path, const std::string& text);

}  // namespace geolloyd

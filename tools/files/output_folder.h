#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace geolloyd {

/// That a file can be written, and would not replace one of `others`. Throws Error.
void check_target(const std::filesystem::path& target,
                  std::span<const std::filesystem::path> others);

/// The folders that a command made for its results. At the end of its life those that are still
/// empty go: a command that fails leaves nothing behind.
class MadeFolders {
 public:
  MadeFolders() = default;
  MadeFolders(MadeFolders&&) = default;
  MadeFolders& operator=(MadeFolders&&) = delete;
  ~MadeFolders();

  /// Makes a folder and all above it that are missing. Throws IoError.
  void make(const std::filesystem::path& folder);
  /// Takes over what another has made.
  void add(MadeFolders&& more);

 private:
  std::vector<std::filesystem::path> made_;  // absolute; what is above comes first
};

/// Makes the folder, locks it (folder_lock.h) and checks each target in it, before hours of work
/// depend on it.
[[nodiscard]] MadeFolders prepare_folder(const std::filesystem::path& folder,
                                         std::span<const char* const> names,
                                         std::span<const std::filesystem::path> others);

/// Where there is one.
void remove_file(const std::filesystem::path& path);

/// Replaces a file as a whole.
void write_text_file(const std::filesystem::path& path, const std::string& text);

}  // namespace geolloyd

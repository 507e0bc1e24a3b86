#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "core/text/file_writer.h"
#include "tools/files/mesh_target.h"

namespace geolloyd {

/// Files that appear together, once all of them are complete, or not at all. What was there under
/// their names stays until then. The last one appears last, and where there are several, what it
/// replaces goes before all else: whoever finds it finds all files of one run.
class FileGroup {
 public:
  explicit FileGroup(std::span<const std::filesystem::path> paths);
  /// A mesh first, then others.
  FileGroup(const MeshTarget& mesh, std::span<const std::filesystem::path> others);
  /// In one folder.
  FileGroup(const std::filesystem::path& folder, std::span<const char* const> names);

  /// Of the n-th name.
  FileWriter& operator[](std::size_t n) { return *files_[n]; }

  /// Writes all there is to write, so that nothing but their appearing is left.
  void finish();
  /// Finishes, if that has not been done.
  void commit();

 private:
  std::vector<std::unique_ptr<FileWriter>> files_;
};

}  // namespace geolloyd

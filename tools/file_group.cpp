#include "tools/file_group.h"

#include <system_error>

#include "core/errors.h"

namespace geolloyd {

FileGroup::FileGroup(const std::filesystem::path& folder, std::span<const char* const> names) {
  for (const char* name : names) files_.push_back(std::make_unique<FileWriter>(folder / name));
}

void FileGroup::commit() {
  for (const auto& file : files_) file->finish();
  const std::filesystem::path& last = files_.back()->path();
  std::error_code error;
  std::filesystem::remove(last, error);
  if (error) throw IoError(last.string() + ": cannot replace: " + error.message());
  for (const auto& file : files_) file->commit();
}

}  // namespace geolloyd

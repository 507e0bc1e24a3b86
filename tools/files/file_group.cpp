#include "tools/files/file_group.h"

#include "tools/files/output_folder.h"

namespace geolloyd {

FileGroup::FileGroup(const std::filesystem::path& folder, std::span<const char* const> names) {
  for (const char* name : names) files_.push_back(std::make_unique<FileWriter>(folder / name));
}

void FileGroup::commit() {
  for (const auto& file : files_) file->finish();
  remove_file(files_.back()->target());
  for (const auto& file : files_) file->commit();
}

}  // namespace geolloyd

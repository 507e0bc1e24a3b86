#include "tools/files/file_group.h"

#include "tools/files/output_folder.h"

namespace geolloyd {

FileGroup::FileGroup(std::span<const std::filesystem::path> paths) {
  for (const auto& path : paths) files_.push_back(std::make_unique<FileWriter>(path));
}

FileGroup::FileGroup(const MeshTarget& mesh, std::span<const std::filesystem::path> others) {
  files_.push_back(open_target(mesh));
  for (const auto& path : others) files_.push_back(std::make_unique<FileWriter>(path));
}

FileGroup::FileGroup(const std::filesystem::path& folder, std::span<const char* const> names) {
  for (const char* name : names) files_.push_back(std::make_unique<FileWriter>(folder / name));
}

void FileGroup::finish() {
  for (const auto& file : files_) file->finish();
}

void FileGroup::commit() {
  finish();
  if (files_.size() > 1) remove_file(files_.back()->target());
  for (const auto& file : files_) file->commit();
}

}  // namespace geolloyd

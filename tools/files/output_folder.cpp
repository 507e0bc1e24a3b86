#include "tools/files/output_folder.h"

#include <unistd.h>

#include <system_error>

#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tools/files/folder_lock.h"

namespace geolloyd {
namespace {

// Also where the last part of it does not exist, and whatever the folder is called.
std::filesystem::path place_of(const std::filesystem::path& path, std::error_code& error) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
}

}  // namespace

void check_target(const std::filesystem::path& target,
                  std::span<const std::filesystem::path> others) {
  const OutputFile probe(target);
  std::error_code error;
  for (const std::filesystem::path& other : others) {
    if (other.empty()) continue;
    if (std::filesystem::equivalent(target, other, error) ||
        place_of(target, error) == place_of(other, error)) {
      throw InvalidInput(other.string() + ": would be overwritten: write somewhere else");
    }
  }
}

// A folder that holds anything is not removed.
MadeFolders::~MadeFolders() {
  for (; !made_.empty(); made_.pop_back()) (void)::rmdir(made_.back().c_str());
}

void MadeFolders::make(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(folder, error);
  std::filesystem::path above;
  for (const std::filesystem::path& name : whole) {
    above /= name;
    if (!std::filesystem::exists(std::filesystem::symlink_status(above, error))) {
      made_.push_back(above);
    }
  }
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(folder.string() + ": cannot make folder: " + error.message());
}

void MadeFolders::add(MadeFolders&& more) {
  made_.insert(made_.end(), more.made_.begin(), more.made_.end());
  more.made_.clear();
}

MadeFolders prepare_folder(const std::filesystem::path& folder, std::span<const char* const> names,
                           std::span<const std::filesystem::path> others) {
  MadeFolders made;
  made.make(folder);
  lock_folder(folder);
  for (const char* name : names) check_target(folder / name, others);
  return made;
}

void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw IoError(path.string() + ": cannot remove: " + error.message());
}

void write_text_file(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace geolloyd

#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace geolloyd {

/// The whole file, or all that comes through a pipe. Throws IoError (missing, a directory, a
/// device, unreadable), naming it.
std::string read_file(const std::filesystem::path& path);

/// A file that appears whole or not at all: written under a temporary name beside `path`, complete
/// after finish(), renamed by commit(), removed if the object goes before that. Throws IoError;
/// also where `path` is a folder, a device or a pipe.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view bytes);
  /// Nothing is written after this.
  void finish();
  /// Finishes, if that has not been done.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::unique_ptr<std::FILE, Close> file_;  // none once it is finished
  bool is_committed_ = false;
};

}  // namespace geolloyd

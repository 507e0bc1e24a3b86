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
/// The same of standard input, which messages call `name`.
std::string read_standard_input(const std::string& name);

/// A file that appears whole, by commit(), or not at all. Until then it has no name, so that
/// nothing is left of it however the program ends. It has a temporary name beside its place,
/// .geolloyd-PROCESS-N.part, for a moment in commit() where it replaces another file, and all the
/// time on a file system that has no unnamed files; that one is removed with the object. It has the
/// mode of the file that it replaces. Where `path` is a symbolic link it takes the place of what
/// that points to. It is complete after finish(). Throws IoError, also where `path` is a folder, a
/// device or a pipe, or can be no name.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  /// What an open descriptor leads to, such as a pipe: no name is its own, so all that is written
  /// goes there as it comes, and commit() only finishes. Messages call it `name`.
  OutputFile(int descriptor, const std::string& name);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Where the file will be: `path`, or what it links to.
  [[nodiscard]] const std::filesystem::path& target() const { return target_; }

  void write(std::string_view bytes);
  /// Brings to the disk what was written. Where that is all, even a loss of power leaves the old
  /// file or the new one.
  void sync();
  /// Nothing is written after this.
  void finish();
  /// Finishes, if that has not been done.
  void commit();

 private:
  void open();
  template <class Make>
  void make_temporary(const Make& make);

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path path_;  ///< as given, for messages
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::unique_ptr<std::FILE, Close> file_;
  bool has_name_ = false;  ///< temporary_
  bool is_stream_ = false;
};

}  // namespace geolloyd

#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/compression.h"
#include "core/text/file_io.h"

namespace geolloyd {

/// An OutputFile for many small pieces, text or binary. Numbers do not depend on the locale. Where
/// the name ends in ".gz" or ".zst" the file is packed.
class FileWriter {
 public:
  explicit FileWriter(std::filesystem::path path)
      : path_(std::move(path)), file_(path_), packer_(make_packer(path_, file_)) {}
  /// Onto an open descriptor (file_io.h), and not packed.
  FileWriter(int descriptor, const std::string& name) : path_(name), file_(descriptor, name) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where the file will be: path(), or what it links to.
  [[nodiscard]] const std::filesystem::path& target() const { return file_.target(); }

  void text(std::string_view text) {
    if (text.size() > buffer_.size()) {
      flush();
      write(text);
      return;
    }
    text.copy(room(text.size()), text.size());  // none of none, where memcpy wants a place
    used_ += text.size();
  }

  /// The shortest text that reads back as the same number.
  template <class Number>
  void number(Number number) {
    constexpr std::size_t longest = 32;
    char* const begin = room(longest);
    used_ += static_cast<std::size_t>(std::to_chars(begin, begin + longest, number).ptr - begin);
  }

  /// Little endian.
  template <class Number>
  void raw(Number number) {
    char* const begin = room(sizeof(Number));
    std::memcpy(begin, &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) {
      std::reverse(begin, begin + sizeof(Number));
    }
    used_ += sizeof(Number);
  }

  void finish() {
    flush();
    if (packer_) packer_->finish();
    packer_.reset();
    file_.finish();
  }

  /// Finishes, if that has not been done.
  void commit() {
    finish();
    file_.commit();
  }

 private:
  // Where `bytes` more may be put, no more than the buffer holds.
  char* room(std::size_t bytes) {
    if (buffer_.size() - used_ < bytes) flush();
    return buffer_.data() + used_;
  }

  void flush() {
    if (used_ == 0) return;
    write({buffer_.data(), used_});
    used_ = 0;
  }

  void write(std::string_view bytes) {
    if (packer_) {
      packer_->write(bytes);
    } else {
      file_.write(bytes);
    }
  }

  std::filesystem::path path_;
  OutputFile file_;
  std::unique_ptr<Packer> packer_;  ///< null: not packed
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 18);
  std::size_t used_ = 0;
};

}  // namespace geolloyd

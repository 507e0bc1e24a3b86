#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/formats/mesh_readers.h"
#include "core/text/text_cursor.h"

namespace geolloyd {

/// The numbers of a section of a Gmsh file, as words of text or as bytes, and complaints that name
/// their line or byte.
class GmshNumbers {
 public:
  /// From `begin` on; `is_binary`: bytes in the given order.
  GmshNumbers(std::string_view file, std::size_t begin, std::string_view name, bool is_binary,
              std::endian order)
      : file_(file),
        name_(name),
        is_binary_(is_binary),
        order_(order),
        offset_(begin),
        text_(file.substr(begin), name, line_of(file, begin, is_binary)) {
    text_.pass_line_ends(true);
  }

  /// Of 4 bytes.
  std::int64_t integer(std::string_view what) {
    return is_binary_ ? std::int64_t{next<std::int32_t>()} : text_.integer(what);
  }
  /// Of 8 bytes; never negative.
  std::uint64_t size(std::string_view what) {
    const std::int64_t size = is_binary_ ? next<std::int64_t>() : text_.integer(what);
    if (size < 0) fail(std::string(what) + " is negative: " + std::to_string(size));
    return static_cast<std::uint64_t>(size);
  }
  double coordinate() {
    if (!is_binary_) return parse_coordinate(text_, text_.word());
    const auto number = next<double>();
    if (!is_usable(number)) fail(bad_coordinate(number));
    return number;
  }
  void skip_reals(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (is_binary_) (void)next<double>();
      if (!is_binary_) (void)text_.real("a parameter");
    }
  }
  /// A count in text, which a line end ends where bytes follow.
  std::uint64_t count_in_text(std::string_view what) {
    TextCursor text(file_.substr(offset_), name_, text_.line());
    const std::int64_t count = text.integer(what);
    if (count < 0) text.fail(std::string(what) + " is negative: " + std::to_string(count));
    text.next_line();
    offset_ = file_.size() - text.remaining();
    if (!is_binary_) text_ = text;
    text_.pass_line_ends(true);
    return static_cast<std::uint64_t>(count);
  }

  /// Nobody should take memory for a promise that the file does not keep: `count` items of so many
  /// numbers, or bytes.
  void check_count(std::uint64_t count, std::size_t words, std::size_t bytes,
                   const std::string& what) const {
    const std::size_t left = is_binary_ ? file_.size() - offset_ : text_.remaining();
    const std::uint64_t fitting = is_binary_ ? left / bytes : (left + 1) / (2 * words);
    if (count <= fitting) return;
    fail(std::to_string(count) + " " + what + " are promised, but the file ends after " +
         std::to_string(left) + " more bytes");
  }

  [[noreturn]] void fail(const std::string& message) const {
    if (!is_binary_) text_.fail(message);
    fail_at_byte(name_, offset_, message);
  }

 private:
  static std::size_t line_of(std::string_view file, std::size_t offset, bool is_binary) {
    if (is_binary) return 1;
    const std::string_view before = file.substr(0, offset);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }

  template <class Number>
  Number next() {
    if (sizeof(Number) > file_.size() - offset_) fail("the file ends inside a section");
    const auto number = load<Number>(file_.data() + offset_, order_);
    offset_ += sizeof(Number);
    return number;
  }

  std::string_view file_;
  std::string_view name_;
  bool is_binary_;
  std::endian order_;
  std::size_t offset_;
  TextCursor text_;
};

}  // namespace geolloyd

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/mesh_readers.h"
#include "core/formats/ply/ply_header.h"

namespace geolloyd {

/// The least number of bytes that a row of the element takes in a binary file.
inline std::size_t least_row_size(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    size += size_of(property.count_type ? PlyNumber(*property.count_type) : property.type);
  }
  return size;
}

/// Properties that nobody wants, as what is to be stepped over: lists, each with the bytes before
/// it, and the bytes after the last.
struct PlyGap {
  struct List {
    std::size_t bytes_before;
    PlyInteger count_type;
    std::size_t item_size;
  };

  explicit PlyGap(std::span<const PlyProperty> properties) {
    for (const PlyProperty& property : properties) {
      const std::size_t size = size_of(property.type);
      if (property.count_type) {
        lists.push_back({std::exchange(bytes, 0), *property.count_type, size});
      } else {
        bytes += size;
      }
    }
  }

  std::vector<List> lists;
  std::size_t bytes = 0;
};

/// The body of a binary file. Every step is checked against its end.
class PlyBody {
 public:
  PlyBody(std::string_view file, std::size_t offset, std::string_view name, std::endian order)
      : file_(file), name_(name), order_(order), offset_(offset) {}

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t remaining() const { return file_.size() - offset_; }
  [[nodiscard]] std::endian order() const { return order_; }
  void rewind(std::size_t offset) { offset_ = offset; }

  /// Nobody should take memory for a promise that the file does not keep.
  void check_count(const PlyElement& element) const {
    if (element.count <= remaining() / least_row_size(element)) return;
    fail_at_byte(name_, offset_,
                 std::to_string(element.count) + " rows of element " + in_quotes(element.name) +
                     " are promised, but the file ends after " + std::to_string(remaining()) +
                     " more bytes");
  }

  /// Passes over all rows of an element. visit(row) finds the body before the value of the wanted
  /// property, and has to read it.
  template <class Visit>
  void for_each_row(const PlyElement& element, std::size_t wanted, Visit visit) {
    const PlyGap before(std::span(element.properties).first(wanted));
    const PlyGap after(std::span(element.properties).subspan(wanted + 1));
    for (std::size_t row = 0; row < element.count; ++row) {
      row_offset_ = offset_;
      skip(before);
      visit(row);
      skip(after);
    }
  }

  void skip_rows(const PlyElement& element) {
    const PlyGap all(element.properties);
    for (std::size_t row = 0; row < element.count; ++row) {
      row_offset_ = offset_;
      skip(all);
    }
  }

  template <class Number>
  Number next() {
    return load<Number>(take(sizeof(Number)), order_);
  }

  const char* take(std::size_t bytes) {
    if (bytes > remaining()) fail("the file ends inside the row that begins here");
    return file_.data() + std::exchange(offset_, offset_ + bytes);
  }

  /// Names the byte where the current row begins.
  [[noreturn]] void fail(const std::string& message) const {
    fail_at_byte(name_, row_offset_, message);
  }

 private:
  void skip(const PlyGap& gap) {
    for (const PlyGap::List& list : gap.lists) {
      take(list.bytes_before);
      const auto next_count = [&](auto zero) { return std::int64_t{next<decltype(zero)>()}; };
      const std::int64_t count = std::visit(next_count, list.count_type);
      if (count < 0) fail(bad_list_length(count));
      take(static_cast<std::size_t>(count) * list.item_size);
    }
    take(gap.bytes);
  }

  std::string_view file_;
  std::string_view name_;
  std::endian order_;
  std::size_t offset_;
  std::size_t row_offset_ = 0;
};

}  // namespace geolloyd

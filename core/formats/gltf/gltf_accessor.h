#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/gltf/gltf_document.h"

namespace geolloyd {

/// Numbers of a glTF file: rows of 1 to 4, at some stride in a buffer view, some of them replaced
/// (sparse).
class GltfAccessor {
 public:
  /// Checks that all rows are there. `document` must live on.
  GltfAccessor(GltfDocument& document, std::size_t index);

  [[nodiscard]] const std::string& what() const { return what_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Numbers in a row.
  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] bool is_integer() const { return type_ != float_type; }

  /// All rows, one after the other. Integers that are shares (normalized) become numbers from 0 or
  /// -1 to 1.
  [[nodiscard]] std::vector<double> values() const;
  /// Of rows of one unsigned integer.
  [[nodiscard]] std::vector<std::uint32_t> indices() const;

 private:
  static constexpr std::uint64_t float_type = 5126;

  // Where rows lie.
  struct Rows {
    std::string_view bytes;  ///< empty: all are 0
    std::size_t stride = 0;
  };

  [[nodiscard]] Rows find_rows(const nlohmann::json& object, std::uint64_t count,
                               std::size_t row_size, const std::string& what) const;
  void read_sparse(const nlohmann::json& sparse);
  template <class Visit>
  void for_each_row(Visit&& visit) const;

  GltfDocument& document_;
  std::string what_;
  std::uint64_t type_ = float_type;
  std::size_t width_ = 1;
  std::size_t count_ = 0;
  bool is_normalized_ = false;
  Rows rows_;
  std::vector<std::uint32_t> replaced_;  ///< rows, ascending
  Rows replacements_;
};

}  // namespace geolloyd

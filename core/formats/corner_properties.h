#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"
#include "geolloyd/properties.h"

namespace geolloyd {

// What text formats tell beside positions becomes properties here; shared by the readers.

/// Rows of numbers that corners of faces name, as OBJ's texture coordinates and normals. They
/// become properties of vertices where each vertex has the same row in all faces.
class CornerProperties {
 public:
  /// `what` is told people, `names` are those of the properties.
  CornerProperties(std::string what, std::vector<std::string> names)
      : what_(std::move(what)), names_(std::move(names)) {}

  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }
  void add_row(const std::array<double, 3>& row) { rows_.push_back(row); }
  /// `row`: may come later. `line`: of the file.
  void add_corner(VertexId vertex, std::uint32_t row, std::size_t line) {
    if (line_of_highest_ == 0 || row > highest_) {
      highest_ = row;
      line_of_highest_ = line;
    }
    corners_.push_back({vertex, row});
  }
  void add_corner_without() { ++corners_without_; }
  /// The highest row that a corner names, and its line; line 0: there is none.
  [[nodiscard]] std::pair<std::size_t, std::size_t> highest_row() const {
    return {highest_, line_of_highest_};
  }

  /// Adds the properties, or why there are none. All rows that corners name are there by now. Of
  /// vertices without a face the numbers are no numbers.
  void finish(std::size_t vertex_count, Properties& properties);

 private:
  struct Corner {
    VertexId vertex;
    std::uint32_t row;
  };

  std::string what_;
  std::vector<std::string> names_;
  std::vector<std::array<double, 3>> rows_;
  std::vector<Corner> corners_;
  std::size_t corners_without_ = 0;
  std::uint32_t highest_ = 0;
  std::size_t line_of_highest_ = 0;
};

/// Colours as text formats give them, for each item or not: three or four numbers.
class TextColours {
 public:
  /// `what` is "vertices" or "faces".
  explicit TextColours(std::string what) : what_(std::move(what)) {}

  /// Those of the next item. Only the first `count` numbers are such; 3, 4, or 0 for none.
  void add(const std::array<double, 4>& colour, std::size_t count);

  /// Adds red, green, blue and, where all have it, alpha; or says why not. Numbers that are all
  /// whole and up to 255 with one above 1, or all so many 255ths to four digits, become bytes;
  /// others stay as they are.
  void finish(std::vector<Property>& properties, std::vector<std::string>& left_out);

 private:
  [[nodiscard]] bool are_whole() const;
  [[nodiscard]] bool are_shares_of_255() const;

  std::string what_;
  std::array<std::vector<double>, 4> parts_;
  std::size_t items_ = 0;  ///< all
};

}  // namespace geolloyd

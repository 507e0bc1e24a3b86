#pragma once

#include <string>
#include <vector>

namespace geolloyd {

/// Rows of text for people, in columns as wide as they need.
class TextTable {
 public:
  /// The first `left` columns hold words, flush left, the others numbers, flush right.
  TextTable(std::vector<std::string> heads, std::size_t left)
      : left_(left), rows_{std::move(heads)} {}

  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] std::string text() const;

 private:
  std::size_t left_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace geolloyd

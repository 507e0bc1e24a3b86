#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geolloyd {

/// Walks through a text file word by word, knowing its line, so that every complaint can name it. A
/// byte order mark at its beginning is passed over. Words are separated by blanks; lines end with
/// "\n", "\r\n" or "\r". Numbers are read in the "C" locale, whatever the program's.
class TextCursor {
 public:
  /// Both views must outlive the cursor; `name` opens every message.
  TextCursor(std::string_view text, std::string_view name, std::size_t first_line = 1);

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }
  /// Bytes from here to the end of the text.
  [[nodiscard]] std::size_t remaining() const { return text_.size() - position_; }

  /// Skips blanks; true where nothing else stands on this line, or only what begins with `comment`.
  bool at_line_end(char comment = '\0');
  /// To the start of the next line, whatever is left of this one.
  void next_line();
  /// Skips blank lines, and lines that begin with `comment` unless that is 0.
  void skip_empty_lines(char comment = '\0');

  /// Has words follow each other whatever lines they stand on, or (false) ends them at a line's end
  /// again. What stands behind `comment` up to the end of a line is skipped.
  void pass_line_ends(bool passes, char comment = '\0') {
    passes_line_ends_ = passes;
    comment_ = comment;
  }

  /// The next word on this line, empty at its end; where line ends are passed, empty at the end of
  /// the text.
  std::string_view word();
  /// The next word as a number; fails where it is none. `what` names it in the message.
  double real(std::string_view what);
  std::int64_t integer(std::string_view what);

  /// Throws InvalidInput "NAME: line N: MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
  /// "expected WHAT, found 'WORD'", or what a line or a file that ends here calls for.
  [[noreturn]] void fail_expected(std::string_view what, std::string_view word) const;

 private:
  std::string_view text_;
  std::string_view name_;
  std::size_t position_ = 0;
  std::size_t line_;
  bool passes_line_ends_ = false;
  char comment_ = '\0';
};

/// With the letters A to Z made small, whatever the locale.
std::string lower_case(std::string_view word);

/// The whole of `word` as a number, or nothing. Accepts a leading '+'. "nan" and "inf" are numbers
/// here; what a double or 64 bits cannot hold is none.
std::optional<double> parse_real(std::string_view word);
std::optional<std::int64_t> parse_integer(std::string_view word);

/// `word` in quotes, fit for a message of one line: printable, and cut where it is long.
std::string in_quotes(std::string_view word);

}  // namespace geolloyd

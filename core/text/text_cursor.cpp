#include "core/text/text_cursor.h"

#include <charconv>
#include <system_error>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

bool ends_line(char c) {
  return c == '\n' || c == '\r';
}

// A blank, a tab, or one of the four line and page ends that follow the tab.
bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

template <class Number>
std::optional<Number> parse(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return {};
  }
  Number number{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || stop != end) return {};
  return number;
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string_view name, std::size_t first_line)
    : text_(text), name_(name), line_(first_line) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(byte_order_mark)) position_ = byte_order_mark.size();
}

bool TextCursor::at_line_end(char comment) {
  while (!at_end() && is_space(text_[position_]) && !ends_line(text_[position_])) ++position_;
  if (at_end() || ends_line(text_[position_])) return true;
  return comment != '\0' && text_[position_] == comment;
}

void TextCursor::next_line() {
  while (!at_end() && !ends_line(text_[position_])) ++position_;
  if (at_end()) return;
  position_ += text_.substr(position_).starts_with("\r\n") ? 2 : 1;
  ++line_;
}

void TextCursor::skip_empty_lines(char comment) {
  while (!at_end() && at_line_end(comment)) next_line();
}

std::string_view TextCursor::word() {
  if (passes_line_ends_) skip_empty_lines(comment_);
  if (at_line_end()) return {};
  const std::size_t start = position_;
  while (!at_end() && !is_space(text_[position_])) ++position_;
  return text_.substr(start, position_ - start);
}

double TextCursor::real(std::string_view what) {
  const std::string_view found = word();
  if (const auto number = parse_real(found)) return *number;
  fail_expected(what, found);
}

std::int64_t TextCursor::integer(std::string_view what) {
  const std::string_view found = word();
  if (const auto number = parse_integer(found)) return *number;
  fail_expected(what, found);
}

void TextCursor::fail(const std::string& message) const {
  throw InvalidInput(std::string(name_) + ": line " + std::to_string(line_) + ": " + message);
}

void TextCursor::fail_expected(std::string_view what, std::string_view word) const {
  const std::string expected = "expected " + std::string(what) + ", found ";
  if (!word.empty()) fail(expected + in_quotes(word));
  fail(expected + (at_end() ? "the end of the file" : "the end of the line"));
}

std::optional<double> parse_real(std::string_view word) {
  return parse<double>(word);
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  return parse<std::int64_t>(word);
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, longest)) text += (c >= ' ' && c <= '~') ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

}  // namespace geolloyd

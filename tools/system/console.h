#pragma once

#include <string>

namespace geolloyd {

/// What a command prints when it is done: text for people, unless one of the first two was called.
/// A process has one, for both lead its standard output elsewhere.
class Console {
 public:
  /// Nothing but errors.
  void silence();
  /// JSON alone, which print_json() prints, on the standard output. Throws IoError where it is
  /// closed.
  void want_json();

  [[nodiscard]] bool is_silent() const { return is_silent_; }
  [[nodiscard]] bool wants_json() const { return standard_output_ >= 0; }
  /// To be called where JSON is wanted. Throws IoError where it cannot be printed.
  void print_json(const std::string& text) const;

 private:
  bool is_silent_ = false;
  int standard_output_ = -1;  // where stdout led to, once that is silent for the sake of JSON
};

/// Prints lines on standard error, after what stands on standard output. Not where JSON is wanted,
/// which has them, nor where errors alone are, unless the warnings are errors (`is_strict`).
void tell_warnings(const std::string& lines, bool is_strict, const Console& console);

}  // namespace geolloyd

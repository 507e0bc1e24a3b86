#pragma once

#include <string>

namespace geolloyd {

/// What a command prints when it is done: text for people, unless one of the first two was called.
/// A process has one, for all lead its standard output elsewhere.
class Console {
 public:
  /// Nothing but errors.
  void silence();
  /// JSON alone, which print_json() prints, on the standard output. Throws IoError where it is
  /// closed.
  void want_json();

  /// The descriptor of standard output, for a mesh. What else is printed goes to standard error. A
  /// reader that ends too soon no longer ends the process: writing fails. Throws InvalidInput where
  /// JSON is wanted, IoError where standard output is closed.
  int lend_standard_output();

  [[nodiscard]] bool is_silent() const { return is_silent_; }
  [[nodiscard]] bool wants_json() const { return wants_json_; }
  /// To be called where JSON is wanted. Throws IoError where it cannot be printed.
  void print_json(const std::string& text) const;

 private:
  void keep_standard_output();

  bool is_silent_ = false;
  bool wants_json_ = false;
  int standard_output_ = -1;  // where stdout led to, once it leads elsewhere
};

/// Prints lines on standard error, after what stands on standard output. Not where JSON is wanted,
/// which has them, nor where errors alone are, unless the warnings are errors (`is_strict`).
void tell_warnings(const std::string& lines, bool is_strict, const Console& console);

}  // namespace geolloyd

#pragma once

#include <string>

namespace geolloyd {

// What a command prints when it is done: text for people, unless one of these was called.

/// Nothing but errors.
void silence();
bool is_silent();

/// JSON alone, which print_json() prints, on the standard output.
void want_json();
bool wants_json();
/// Throws IoError where it cannot be printed.
void print_json(const std::string& text);

}  // namespace geolloyd

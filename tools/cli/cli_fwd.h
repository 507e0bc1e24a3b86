#pragma once

// CLI11 is large: headers that only name the program, a command or an option include this instead.
namespace CLI {  // NOLINT(readability-identifier-naming): its name
class App;
class Option;
}  // namespace CLI

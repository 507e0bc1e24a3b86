#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "geolloyd/errors.h"

/// What libFuzzer, and replay.cpp, calls with each input. Returns 0, or -1 where an input should
/// not be kept. Whatever it should not find ends the process.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace geolloyd::fuzz {

/// What files without a file are called.
inline constexpr std::string_view input_name = "input";

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process, for a fuzzer to notice, where `holds` is false.
inline void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

/// One line that opens with the file's name, prints as it is, and is not as long as the file.
inline void require_good_message(std::string_view message) {
  require(message.starts_with(input_name), "a message opens with the file's name");
  require(message.size() < 400, "a message is short");
  for (const char c : message) require(c >= ' ' && c <= '~', "a message is one line that prints");
}

/// What parse() returns, or nothing where it refuses the input in a decent way. Other exceptions
/// are findings.
template <class Parse>
auto if_accepted(Parse&& parse) -> std::optional<decltype(parse())> {
  try {
    return parse();
  } catch (const InvalidInput& error) {
    require_good_message(error.what());
    return {};
  }
}

}  // namespace geolloyd::fuzz

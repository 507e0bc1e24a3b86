#pragma once

#include <string>
#include <type_traits>

#include "core/text/file_writer.h"
#include "tools/files/json.h"

namespace geolloyd {

// Comma-separated values: row by row for tables as long as a mesh, at once for small ones.

/// Writes one row.
template <class First, class... Rest>
void write_row(FileWriter& out, const First& first, const Rest&... rest) {
  if constexpr (std::is_arithmetic_v<First>) {
    out.number(first);
  } else {
    out.text(first);
  }
  out.text(sizeof...(rest) == 0 ? "\n" : ",");
  if constexpr (sizeof...(rest) > 0) write_row(out, rest...);
}

/// An array of objects with the same keys as a table: {"a": {"b": 1}, "c": null} becomes the
/// columns a_b and c, the latter empty.
std::string csv_text(const Json& rows);

}  // namespace geolloyd

#pragma once

#include <string_view>
#include <type_traits>

#include "core/graph/mesh_graph.h"
#include "core/text/file_writer.h"

namespace geolloyd {

// What the tables of results have in common.

/// Writes a line of comma-separated values.
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

/// "vertex" or "triangle".
inline std::string_view kind_of(const MeshGraph& mesh_graph, std::uint32_t input_id) {
  return mesh_graph.is_triangle(input_id) ? "triangle" : "vertex";
}

}  // namespace geolloyd

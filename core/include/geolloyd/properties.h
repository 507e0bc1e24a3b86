#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "geolloyd/types.h"

namespace geolloyd {

/// Numbers of one of the types that PLY has: char to uint, float, double.
using PropertyValues =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<float>, std::vector<double>>;

/// A named number for each vertex or each triangle of a mesh. A vector is several properties, with
/// the names that PLY files have for them: a colour is red, green, blue and perhaps alpha, a normal
/// nx, ny, nz, a place in a texture s, t. Other integers are labels: numbers without a quantity.
struct Property {
  std::string name;  ///< no blanks; no two of the vertices are equal, and no two of the triangles
  PropertyValues values;
};

/// What a mesh has besides its shape.
struct Properties {
  std::vector<Property> of_vertices;   ///< each has a value per vertex
  std::vector<Property> of_triangles;  ///< each has a value per triangle
  std::vector<std::string> left_out;   ///< what a file has besides, and why it is not here
  /// Per triangle: the vertices whose values its corners have, where those of welded vertices
  /// differ. Empty: its own.
  std::vector<std::array<VertexId, 3>> corner_values = {};

  [[nodiscard]] bool empty() const { return of_vertices.empty() && of_triangles.empty(); }
};

}  // namespace geolloyd

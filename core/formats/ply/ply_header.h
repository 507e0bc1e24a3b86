#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/text/text_cursor.h"

namespace geolloyd {

// A number type of a PLY file is a zero of the C++ type, so that std::visit leads to code for it.
using PlyInteger = std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                                std::int32_t, std::uint32_t>;
using PlyNumber = std::variant<PlyInteger, float, double>;

/// Calls visit with the zero of `type`.
template <class Visit>
decltype(auto) visit_number(Visit&& visit, const PlyNumber& type) {
  if (const auto* integer = std::get_if<PlyInteger>(&type)) return std::visit(visit, *integer);
  if (std::holds_alternative<float>(type)) return visit(float{});
  return visit(double{});
}

inline std::size_t size_of(const PlyNumber& type) {
  return visit_number([](auto zero) { return sizeof(zero); }, type);
}

struct PlyProperty {
  std::string name;
  PlyNumber type;                        ///< of the value, or of a list's items
  std::optional<PlyInteger> count_type;  ///< of a list's count; none where it is no list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

/// An element with a list of vertex indices.
struct PlyCorners {
  std::size_t element = 0;
  std::size_t list = 0;  ///< the property
};

struct PlyHeader {
  std::optional<PlyEncoding> encoding;
  std::vector<PlyElement> elements;          ///< in the order of the body
  std::size_t vertex = 0;                    ///< the element "vertex"
  std::array<std::size_t, 3> coordinates{};  ///< the vertex's properties x, y, z
  std::optional<PlyCorners> faces;           ///< the element "face"
  std::optional<PlyCorners> strips;          ///< the element "tristrips"; one of the two is there

  [[nodiscard]] bool has_faces_at(std::size_t element) const {
    return faces && faces->element == element;
  }
  [[nodiscard]] bool has_strips_at(std::size_t element) const {
    return strips && strips->element == element;
  }
};

/// Reads to the end of the header and checks that it describes a mesh.
PlyHeader read_ply_header(TextCursor& text);

}  // namespace geolloyd

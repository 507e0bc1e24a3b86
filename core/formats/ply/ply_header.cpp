#include "core/formats/ply/ply_header.h"

#include <algorithm>

namespace geolloyd {
namespace {

PlyEncoding read_encoding(TextCursor& text) {
  const std::string_view encoding = text.word();
  if (encoding == "ascii") return PlyEncoding::ascii;
  if (encoding == "binary_little_endian") return PlyEncoding::little_endian;
  if (encoding == "binary_big_endian") return PlyEncoding::big_endian;
  text.fail_expected("ascii, binary_little_endian or binary_big_endian", encoding);
}

PlyNumber read_type(TextCursor& text) {
  const std::string_view type = text.word();
  if (type == "float" || type == "float32") return float{};
  if (type == "double" || type == "float64") return double{};
  if (type == "char" || type == "int8") return PlyInteger(std::int8_t{});
  if (type == "uchar" || type == "uint8") return PlyInteger(std::uint8_t{});
  if (type == "short" || type == "int16") return PlyInteger(std::int16_t{});
  if (type == "ushort" || type == "uint16") return PlyInteger(std::uint16_t{});
  if (type == "int" || type == "int32") return PlyInteger(std::int32_t{});
  if (type == "uint" || type == "uint32") return PlyInteger(std::uint32_t{});
  text.fail_expected("a property type (char to uint, float, double, list)", type);
}

PlyInteger read_integer_type(TextCursor& text, const char* use) {
  const PlyNumber type = read_type(text);
  if (const auto* integer = std::get_if<PlyInteger>(&type)) return *integer;
  text.fail(std::string(use) + " must have an integer type");
}

bool is_corner_list(const PlyProperty& property) {
  return property.count_type &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

PlyProperty read_property(TextCursor& text) {
  PlyProperty property;
  const TextCursor before_type = text;
  if (text.word() == "list") {
    property.count_type = read_integer_type(text, "the count of a list");
  } else {
    text = before_type;
  }
  property.type = read_type(text);
  property.name = text.word();
  if (property.name.empty()) text.fail_expected("the name of a property", property.name);
  if (is_corner_list(property) && !std::holds_alternative<PlyInteger>(property.type)) {
    text.fail("vertex indices must have an integer type");
  }
  return property;
}

PlyElement read_element(TextCursor& text) {
  PlyElement element;
  element.name = text.word();
  const std::int64_t count = text.integer("the number of elements");
  if (count < 0) text.fail("the number of elements is negative: " + std::to_string(count));
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

template <class Items, class IsWanted>
std::size_t find_only(const TextCursor& text, const Items& items, const std::string& what,
                      IsWanted is_wanted) {
  const auto count = std::count_if(items.begin(), items.end(), is_wanted);
  if (count == 0) text.fail("the header has no " + what);
  if (count > 1) text.fail("the header has more than one " + what);
  return static_cast<std::size_t>(std::find_if(items.begin(), items.end(), is_wanted) -
                                  items.begin());
}

void find_mesh(const TextCursor& text, PlyHeader& header) {
  const auto find_element = [&](const std::string& name) {
    return find_only(text, header.elements, "element '" + name + "'",
                     [&](const PlyElement& element) { return element.name == name; });
  };
  const auto has_element = [&](std::string_view name) {
    return std::any_of(header.elements.begin(), header.elements.end(),
                       [&](const PlyElement& element) { return element.name == name; });
  };
  const auto find_corners = [&](const std::string& name) {
    const std::size_t element = find_element(name);
    return PlyCorners{element, find_only(text, header.elements[element].properties,
                                         name + " property list 'vertex_indices'", is_corner_list)};
  };
  header.vertex = find_element("vertex");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    header.coordinates[axis] = find_only(
        text, header.elements[header.vertex].properties, "vertex property '" + name + "'",
        [&](const PlyProperty& property) { return property.name == name && !property.count_type; });
  }
  if (has_element("tristrips")) header.strips = find_corners("tristrips");
  if (!header.strips || has_element("face")) header.faces = find_corners("face");
}

// One line of the header; false for its last.
bool read_line(TextCursor& text, PlyHeader& header) {
  const std::string_view keyword = text.word();
  if (keyword == "end_header") return false;
  if (keyword == "format") {
    header.encoding = read_encoding(text);
  } else if (keyword == "element") {
    header.elements.push_back(read_element(text));
  } else if (keyword == "property") {
    if (header.elements.empty()) text.fail("a property before any element");
    header.elements.back().properties.push_back(read_property(text));
  } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
    text.fail_expected("a line of a PLY header", keyword);
  }
  return true;
}

}  // namespace

PlyHeader read_ply_header(TextCursor& text) {
  const std::string_view first = text.word();
  if (first != "ply") text.fail_expected("'ply'", first);
  text.next_line();

  PlyHeader header;
  while (read_line(text, header)) {
    if (text.at_end()) text.fail("the header has no end_header");
    text.next_line();
  }
  if (!header.encoding) text.fail("the header has no format");
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) {
      text.fail("element " + in_quotes(element.name) + " has no properties");
    }
  }
  find_mesh(text, header);
  text.next_line();
  return header;
}

}  // namespace geolloyd

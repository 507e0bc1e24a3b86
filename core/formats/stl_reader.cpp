#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/formats/mesh_readers.h"
#include "core/formats/welder.h"

namespace geolloyd {
namespace {

// 80 bytes of anything, the number of triangles, then for each a normal, three corners and two
// bytes more.
constexpr std::size_t header_size = 84;
constexpr std::size_t triangle_size = 50;

std::size_t promised_size(std::string_view bytes) {
  return header_size + triangle_size * load<std::uint32_t>(bytes.data() + header_size - 4);
}

ParsedMesh read_binary(std::string_view bytes, std::string_view name) {
  if (bytes.size() < header_size) {
    fail_at_byte(name, bytes.size(), "the file ends inside the header of a binary STL");
  }
  const std::size_t size = promised_size(bytes);
  if (bytes.size() < size) {
    fail_at_byte(name, bytes.size(),
                 "the file ends here, but its header promises " +
                     std::to_string((size - header_size) / triangle_size) + " triangles in " +
                     std::to_string(size) + " bytes");
  }
  const std::size_t triangles = (size - header_size) / triangle_size;
  if (!ids_suffice(0, triangles)) fail_at_byte(name, header_size, too_many(0, triangles));
  ParsedMesh loaded;
  loaded.format = "STL, binary";
  loaded.mesh.triangles.reserve(triangles);
  Welder welder(loaded);
  for (std::size_t offset = header_size; offset < size; offset += triangle_size) {
    const char* corner = bytes.data() + offset + 12;
    Triangle triangle{};
    for (VertexId& vertex : triangle) {
      Vec3 position;
      for (double& coordinate : position) {
        coordinate = load<float>(corner);
        if (!is_usable(coordinate)) fail_at_byte(name, offset, bad_coordinate(coordinate));
        corner += sizeof(float);
      }
      vertex = welder.id_of(position);
    }
    loaded.mesh.triangles.push_back(triangle);
  }
  return loaded;
}

ParsedMesh read_ascii(std::string_view bytes, std::string_view name) {
  ParsedMesh loaded;
  loaded.format = "STL, ascii";
  Welder welder(loaded);
  std::vector<VertexId> corners;
  TextCursor text(bytes, name);
  for (text.skip_empty_lines(); !text.at_end(); text.next_line(), text.skip_empty_lines()) {
    const std::string keyword = lower_case(text.word());
    if (keyword == "vertex") {
      corners.push_back(welder.id_of(read_position(text)));
    } else if (keyword == "endloop") {
      if (corners.size() < 3) text.fail(bad_corner_count(std::ssize(corners)));
      add_polygon(loaded, corners);
      corners.clear();
    } else if (keyword != "facet" && keyword != "outer" && keyword != "endfacet" &&
               keyword != "solid" && keyword != "endsolid") {
      text.fail_expected("a line of an ascii STL", keyword);
    }
  }
  if (!corners.empty()) text.fail("the file ends inside a facet");
  return loaded;
}

bool begins_as_ascii(std::string_view bytes, std::string_view name) {
  TextCursor beginning(bytes.substr(0, 1024), name);
  beginning.skip_empty_lines();
  return lower_case(beginning.word()) == "solid";
}

}  // namespace

ParsedMesh read_stl(std::string_view bytes, std::string_view name) {
  // Some binary files begin with "solid" too, but then their size gives them away.
  const bool has_binary_size = bytes.size() >= header_size && bytes.size() == promised_size(bytes);
  if (!has_binary_size) refuse_utf16(bytes, name);
  if (!has_binary_size && begins_as_ascii(bytes, name)) return read_ascii(bytes, name);
  return read_binary(bytes, name);
}

}  // namespace geolloyd

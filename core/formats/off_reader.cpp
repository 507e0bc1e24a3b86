#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

constexpr char comment = '#';

// "OFF" behind what every vertex has besides its position: ST, C, N in any order, all of which
// stands after x y z. "4OFF" and "nOFF" have other positions.
void read_keyword(TextCursor& text) {
  text.skip_empty_lines(comment);
  const std::string_view keyword = text.word();
  const bool is_known =
      keyword.ends_with("OFF") && keyword.find_first_not_of("STCN") == keyword.size() - 3;
  if (!is_known) text.fail_expected("'OFF' with at most ST, C and N before it", keyword);
}

std::string_view first_count(TextCursor& text) {
  std::string_view word = text.word();
  if (word.empty() || word.starts_with(comment)) {
    text.next_line();
    text.skip_empty_lines(comment);
    word = text.word();
  }
  if (word == "BINARY") text.fail("binary OFF is not understood; save the mesh as text");
  return word;
}

// To the line of the next vertex or face.
void next_item(TextCursor& text, std::string_view what, std::int64_t done, std::int64_t promised) {
  text.next_line();
  text.skip_empty_lines(comment);
  if (text.at_end()) {
    text.fail("the file ends after " + std::to_string(done) + " of " + std::to_string(promised) +
              " " + std::string(what));
  }
}

}  // namespace

ParsedMesh read_off(std::string_view bytes, std::string_view name) {
  TextCursor text(bytes, name);
  ParsedMesh loaded;
  loaded.format = "OFF";
  read_keyword(text);
  const std::string_view word = first_count(text);
  const auto vertex_count = parse_integer(word);
  if (!vertex_count) text.fail_expected("the number of vertices", word);
  const std::int64_t face_count = text.integer("the number of faces");

  check_line_count(text, *vertex_count, 3, "vertices");
  loaded.mesh.positions.reserve(static_cast<std::size_t>(*vertex_count));
  for (std::int64_t i = 0; i < *vertex_count; ++i) {
    next_item(text, "vertices", i, *vertex_count);
    loaded.mesh.positions.push_back(read_position(text));
  }

  check_line_count(text, face_count, 1, "faces");
  loaded.mesh.triangles.reserve(static_cast<std::size_t>(face_count));
  std::vector<VertexId> corners;
  for (std::int64_t i = 0; i < face_count; ++i) {
    next_item(text, "faces", i, face_count);
    read_polygon(text, loaded.mesh.vertex_count(), corners, loaded);
  }
  return loaded;
}

}  // namespace geolloyd

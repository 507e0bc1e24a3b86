#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/corner_properties.h"
#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

constexpr char comment = '#';

// "OFF" behind what every vertex has besides its position: ST, C, N in any order. "4OFF" and "nOFF"
// have other positions.
std::string_view read_keyword(TextCursor& text) {
  text.skip_empty_lines(comment);
  const std::string_view keyword = text.word();
  const bool is_known =
      keyword.ends_with("OFF") && keyword.find_first_not_of("STCN") == keyword.size() - 3;
  if (!is_known) text.fail_expected("'OFF' with at most ST, C and N before it", keyword);
  return keyword.substr(0, keyword.size() - 3);
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

// Numbers that stand behind a vertex or a face.
class OffProperties {
 public:
  // `keyword` says what vertices have: normals, then colours, then texture coordinates.
  OffProperties(std::string_view keyword, const ReadOptions& options)
      : is_wanted_(options.properties),
        normals_(keyword.find('N') != std::string_view::npos ? 3 : 0),
        has_colours_(keyword.find('C') != std::string_view::npos),
        textures_(keyword.find("ST") != std::string_view::npos ? 2 : 0) {}

  void read_vertex(TextCursor& text) {
    if (!is_wanted_ || (normals_ == 0 && !has_colours_ && textures_ == 0)) return;
    const std::vector<double> row = read_row(text);
    const std::size_t others = normals_ + textures_;
    if (row.size() < others) text.fail("the vertex has too few numbers for its file's first word");
    const std::size_t parts = row.size() - others;
    if (parts != 0 && (!has_colours_ || parts < 3 || parts > 4)) {
      text.fail("the vertex has " + std::to_string(row.size()) +
                " numbers behind its position, which does not fit the file's first word");
    }
    for (std::size_t i = 0; i < normals_; ++i) normal_[i].push_back(row[i]);
    for (std::size_t i = 0; i < textures_; ++i) texture_[i].push_back(row[row.size() - 2 + i]);
    if (has_colours_) add_colour(std::span(row).subspan(normals_, parts), vertex_colours_);
  }

  // A colour is three or four numbers. A single one is a place in a table that nobody has.
  void read_face(TextCursor& text) {
    if (!is_wanted_) return;
    const std::vector<double> row = read_row(text);
    const bool is_colour = row.size() == 3 || row.size() == 4;
    add_colour(std::span(row).first(is_colour ? row.size() : 0), face_colours_);
  }

  void finish(Properties& properties) {
    static constexpr std::array<const char*, 3> normal_names = {"nx", "ny", "nz"};
    static constexpr std::array<const char*, 2> texture_names = {"s", "t"};
    vertex_colours_.finish(properties.of_vertices, properties.left_out);
    for (std::size_t i = 0; i < normals_; ++i) {
      properties.of_vertices.push_back({normal_names[i], std::move(normal_[i])});
    }
    for (std::size_t i = 0; i < textures_; ++i) {
      properties.of_vertices.push_back({texture_names[i], std::move(texture_[i])});
    }
    face_colours_.finish(properties.of_triangles, properties.left_out);
  }

 private:
  static std::vector<double> read_row(TextCursor& text) {
    std::vector<double> row;
    while (!text.at_line_end()) {
      const std::string_view word = text.word();
      if (word.starts_with(comment)) break;
      const auto number = parse_real(word);
      if (!number) text.fail_expected("a number", word);
      row.push_back(*number);
    }
    return row;
  }

  static void add_colour(std::span<const double> row, TextColours& colours) {
    std::array<double, 4> colour{};
    std::copy(row.begin(), row.end(), colour.begin());
    colours.add(colour, row.size());
  }

  bool is_wanted_;
  std::size_t normals_;
  bool has_colours_;
  std::size_t textures_;
  std::array<std::vector<double>, 3> normal_;
  std::array<std::vector<double>, 2> texture_;
  TextColours vertex_colours_{"vertices"};
  TextColours face_colours_{"faces"};
};

}  // namespace

ParsedMesh read_off(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  TextCursor text(bytes, name);
  ParsedMesh loaded;
  loaded.format = "OFF";
  OffProperties properties(read_keyword(text), options);
  const std::string_view word = first_count(text);
  const auto vertex_count = parse_integer(word);
  if (!vertex_count) text.fail_expected("the number of vertices", word);
  const std::int64_t face_count = text.integer("the number of faces");

  check_line_count(text, *vertex_count, 3, "vertices");
  loaded.mesh.positions.reserve(static_cast<std::size_t>(*vertex_count));
  for (std::int64_t i = 0; i < *vertex_count; ++i) {
    next_item(text, "vertices", i, *vertex_count);
    loaded.mesh.positions.push_back(read_position(text));
    properties.read_vertex(text);
  }

  check_line_count(text, face_count, 1, "faces");
  loaded.mesh.triangles.reserve(static_cast<std::size_t>(face_count));
  std::vector<VertexId> corners;
  for (std::int64_t i = 0; i < face_count; ++i) {
    next_item(text, "faces", i, face_count);
    read_polygon(text, loaded.mesh.vertex_count(), corners, loaded);
    properties.read_face(text);
  }
  properties.finish(loaded.properties);
  return loaded;
}

}  // namespace geolloyd

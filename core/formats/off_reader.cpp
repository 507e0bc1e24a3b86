#include <algorithm>
#include <array>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/corner_properties.h"
#include "core/formats/mesh_readers.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr char comment = '#';

// What stands before the vertices.
struct OffHeader {
  std::string_view keyword;  // "OFF" behind what every vertex has: ST, C, N in any order
  std::int64_t vertices = 0;
  std::int64_t faces = 0;

  [[nodiscard]] bool names_colours() const { return keyword.find('C') != std::string_view::npos; }
};

// "4OFF" and "nOFF" have other positions. Where the first word is a number the keyword is missing.
std::string_view read_keyword(TextCursor& text) {
  const TextCursor before = text;
  const std::string_view keyword = text.word();
  if (parse_integer(keyword)) {
    text = before;
    return {};
  }
  const bool is_known =
      keyword.ends_with("OFF") && keyword.find_first_not_of("STCN") == keyword.size() - 3;
  if (!is_known) text.fail_expected("'OFF' with at most ST, C and N before it", keyword);
  return keyword.substr(0, keyword.size() - 3);
}

// The number of edges, which nobody needs and some leave out: behind the others, or alone on the
// next line. Lines have ended then.
void skip_edge_count(TextCursor& text) {
  text.pass_line_ends(false);
  const TextCursor before = text;
  if (parse_integer(text.word())) return;
  text.next_line();
  text.skip_empty_lines(comment);
  const bool is_alone = parse_integer(text.word()).has_value() && text.at_line_end();
  if (!is_alone) text = before;
}

OffHeader read_header(TextCursor& text) {
  OffHeader header;
  text.pass_line_ends(true, comment);
  header.keyword = read_keyword(text);
  const std::string_view word = text.word();
  if (word == "BINARY") text.fail("binary OFF is not understood; save the mesh as text");
  const auto vertices = parse_integer(word);
  if (!vertices) text.fail_expected("the number of vertices", word);
  header.vertices = *vertices;
  header.faces = text.integer("the number of faces");
  skip_edge_count(text);
  return header;
}

// That each vertex and each face can have a line of its own.
bool has_lines_for_all(TextCursor text, const OffHeader& header) {
  const auto items =
      static_cast<std::uint64_t>(header.vertices) + static_cast<std::uint64_t>(header.faces);
  std::uint64_t lines = 0;
  for (text.next_line(); lines < items; text.next_line(), ++lines) {
    text.skip_empty_lines(comment);
    if (text.at_end()) return false;
  }
  return true;
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

  // Where a vertex has no line to itself: as many words as the first word of the file says, which
  // names no colours.
  void read_words(TextCursor& text) {
    for (std::size_t i = 0; i < normals_; ++i) add(text.real("a normal"), normal_[i]);
    for (std::size_t i = 0; i < textures_; ++i) {
      add(text.real("a texture coordinate"), texture_[i]);
    }
  }

  // To the end of the line.
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

  // To the end of the line. A colour is three or four numbers. A single one is a place in a table
  // that nobody has.
  void read_face(TextCursor& text) {
    if (!is_wanted_) return;
    const std::vector<double> row = read_row(text);
    const bool is_colour = row.size() == 3 || row.size() == 4;
    add_colour(std::span(row).first(is_colour ? row.size() : 0), face_colours_);
  }

  void finish(Properties& properties) {
    static constexpr std::array<const char*, 3> normal_names = {"nx", "ny", "nz"};
    static constexpr std::array<const char*, 2> texture_names = {"s", "t"};
    if (!is_wanted_) return;
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
  void add(double number, std::vector<double>& column) const {
    if (is_wanted_) column.push_back(number);
  }

  static std::vector<double> read_row(TextCursor& text) {
    std::vector<double> row;
    while (!text.at_line_end(comment)) {
      const std::string_view word = text.word();
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

// Goes through the vertices and faces.
class OffReader {
 public:
  // `text` stands behind the header. `has_lines`: each vertex and each face begins a line, and what
  // stands behind it is its own. Otherwise words are taken as they come.
  OffReader(const TextCursor& text, const OffHeader& header, const ReadOptions& options,
            bool has_lines)
      : text_(text), header_(header), properties_(header.keyword, options), has_lines_(has_lines) {}

  ParsedMesh read() {
    loaded_.format = "OFF";
    read_vertices();
    read_faces();
    properties_.finish(loaded_.properties);
    return std::move(loaded_);
  }

  // Bytes behind what was read.
  [[nodiscard]] std::size_t remaining() const { return text_.remaining(); }

  // That all words of the text are read.
  bool is_all_read() {
    text_.skip_empty_lines(comment);
    return text_.at_end();
  }

  // Colours stand behind each face. Words behind others but not the last may be of the next faces.
  [[nodiscard]] bool may_be_wrapped() const {
    return some_have_words_behind_ && !last_has_words_behind_;
  }

 private:
  // To the next vertex or face.
  void next_item(std::string_view what, std::int64_t done, std::int64_t promised) {
    if (has_lines_) text_.next_line();
    text_.skip_empty_lines(comment);
    if (text_.at_end()) {
      text_.fail("the file ends after " + std::to_string(done) + " of " + std::to_string(promised) +
                 " " + std::string(what));
    }
    text_.pass_line_ends(true, comment);
  }

  void read_vertices() {
    std::vector<Vec3>& positions = loaded_.mesh.positions;
    positions.reserve(static_cast<std::size_t>(header_.vertices));
    for (std::int64_t i = 0; i < header_.vertices; ++i) {
      next_item("vertices", i, header_.vertices);
      positions.push_back(read_position(text_));
      text_.pass_line_ends(!has_lines_, comment);
      if (has_lines_) properties_.read_vertex(text_);
      if (!has_lines_) properties_.read_words(text_);
    }
  }

  void read_faces() {
    loaded_.mesh.triangles.reserve(static_cast<std::size_t>(header_.faces));
    std::vector<VertexId> corners;
    for (std::int64_t i = 0; i < header_.faces; ++i) {
      next_item("faces", i, header_.faces);
      read_polygon(text_, loaded_.mesh.vertex_count(), corners, loaded_);
      text_.pass_line_ends(false);
      if (!has_lines_) continue;
      last_has_words_behind_ = !text_.at_line_end(comment);
      some_have_words_behind_ = some_have_words_behind_ || last_has_words_behind_;
      properties_.read_face(text_);
    }
  }

  TextCursor text_;
  OffHeader header_;
  OffProperties properties_;
  ParsedMesh loaded_;
  bool has_lines_;
  bool some_have_words_behind_ = false;  // a face that was read has
  bool last_has_words_behind_ = false;
};

// Text that has lines for all, but perhaps others than those: programs wrap long ones. Where words
// taken as they come end with the text, they are what was meant.
ParsedMesh read_lines_or_words(const TextCursor& text, const OffHeader& header,
                               const ReadOptions& options) {
  OffReader lines(text, header, options, true);
  std::optional<ParsedMesh> by_lines;
  std::exception_ptr error;
  try {
    by_lines = lines.read();
  } catch (const InvalidInput&) {
    error = std::current_exception();
  }
  if (by_lines && !lines.may_be_wrapped()) return std::move(*by_lines);
  OffReader words(text, header, options, false);
  try {
    ParsedMesh by_words = words.read();
    if (words.is_all_read()) return by_words;
  } catch (const InvalidInput&) {
    // The way that comes farther is the one to complain about.
    if (error && words.remaining() < lines.remaining()) throw;
  }
  if (error) std::rethrow_exception(error);
  return std::move(*by_lines);
}

}  // namespace

ParsedMesh read_off(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  TextCursor text(bytes, name);
  const OffHeader header = read_header(text);
  check_line_count(text, header.vertices, 3, "vertices");
  check_line_count(text, header.faces, 1, "faces");
  const bool has_lines = has_lines_for_all(text, header);
  if (header.names_colours()) {
    if (!has_lines) {
      text.fail(
          "the file has fewer lines than vertices and faces, so nobody can tell how many "
          "numbers a colour has; give each vertex a line");
    }
    return OffReader(text, header, options, true).read();
  }
  if (!has_lines) return OffReader(text, header, options, false).read();
  return read_lines_or_words(text, header, options);
}

}  // namespace geolloyd

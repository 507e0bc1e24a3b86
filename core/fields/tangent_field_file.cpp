#include "core/fields/tangent_field_file.h"

#include <array>
#include <cmath>
#include <string>

#include "core/text/file_io.h"
#include "core/text/text_cursor.h"

namespace geolloyd {
namespace {

void skip_header(TextCursor& cursor) {
  while (!cursor.at_end()) {
    const bool column_names = cursor.word() == "k1";
    cursor.next_line();
    if (column_names) return;
  }
  cursor.fail("no line of column names (k1 k2 k1v_x ...) before the end of the file");
}

double field_value(TextCursor& cursor, std::string_view name) {
  const double value = cursor.real(name);
  if (!is_usable(value)) {
    cursor.fail(std::string(name) + " is not a finite number of usable size");
  }
  return value;
}

TangentSpace read_space(TextCursor& cursor) {
  static constexpr std::array<std::string_view, 8> names = {"k1",    "k2",    "k1v_x", "k1v_y",
                                                            "k1v_z", "k2v_x", "k2v_y", "k2v_z"};
  std::array<double, 8> value{};
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = field_value(cursor, names[i]);
  if (!cursor.at_line_end()) cursor.fail("more than the eight numbers of a vertex");
  return {normalized({value[2], value[3], value[4]}), normalized({value[5], value[6], value[7]}),
          std::abs(value[0]), std::abs(value[1])};
}

}  // namespace

std::vector<TangentSpace> read_tangent_field(const std::filesystem::path& path,
                                             std::size_t vertex_count) {
  return parse_tangent_field(read_file(path), path.string(), vertex_count);
}

std::vector<TangentSpace> parse_tangent_field(std::string_view text, std::string_view name,
                                              std::size_t vertex_count) {
  TextCursor cursor(text, name);
  skip_header(cursor);
  std::vector<TangentSpace> spaces;
  spaces.reserve(vertex_count);
  for (cursor.skip_empty_lines(); !cursor.at_end(); cursor.skip_empty_lines()) {
    if (spaces.size() == vertex_count) {
      cursor.fail("more lines than the mesh has vertices (" + std::to_string(vertex_count) + ")");
    }
    spaces.push_back(read_space(cursor));
    cursor.next_line();
  }
  if (spaces.size() != vertex_count) {
    cursor.fail("the file ends after " + std::to_string(spaces.size()) +
                " vertices, but the mesh has " + std::to_string(vertex_count));
  }
  return spaces;
}

}  // namespace geolloyd

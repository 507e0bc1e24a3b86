#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/corner_properties.h"
#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

// Numbers of the names that stand before faces, in order of their first face: groups, materials.
class FaceNames {
 public:
  explicit FaceNames(const char* name) : name_(name) {}

  void set(std::string name) {
    current_ = std::move(name);
    is_numbered_ = false;
  }
  void add_face() {
    if (!is_numbered_) {
      const auto next = static_cast<std::int32_t>(numbers_.size());
      number_ = numbers_.try_emplace(current_, next).first->second;
      is_numbered_ = true;
    }
    of_face_.push_back(number_);
  }
  // Where all faces have one name, that says nothing.
  void finish(Properties& properties) {
    if (numbers_.size() < 2) return;
    properties.left_out.push_back("names behind " + in_quotes(name_) +
                                  ": it numbers them in order of appearance, from 0");
    properties.of_triangles.push_back({name_, std::move(of_face_)});
  }

 private:
  std::string name_;
  std::string current_;
  bool is_numbered_ = false;
  std::int32_t number_ = 0;
  std::map<std::string, std::int32_t> numbers_;
  std::vector<std::int32_t> of_face_;
};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, std::string_view name, const ReadOptions& options)
      : text_(bytes, name), name_(name), has_properties_(options.properties) {}

  ParsedMesh read() {
    loaded_.format = "OBJ";
    for (; !text_.at_end(); text_.next_line()) {
      const std::string_view keyword = text_.word();
      if (keyword == "v") read_vertex();
      if (keyword == "f") read_face();
      if (has_properties_) read_property(keyword);
    }
    check_highest();
    if (has_properties_) finish_properties();
    return std::move(loaded_);
  }

 private:
  // The next word of a statement, which a backslash carries on over the end of its line.
  std::string_view word() {
    while (true) {
      std::string_view word = text_.word();
      if (!word.ends_with('\\') || !text_.at_line_end()) return word;
      word.remove_suffix(1);
      text_.next_line();
      if (!word.empty()) return word;
    }
  }

  // The next word of a statement that is no comment.
  std::string_view word_of_statement() {
    const TextCursor before = text_;
    const std::string_view found = word();
    if (!found.starts_with('#')) return found;
    text_ = before;
    return {};
  }

  void read_vertex() {
    Vec3 position;
    for (double& coordinate : position) coordinate = parse_coordinate(text_, word());
    loaded_.mesh.positions.push_back(position);
    if (has_properties_) read_colour();
  }

  // Behind the coordinates: three or four numbers. One number is a weight, and what more than four
  // are nobody knows.
  void read_colour() {
    std::array<double, 4> colour{};
    std::size_t count = 0;
    for (std::string_view found = word_of_statement(); !found.empty();
         found = word_of_statement()) {
      if (count == colour.size()) return colours_.add(colour, 0);
      const auto number = parse_real(found);
      if (!number) text_.fail_expected("a part of a colour", found);
      colour[count++] = *number;
    }
    colours_.add(colour, count < 3 ? 0 : count);
  }

  void read_property(std::string_view keyword) {
    if (keyword == "vt") texture_.add_row(read_row(1, 2));
    if (keyword == "vn") normal_.add_row(read_row(3, 3));
    if (keyword == "g") group_.set(read_name());
    if (keyword == "o") object_.set(read_name());
    if (keyword == "usemtl") material_.set(read_name());
  }

  // Names may have blanks.
  std::string read_name() {
    std::string name;
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      name.append(name.empty() ? "" : " ").append(word);
    }
    return name;
  }

  std::array<double, 3> read_row(std::size_t least, std::size_t most) {
    std::array<double, 3> row{};
    for (std::size_t i = 0; i < most; ++i) {
      const std::string_view found = word_of_statement();
      if (found.empty() && i >= least) break;
      const auto number = parse_real(found);
      if (!number) text_.fail_expected(most == 3 ? "a normal" : "a texture coordinate", found);
      row[i] = *number;
    }
    return row;
  }

  void read_face() {
    corners_.clear();
    while (true) {
      const std::string_view corner = word();
      if (corner.empty() || corner.starts_with('#')) break;
      corners_.push_back(vertex_of(corner));
      if (has_properties_) read_corner(corners_.back(), corner);
    }
    if (corners_.size() < 3) text_.fail(bad_corner_count(std::ssize(corners_)));
    add_polygon(loaded_, corners_);
    if (!has_properties_) return;
    group_.add_face();
    object_.add_face();
    material_.add_face();
  }

  // "v", "v/vt", "v//vn" or "v/vt/vn": counted from 1, or back from the latest vertex.
  VertexId vertex_of(std::string_view corner) {
    const auto number = parse_integer(corner.substr(0, corner.find('/')));
    if (!number || *number == 0) text_.fail_expected("a vertex index, counted from 1", corner);
    const std::int64_t defined = std::ssize(loaded_.mesh.positions);
    if (*number < -defined) {
      text_.fail("vertex index " + std::to_string(*number) + " is out of range; only " +
                 std::to_string(defined) + " vertices stand before it");
    }
    const std::int64_t index = *number < 0 ? defined + *number : *number - 1;
    if (index > highest_) {
      highest_ = index;
      line_of_highest_ = text_.line();
    }
    return static_cast<VertexId>(index);
  }

  // The other indices of a corner.
  void read_corner(VertexId vertex, std::string_view corner) {
    const std::size_t first = corner.find('/');
    const std::size_t second = corner.find('/', std::min(first, corner.size() - 1) + 1);
    const auto part = [&](std::size_t from, std::size_t to) {
      return from == std::string_view::npos ? std::string_view() : corner.substr(from + 1, to);
    };
    add_corner(vertex, part(first, second - first - 1), "texture index", texture_);
    add_corner(vertex, part(second, std::string_view::npos), "normal index", normal_);
  }

  void add_corner(VertexId vertex, std::string_view word, const char* what,
                  CornerProperties& properties) {
    if (word.empty()) return properties.add_corner_without();
    const auto number = parse_integer(word);
    const auto defined = static_cast<std::int64_t>(properties.row_count());
    if (!number || *number == 0 || *number < -defined || *number > no_id) {
      text_.fail_expected(std::string("a ") + what + ", counted from 1", word);
    }
    const std::int64_t row = *number < 0 ? defined + *number : *number - 1;
    properties.add_corner(vertex, static_cast<std::uint32_t>(row), text_.line());
  }

  // A face may name vertices that come after it, so ranges are known only at the end.
  void check_highest() const {
    const std::int64_t count = std::ssize(loaded_.mesh.positions);
    if (highest_ < count) return;
    TextCursor({}, name_, line_of_highest_)
        .fail("vertex index " + std::to_string(highest_ + 1) + " is out of range; there are " +
              std::to_string(count) + " vertices, counted from 1");
  }

  // A face may name rows that come after it, too.
  void check_rows(const CornerProperties& properties, const char* what) const {
    const auto [row, line] = properties.highest_row();
    if (row < properties.row_count() || line == 0) return;
    TextCursor({}, name_, line)
        .fail(std::string(what) + " " + std::to_string(row + 1) + " is out of range; there are " +
              std::to_string(properties.row_count()));
  }

  void finish_properties() {
    check_rows(normal_, "normal index");
    check_rows(texture_, "texture index");
    Properties& properties = loaded_.properties;
    colours_.finish(properties.of_vertices, properties.left_out);
    normal_.finish(loaded_.mesh.vertex_count(), properties);
    texture_.finish(loaded_.mesh.vertex_count(), properties);
    for (FaceNames* names : {&object_, &group_, &material_}) names->finish(properties);
  }

  TextCursor text_;
  std::string_view name_;
  bool has_properties_;
  ParsedMesh loaded_;
  std::vector<VertexId> corners_;
  std::int64_t highest_ = -1;
  std::size_t line_of_highest_ = 0;
  TextColours colours_{"vertices"};
  CornerProperties normal_{"normals", {"nx", "ny", "nz"}};
  CornerProperties texture_{"texture coordinates", {"s", "t"}};
  FaceNames object_{"object"};
  FaceNames group_{"group"};
  FaceNames material_{"material"};
};

}  // namespace

ParsedMesh read_obj(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  return ObjReader(bytes, name, options).read();
}

}  // namespace geolloyd

#include <utility>

#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view bytes, std::string_view name) : text_(bytes, name), name_(name) {}

  ParsedMesh read() {
    loaded_.format = "OBJ";
    for (; !text_.at_end(); text_.next_line()) {
      const std::string_view keyword = text_.word();
      if (keyword == "v") read_vertex();
      if (keyword == "f") read_face();
    }
    check_highest();
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

  void read_vertex() {
    Vec3 position;
    for (double& coordinate : position) coordinate = parse_coordinate(text_, word());
    loaded_.mesh.positions.push_back(position);
  }

  void read_face() {
    corners_.clear();
    while (true) {
      const std::string_view corner = word();
      if (corner.empty() || corner.starts_with('#')) break;
      corners_.push_back(vertex_of(corner));
    }
    if (corners_.size() < 3) text_.fail(bad_corner_count(std::ssize(corners_)));
    add_polygon(loaded_, corners_);
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

  // A face may name vertices that come after it, so ranges are known only at the end.
  void check_highest() const {
    const std::int64_t count = std::ssize(loaded_.mesh.positions);
    if (highest_ < count) return;
    TextCursor({}, name_, line_of_highest_)
        .fail("vertex index " + std::to_string(highest_ + 1) + " is out of range; there are " +
              std::to_string(count) + " vertices, counted from 1");
  }

  TextCursor text_;
  std::string_view name_;
  ParsedMesh loaded_;
  std::vector<VertexId> corners_;
  std::int64_t highest_ = -1;
  std::size_t line_of_highest_ = 0;
};

}  // namespace

ParsedMesh read_obj(std::string_view bytes, std::string_view name) {
  return ObjReader(bytes, name).read();
}

}  // namespace geolloyd

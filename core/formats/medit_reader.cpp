#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

// Vertices, triangles and quadrilaterals of a medit file, each with a reference: a label. Other
// sections are passed over.
class MeditReader {
 public:
  MeditReader(std::string_view bytes, std::string_view name, const ReadOptions& options)
      : text_(bytes, name), has_properties_(options.properties) {
    text_.pass_line_ends(true, '#');
  }

  ParsedMesh read() {
    loaded_.format = "medit";
    const std::string_view first = text_.word();
    if (first != "MeshVersionFormatted") text_.fail_expected("'MeshVersionFormatted'", first);
    (void)text_.integer("the version");
    for (std::string_view word = text_.word(); !word.empty() && word != "End";
         word = text_.word()) {
      if (word == "Dimension") read_dimension();
      if (word == "Vertices") read_vertices();
      if (word == "Triangles") read_faces(3);
      if (word == "Quadrilaterals") read_faces(4);
      // What is left are the numbers of a section that nobody asked for, and its name.
    }
    if (has_properties_) finish_properties();
    return std::move(loaded_);
  }

 private:
  void read_dimension() {
    const std::int64_t dimension = text_.integer("the dimension");
    if (dimension != 2 && dimension != 3) {
      text_.fail("a mesh of dimension " + std::to_string(dimension) + "; 2 and 3 are understood");
    }
    is_flat_ = dimension == 2;
  }

  void read_vertices() {
    if (!loaded_.mesh.positions.empty()) text_.fail("vertices stand here a second time");
    const std::int64_t count = text_.integer("the number of vertices");
    check_line_count(text_, count, is_flat_ ? 3 : 4, "vertices");
    loaded_.mesh.positions.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
      Vec3 position = Vec3::Zero();
      for (Eigen::Index axis = 0; axis < (is_flat_ ? 2 : 3); ++axis) {
        position[axis] = parse_coordinate(text_, text_.word());
      }
      loaded_.mesh.positions.push_back(position);
      read_reference(of_vertices_);
    }
  }

  void read_faces(std::size_t corner_count) {
    const std::int64_t count = text_.integer("the number of faces");
    check_line_count(text_, count, corner_count + 1, "faces");
    const std::size_t vertex_count = loaded_.mesh.vertex_count();
    std::vector<VertexId> corners(corner_count);
    for (std::int64_t i = 0; i < count; ++i) {
      for (VertexId& corner : corners) {
        const std::int64_t index = text_.integer("a vertex index");
        if (index < 1 || static_cast<std::uint64_t>(index) > vertex_count) {
          text_.fail("vertex index " + std::to_string(index) + " is out of range; there are " +
                     std::to_string(vertex_count) + " vertices, counted from 1");
        }
        corner = static_cast<VertexId>(index - 1);
      }
      add_polygon(loaded_, corners);
      read_reference(of_faces_);
    }
  }

  void read_reference(std::vector<std::int32_t>& references) {
    const std::int64_t reference = text_.integer("a reference");
    if (!has_properties_) return;
    if (!std::in_range<std::int32_t>(reference)) {
      text_.fail("the reference " + std::to_string(reference) + " has more than 32 bits");
    }
    references.push_back(static_cast<std::int32_t>(reference));
  }

  // Where all are equal, that says nothing.
  void finish_properties() {
    const auto add = [](std::vector<std::int32_t>& references, std::vector<Property>& properties) {
      const bool differ = std::adjacent_find(references.begin(), references.end(),
                                             std::not_equal_to<>()) != references.end();
      if (differ) properties.push_back({"ref", std::move(references)});
    };
    add(of_vertices_, loaded_.properties.of_vertices);
    add(of_faces_, loaded_.properties.of_triangles);
  }

  TextCursor text_;
  bool has_properties_;
  bool is_flat_ = false;
  ParsedMesh loaded_;
  std::vector<std::int32_t> of_vertices_;
  std::vector<std::int32_t> of_faces_;
};

}  // namespace

ParsedMesh read_medit(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  return MeditReader(bytes, name, options).read();
}

}  // namespace geolloyd

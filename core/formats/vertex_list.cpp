#include "core/formats/vertex_list.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/text/text_cursor.h"

namespace geolloyd {
namespace {

class VertexReader {
 public:
  VertexReader(std::string_view text, std::string_view name, const Mesh& mesh)
      : cursor_(text, name), is_used_(referenced_vertices(mesh)) {}

  /// Calls take() on each line that says something; that is to read all of it.
  template <class Take>
  void for_each_line(std::string_view what, Take&& take) {
    for (cursor_.skip_empty_lines('#'); !cursor_.at_end(); cursor_.skip_empty_lines('#')) {
      take();
      if (!cursor_.at_line_end()) cursor_.fail("expected " + std::string(what) + " and no more");
      cursor_.next_line();
    }
  }

  VertexId vertex() {
    const std::int64_t id = cursor_.integer("a vertex");
    const auto count = static_cast<std::int64_t>(is_used_.size());
    if (id < 0 || id >= count) {
      cursor_.fail("the mesh has no vertex " + std::to_string(id) + ": they are 0 to " +
                   std::to_string(count - 1));
    }
    if (is_used_[static_cast<std::size_t>(id)] == 0) {
      cursor_.fail("vertex " + std::to_string(id) + " is a corner of no triangle");
    }
    return static_cast<VertexId>(id);
  }

  [[noreturn]] void fail(const std::string& message) const { cursor_.fail(message); }

 private:
  TextCursor cursor_;
  std::vector<std::uint8_t> is_used_;
};

}  // namespace

std::vector<VertexId> parse_vertex_list(std::string_view text, std::string_view name,
                                        const Mesh& mesh) {
  VertexReader reader(text, name, mesh);
  std::vector<VertexId> vertices;
  reader.for_each_line("a vertex", [&] { vertices.push_back(reader.vertex()); });
  return vertices;
}

std::vector<std::array<VertexId, 2>> parse_edge_list(std::string_view text, std::string_view name,
                                                     const Mesh& mesh, const MeshEdges& edges) {
  VertexReader reader(text, name, mesh);
  std::vector<std::array<VertexId, 2>> found;
  reader.for_each_line("two vertices", [&] {
    const VertexId a = reader.vertex();
    const VertexId b = reader.vertex();
    if (!std::binary_search(edges.ends.begin(), edges.ends.end(), ascending(a, b))) {
      reader.fail("the mesh has no edge from vertex " + std::to_string(a) + " to vertex " +
                  std::to_string(b));
    }
    found.push_back(ascending(a, b));
  });
  return found;
}

}  // namespace geolloyd

#include "core/formats/vertex_list.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/text/text_cursor.h"

namespace geolloyd {
namespace {

// Calls take() on each line that says something; that is to read all of it.
template <class Take>
void for_each_line(TextCursor& cursor, std::string_view what, Take&& take) {
  for (cursor.skip_empty_lines('#'); !cursor.at_end(); cursor.skip_empty_lines('#')) {
    take();
    if (!cursor.at_line_end()) cursor.fail("expected " + std::string(what) + " and no more");
    cursor.next_line();
  }
}

class VertexReader {
 public:
  VertexReader(std::string_view text, std::string_view name, const Mesh& mesh,
               std::span<const VertexId> welded_to)
      : cursor_(text, name), is_used_(referenced_vertices(mesh)), welded_to_(welded_to) {}

  VertexId vertex() {
    const std::int64_t id = cursor_.integer("a vertex");
    const auto count = static_cast<std::int64_t>(is_used_.size());
    if (id < 0 || id >= count) {
      cursor_.fail("the mesh has no vertex " + std::to_string(id) + ": they are 0 to " +
                   std::to_string(count - 1));
    }
    const auto named = static_cast<VertexId>(id);
    const VertexId vertex = welded_to_.empty() ? named : welded_to_[named];
    if (is_used_[vertex] == 0) {
      cursor_.fail("vertex " + std::to_string(id) + " is a corner of no triangle");
    }
    return vertex;
  }

  TextCursor& cursor() { return cursor_; }

 private:
  TextCursor cursor_;
  std::vector<std::uint8_t> is_used_;
  std::span<const VertexId> welded_to_;  // empty: none
};

}  // namespace

std::vector<VertexId> parse_vertex_list(std::string_view text, std::string_view name,
                                        const Mesh& mesh, std::span<const VertexId> welded_to) {
  VertexReader reader(text, name, mesh, welded_to);
  std::vector<VertexId> vertices;
  for_each_line(reader.cursor(), "a vertex", [&] { vertices.push_back(reader.vertex()); });
  return vertices;
}

std::vector<std::array<VertexId, 2>> parse_edge_list(std::string_view text, std::string_view name,
                                                     const Mesh& mesh, const MeshEdges& edges,
                                                     std::span<const VertexId> welded_to) {
  VertexReader reader(text, name, mesh, welded_to);
  std::vector<std::array<VertexId, 2>> found;
  for_each_line(reader.cursor(), "two vertices", [&] {
    const VertexId a = reader.vertex();
    const VertexId b = reader.vertex();
    if (!std::binary_search(edges.ends.begin(), edges.ends.end(), ascending(a, b))) {
      reader.cursor().fail("the mesh has no edge from vertex " + std::to_string(a) + " to vertex " +
                           std::to_string(b));
    }
    found.push_back(ascending(a, b));
  });
  return found;
}

std::vector<double> parse_vertex_values(std::string_view text, std::string_view name,
                                        std::size_t vertex_count) {
  TextCursor cursor(text, name);
  std::vector<double> values;
  values.reserve(vertex_count);
  for_each_line(cursor, "a number", [&] {
    if (values.size() == vertex_count) {
      cursor.fail("more numbers than the mesh has vertices (" + std::to_string(vertex_count) + ")");
    }
    const double value = cursor.real("a number");
    if (!is_usable(value) || !(value > 0)) cursor.fail("expected a number above 0, and finite");
    values.push_back(value);
  });
  if (values.size() != vertex_count) {
    cursor.fail("the file ends after " + std::to_string(values.size()) +
                " numbers, but the mesh has " + std::to_string(vertex_count) + " vertices");
  }
  return values;
}

}  // namespace geolloyd

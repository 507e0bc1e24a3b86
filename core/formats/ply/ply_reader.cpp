#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/formats/mesh_readers.h"
#include "core/formats/ply/ply_body.h"
#include "core/formats/ply/ply_header.h"
#include "core/formats/ply/ply_properties.h"
#include "core/formats/ply/triangle_strip.h"

namespace geolloyd {
namespace {

// One pass per coordinate, so that their types need not agree.
void read_vertices(PlyBody& body, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyElement& vertex = header.elements[header.vertex];
  std::vector<Vec3>& positions = loaded.mesh.positions;
  positions.resize(vertex.count);
  const std::size_t start = body.offset();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    body.rewind(start);
    const std::size_t property = header.coordinates[axis];
    const auto read_column = [&](auto zero) {
      body.for_each_row(vertex, property, [&](std::size_t row) {
        const auto coordinate = static_cast<double>(body.next<decltype(zero)>());
        if (!is_usable(coordinate)) body.fail(bad_coordinate(coordinate));
        positions[row][static_cast<Eigen::Index>(axis)] = coordinate;
      });
    };
    visit_number(read_column, vertex.properties[property].type);
  }
}

template <class Index>
constexpr std::int64_t restart_of() {
  if constexpr (std::is_signed_v<Index>) return -1;
  return std::numeric_limits<Index>::max();
}

template <class Count, class Index>
void read_strips(PlyBody& body, const PlyHeader& header, ParsedMesh& loaded) {
  std::vector<std::int64_t> indices;
  body.for_each_row(header.elements[header.strips->element], header.strips->list, [&](std::size_t) {
    const auto count = std::int64_t{body.next<Count>()};
    if (count < 0) body.fail(bad_list_length(count));
    const char* item = body.take(static_cast<std::size_t>(count) * sizeof(Index));
    indices.resize(static_cast<std::size_t>(count));
    for (std::int64_t& index : indices) {
      index = std::int64_t{load<Index>(item, body.order())};
      item += sizeof(Index);
    }
    add_strip(loaded, indices, restart_of<Index>(), header.elements[header.vertex].count,
              [&](const std::string& message) { body.fail(message); });
  });
}

template <class Count, class Index>
void read_faces(PlyBody& body, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyElement& face = header.elements[header.faces->element];
  const std::size_t vertex_count = header.elements[header.vertex].count;
  const std::size_t triangle_row_size = least_row_size(face) + 3 * sizeof(Index);
  loaded.mesh.triangles.reserve(std::min(face.count, body.remaining() / triangle_row_size));
  std::vector<VertexId> corners;
  body.for_each_row(face, header.faces->list, [&](std::size_t) {
    const auto count = std::int64_t{body.next<Count>()};
    if (count < 3) body.fail(bad_corner_count(count));
    const char* item = body.take(static_cast<std::size_t>(count) * sizeof(Index));
    corners.resize(static_cast<std::size_t>(count));
    for (VertexId& corner : corners) {
      const auto index = std::int64_t{load<Index>(item, body.order())};
      if (static_cast<std::uint64_t>(index) >= vertex_count) {
        body.fail(bad_index(index, vertex_count));
      }
      corner = static_cast<VertexId>(index);
      item += sizeof(Index);
    }
    add_polygon(loaded, corners);
  });
}

// Calls read with zeros of the types of the count and the items.
template <class Read>
void visit_corners(const PlyHeader& header, const PlyCorners& corners, Read&& read) {
  const PlyProperty& list = header.elements[corners.element].properties[corners.list];
  std::visit(read, *list.count_type, std::get<PlyInteger>(list.type));
}

// `in` has a body that is long enough for what the element promises.
template <class Body>
void check_ids(const Body& in, const PlyHeader& header, std::size_t element) {
  const std::size_t vertices = element == header.vertex ? header.elements[element].count : 0;
  const std::size_t faces = header.has_faces_at(element) ? header.elements[element].count : 0;
  if (!ids_suffice(vertices, faces)) in.fail(too_many(vertices, faces));
}

void read_binary(PlyBody& body, const PlyHeader& header, PlyColumns& columns, ParsedMesh& loaded) {
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    body.check_count(header.elements[i]);
    check_ids(body, header, i);
    const std::size_t start = body.offset();
    if (i == header.vertex) {
      read_vertices(body, header, loaded);
      columns.of_vertices.read(body, start);
    } else if (header.has_faces_at(i)) {
      visit_corners(header, *header.faces, [&](auto count, auto index) {
        read_faces<decltype(count), decltype(index)>(body, header, loaded);
      });
      columns.of_faces.read(body, start);
    } else if (header.has_strips_at(i)) {
      visit_corners(header, *header.strips, [&](auto count, auto index) {
        read_strips<decltype(count), decltype(index)>(body, header, loaded);
      });
    } else {
      body.skip_rows(header.elements[i]);
    }
  }
}

void skip_value(TextCursor& text, const PlyProperty& property) {
  const std::int64_t count = property.count_type ? text.integer("the length of a list") : 1;
  if (count < 0) text.fail(bad_list_length(count));
  for (std::int64_t i = 0; i < count; ++i) {
    if (text.word().empty()) text.fail_expected("property " + in_quotes(property.name), {});
  }
}

// Passes over the lines of an element; visit(row, property) has to read the value of each property.
template <class Visit>
void for_each_value(TextCursor& text, const PlyElement& element, Visit visit) {
  for (std::size_t row = 0; row < element.count; ++row, text.next_line()) {
    text.skip_empty_lines();
    if (text.at_end()) {
      text.fail("the file ends after " + std::to_string(row) + " of " +
                std::to_string(element.count) + " rows of element " + in_quotes(element.name));
    }
    for (std::size_t i = 0; i < element.properties.size(); ++i) visit(row, i);
    if (!text.at_line_end())
      text.fail("more values than element " + in_quotes(element.name) + " has");
  }
}

void read_ascii_vertices(TextCursor& text, const PlyHeader& header, PlyColumnGroup& columns,
                         ParsedMesh& loaded) {
  const PlyElement& vertex = header.elements[header.vertex];
  const auto& coordinates = header.coordinates;
  loaded.mesh.positions.resize(vertex.count);
  for_each_value(text, vertex, [&](std::size_t row, std::size_t property) {
    const auto axis = std::find(coordinates.begin(), coordinates.end(), property);
    if (axis == coordinates.end()) {
      if (!columns.read(text, property)) skip_value(text, vertex.properties[property]);
      return;
    }
    loaded.mesh.positions[row][axis - coordinates.begin()] = parse_coordinate(text, text.word());
  });
}

void read_ascii_faces(TextCursor& text, const PlyHeader& header, PlyColumnGroup& columns,
                      ParsedMesh& loaded) {
  const PlyElement& face = header.elements[header.faces->element];
  std::vector<VertexId> corners;
  for_each_value(text, face, [&](std::size_t, std::size_t property) {
    if (property == header.faces->list) {
      read_polygon(text, header.elements[header.vertex].count, corners, loaded);
    } else if (!columns.read(text, property)) {
      skip_value(text, face.properties[property]);
    }
  });
}

void read_ascii_strips(TextCursor& text, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyElement& strip = header.elements[header.strips->element];
  const auto fail = [&](const std::string& message) { text.fail(message); };
  std::vector<std::int64_t> indices;
  for_each_value(text, strip, [&](std::size_t, std::size_t property) {
    if (property != header.strips->list) return skip_value(text, strip.properties[property]);
    const std::int64_t count = text.integer("the length of a strip");
    if (count < 0) text.fail(bad_list_length(count));
    indices.clear();
    for (std::int64_t i = 0; i < count; ++i) indices.push_back(text.integer("a vertex index"));
    add_strip(loaded, indices, -1, header.elements[header.vertex].count, fail);
  });
}

void read_ascii(TextCursor& text, const PlyHeader& header, PlyColumns& columns,
                ParsedMesh& loaded) {
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    const PlyElement& element = header.elements[i];
    check_line_count(text, static_cast<std::int64_t>(element.count), element.properties.size(),
                     "rows of element " + in_quotes(element.name));
    check_ids(text, header, i);
    if (i == header.vertex) {
      read_ascii_vertices(text, header, columns.of_vertices, loaded);
    } else if (header.has_faces_at(i)) {
      read_ascii_faces(text, header, columns.of_faces, loaded);
    } else if (header.has_strips_at(i)) {
      read_ascii_strips(text, header, loaded);
    } else {
      for_each_value(text, element, [&](std::size_t, std::size_t property) {
        skip_value(text, element.properties[property]);
      });
    }
  }
}

}  // namespace

ParsedMesh read_ply(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  TextCursor text(bytes, name);
  const PlyHeader header = read_ply_header(text);
  ParsedMesh loaded;
  PlyColumns columns(header, options);
  if (header.encoding == PlyEncoding::ascii) {
    loaded.format = "PLY, ascii";
    read_ascii(text, header, columns, loaded);
  } else {
    const bool is_little = header.encoding == PlyEncoding::little_endian;
    loaded.format = is_little ? "PLY, binary little endian" : "PLY, binary big endian";
    PlyBody body(bytes, bytes.size() - text.remaining(), name,
                 is_little ? std::endian::little : std::endian::big);
    read_binary(body, header, columns, loaded);
  }
  loaded.properties = std::move(columns).take();
  return loaded;
}

}  // namespace geolloyd

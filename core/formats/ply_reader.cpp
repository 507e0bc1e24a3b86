#include <utility>

#include "core/formats/mesh_readers.h"
#include "core/formats/ply_header.h"

namespace geolloyd {
namespace {

using Properties = std::span<const PlyProperty>;

// The least number of bytes that a row of the element takes in a binary file.
std::size_t least_row_size(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    size += size_of(property.count_type ? PlyNumber(*property.count_type) : property.type);
  }
  return size;
}

// Properties that nobody wants, as what is to be stepped over: lists, each with the bytes before
// it, and the bytes after the last.
struct Gap {
  struct List {
    std::size_t bytes_before;
    PlyInteger count_type;
    std::size_t item_size;
  };

  explicit Gap(Properties properties) {
    for (const PlyProperty& property : properties) {
      const std::size_t size = size_of(property.type);
      if (property.count_type) {
        lists.push_back({std::exchange(bytes, 0), *property.count_type, size});
      } else {
        bytes += size;
      }
    }
  }

  std::vector<List> lists;
  std::size_t bytes = 0;
};

// The body of a binary file. Every step is checked against its end.
class BinaryBody {
 public:
  BinaryBody(std::string_view file, std::size_t offset, std::string_view name, std::endian order)
      : file_(file), name_(name), order_(order), offset_(offset) {}

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t remaining() const { return file_.size() - offset_; }
  [[nodiscard]] std::endian order() const { return order_; }
  void rewind(std::size_t offset) { offset_ = offset; }

  // Nobody should take memory for a promise that the file does not keep.
  void check_count(const PlyElement& element) const {
    if (element.count <= remaining() / least_row_size(element)) return;
    fail_at_byte(name_, offset_,
                 std::to_string(element.count) + " rows of element " + in_quotes(element.name) +
                     " are promised, but the file ends after " + std::to_string(remaining()) +
                     " more bytes");
  }

  // Passes over all rows of an element. visit(row) finds the body before the value of the wanted
  // property, and has to read it.
  template <class Visit>
  void for_each_row(const PlyElement& element, std::size_t wanted, Visit visit) {
    const Gap before(Properties(element.properties).first(wanted));
    const Gap after(Properties(element.properties).subspan(wanted + 1));
    for (std::size_t row = 0; row < element.count; ++row) {
      row_offset_ = offset_;
      skip(before);
      visit(row);
      skip(after);
    }
  }

  void skip_rows(const PlyElement& element) {
    const Gap all(element.properties);
    for (std::size_t row = 0; row < element.count; ++row) {
      row_offset_ = offset_;
      skip(all);
    }
  }

  template <class Number>
  Number next() {
    return load<Number>(take(sizeof(Number)), order_);
  }

  const char* take(std::size_t bytes) {
    if (bytes > remaining()) fail("the file ends inside the row that begins here");
    return file_.data() + std::exchange(offset_, offset_ + bytes);
  }

  // Names the byte where the current row begins.
  [[noreturn]] void fail(const std::string& message) const {
    fail_at_byte(name_, row_offset_, message);
  }

 private:
  void skip(const Gap& gap) {
    for (const Gap::List& list : gap.lists) {
      take(list.bytes_before);
      const auto next_count = [&](auto zero) { return std::int64_t{next<decltype(zero)>()}; };
      const std::int64_t count = std::visit(next_count, list.count_type);
      if (count < 0) fail("a list has the negative length " + std::to_string(count));
      take(static_cast<std::size_t>(count) * list.item_size);
    }
    take(gap.bytes);
  }

  std::string_view file_;
  std::string_view name_;
  std::endian order_;
  std::size_t offset_;
  std::size_t row_offset_ = 0;
};

// One pass per coordinate, so that their types need not agree.
void read_vertices(BinaryBody& body, const PlyHeader& header, ParsedMesh& loaded) {
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

template <class Count, class Index>
void read_faces(BinaryBody& body, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyElement& face = header.elements[header.face];
  const std::size_t vertex_count = header.elements[header.vertex].count;
  const std::size_t triangle_row_size = least_row_size(face) + 3 * sizeof(Index);
  loaded.mesh.triangles.reserve(std::min(face.count, body.remaining() / triangle_row_size));
  std::vector<VertexId> corners;
  body.for_each_row(face, header.corners, [&](std::size_t) {
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

void read_faces(BinaryBody& body, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyProperty& list = header.elements[header.face].properties[header.corners];
  std::visit(
      [&](auto count, auto index) {
        read_faces<decltype(count), decltype(index)>(body, header, loaded);
      },
      *list.count_type, std::get<PlyInteger>(list.type));
}

// `in` has a body that is long enough for what the element promises.
template <class Body>
void check_ids(const Body& in, const PlyHeader& header, std::size_t element) {
  const std::size_t vertices = element == header.vertex ? header.elements[element].count : 0;
  const std::size_t faces = element == header.face ? header.elements[element].count : 0;
  if (!ids_suffice(vertices, faces)) in.fail(too_many(vertices, faces));
}

void read_binary(BinaryBody& body, const PlyHeader& header, ParsedMesh& loaded) {
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    body.check_count(header.elements[i]);
    check_ids(body, header, i);
    if (i == header.vertex) {
      read_vertices(body, header, loaded);
    } else if (i == header.face) {
      read_faces(body, header, loaded);
    } else {
      body.skip_rows(header.elements[i]);
    }
  }
}

void skip_value(TextCursor& text, const PlyProperty& property) {
  const std::int64_t count = property.count_type ? text.integer("the length of a list") : 1;
  if (count < 0) text.fail("a list has the negative length " + std::to_string(count));
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

void read_ascii_vertices(TextCursor& text, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyElement& vertex = header.elements[header.vertex];
  const auto& coordinates = header.coordinates;
  loaded.mesh.positions.resize(vertex.count);
  for_each_value(text, vertex, [&](std::size_t row, std::size_t property) {
    const auto axis = std::find(coordinates.begin(), coordinates.end(), property);
    if (axis == coordinates.end()) return skip_value(text, vertex.properties[property]);
    loaded.mesh.positions[row][axis - coordinates.begin()] = parse_coordinate(text, text.word());
  });
}

void read_ascii_faces(TextCursor& text, const PlyHeader& header, ParsedMesh& loaded) {
  const PlyElement& face = header.elements[header.face];
  std::vector<VertexId> corners;
  for_each_value(text, face, [&](std::size_t, std::size_t property) {
    if (property != header.corners) return skip_value(text, face.properties[property]);
    read_polygon(text, header.elements[header.vertex].count, corners, loaded);
  });
}

void read_ascii(TextCursor& text, const PlyHeader& header, ParsedMesh& loaded) {
  for (std::size_t i = 0; i < header.elements.size(); ++i) {
    const PlyElement& element = header.elements[i];
    check_line_count(text, static_cast<std::int64_t>(element.count), element.properties.size(),
                     "rows of element " + in_quotes(element.name));
    check_ids(text, header, i);
    if (i == header.vertex) {
      read_ascii_vertices(text, header, loaded);
    } else if (i == header.face) {
      read_ascii_faces(text, header, loaded);
    } else {
      for_each_value(text, element, [&](std::size_t, std::size_t property) {
        skip_value(text, element.properties[property]);
      });
    }
  }
}

}  // namespace

ParsedMesh read_ply(std::string_view bytes, std::string_view name) {
  TextCursor text(bytes, name);
  const PlyHeader header = read_ply_header(text);
  ParsedMesh loaded;
  if (header.encoding == PlyEncoding::ascii) {
    loaded.format = "PLY, ascii";
    read_ascii(text, header, loaded);
    return loaded;
  }
  const bool is_little = header.encoding == PlyEncoding::little_endian;
  loaded.format = is_little ? "PLY, binary little endian" : "PLY, binary big endian";
  BinaryBody body(bytes, bytes.size() - text.remaining(), name,
                  is_little ? std::endian::little : std::endian::big);
  read_binary(body, header, loaded);
  return loaded;
}

}  // namespace geolloyd

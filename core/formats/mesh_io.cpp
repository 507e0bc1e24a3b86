#include "core/formats/mesh_io.h"

#include "core/base/bounding_box.h"
#include "core/formats/mesh_readers.h"
#include "core/properties/properties.h"
#include "core/seams/stitching.h"
#include "core/text/compression.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

ParsedMesh parse_as(MeshFormat format, std::string_view bytes, std::string_view name,
                    const ReadOptions& options, const std::filesystem::path* folder) {
  switch (format) {
    case MeshFormat::ply:
      return read_ply(bytes, name, options);
    case MeshFormat::obj:
      return read_obj(bytes, name, options);
    case MeshFormat::off:
      return read_off(bytes, name, options);
    case MeshFormat::stl:
      return read_stl(bytes, name);
    case MeshFormat::glb:
    case MeshFormat::gltf:
      return read_gltf(bytes, name, options, folder);
    case MeshFormat::gmsh:
      return read_gmsh(bytes, name, options);
    case MeshFormat::medit:
      return read_medit(bytes, name, options);
    case MeshFormat::vtp:
      break;
  }
  throw InvalidInput(std::string(name) + ": VTP is not read");
}

void check_size(const Mesh& mesh, std::size_t file_size, std::string_view name) {
  if (mesh.positions.empty()) fail_at_byte(name, file_size, "the file ends without a vertex");
  if (mesh.triangles.empty()) {
    fail_at_byte(name, file_size,
                 "the file ends without a face; a point cloud has no surface to relax");
  }
  if (!ids_suffice(mesh.vertex_count(), mesh.triangle_count())) {
    fail_at_byte(name, file_size, too_many(mesh.vertex_count(), mesh.triangle_count()));
  }
}

// Areas are square roots of fourth powers: on a smaller mesh they would all vanish.
void check_extent(const Mesh& mesh, std::string_view name) {
  const double widest = bounding_box(mesh.positions).extent().maxCoeff();
  if (widest > 0 && widest < 1 / largest_coordinate) {
    throw InvalidInput(std::string(name) + ": the mesh is smaller than 1e-75; scale it up");
  }
}

bool has_other_values(const LoadedMesh& loaded) {
  const std::vector<VertexId>& to = loaded.welded_to;
  for (VertexId v = 0; v < to.size(); ++v) {
    if (to[v] != v && differ(loaded.properties.of_vertices, v, to[v])) return true;
  }
  return false;
}

void weld(LoadedMesh& loaded) {
  std::vector<VertexId>& to = loaded.welded_to;
  to = find_split_vertices(loaded.mesh);
  for (VertexId v = 0; v < to.size(); ++v) loaded.welded_vertices += to[v] != v ? 1 : 0;
  if (has_other_values(loaded)) loaded.properties.corner_values = loaded.mesh.triangles;
  if (!to.empty()) rename_vertices(loaded.mesh, to);
}

}  // namespace

LoadedMesh read(const std::filesystem::path& path, const ReadOptions& options) {
  const MeshFormat format = format_to_read(path);
  const std::string name = path.string();
  const std::filesystem::path folder = path.parent_path();
  return parse_mesh(format, unpack(read_file(path), name, options.most_bytes), name, options,
                    &folder);
}

LoadedMesh parse_mesh(MeshFormat format, std::string_view bytes, std::string_view name,
                      const ReadOptions& options, const std::filesystem::path* folder) {
  if (bytes.empty()) fail_at_byte(name, 0, "the file is empty");
  if (compression_of(bytes) != Compression::none) {
    fail_at_byte(name, 0, "the file is compressed more than once; unpack it first");
  }
  if (format != MeshFormat::stl) refuse_utf16(bytes, name);  // STL may be binary: its reader knows
  ParsedMesh loaded = parse_as(format, bytes, name, options, folder);
  check_size(loaded.mesh, bytes.size(), name);
  check_extent(loaded.mesh, name);
  triangulate_concave(loaded.mesh, loaded.fans);
  spread_over_triangles(loaded.fans, loaded.mesh.triangle_count(), 64 * bytes.size(),
                        loaded.properties);
  if (options.weld) weld(loaded);
  return static_cast<LoadedMesh&&>(loaded);
}

void refuse_utf16(std::string_view bytes, std::string_view name) {
  if (!bytes.starts_with("\xff\xfe") && !bytes.starts_with("\xfe\xff")) return;
  fail_at_byte(name, 0, "the file is UTF-16 text; save it as UTF-8");
}

void fail_at_byte(std::string_view name, std::size_t offset, const std::string& message) {
  throw InvalidInput(std::string(name) + ": byte " + std::to_string(offset) + ": " + message);
}

std::string too_many(std::size_t vertices, std::size_t faces) {
  return std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces; at most " +
         std::to_string(most_vertices) + " and " + std::to_string(most_triangles) +
         " fit into 32-bit ids";
}

std::string bad_coordinate(double coordinate) {
  if (!std::isfinite(coordinate)) return "a coordinate is not finite";
  return "a coordinate is beyond 1e75; scale the mesh down";
}

std::string bad_corner_count(std::int64_t count) {
  return "the face has " + std::to_string(count) + " corners; it needs at least 3";
}

std::string bad_list_length(std::int64_t count) {
  return "a list has the negative length " + std::to_string(count);
}

std::string bad_index(std::int64_t index, std::size_t vertex_count) {
  return "vertex index " + std::to_string(index) + " is out of range; there are " +
         std::to_string(vertex_count) + " vertices, counted from 0";
}

void check_line_count(const TextCursor& text, std::int64_t count, std::size_t words,
                      std::string_view what) {
  if (count < 0) {
    text.fail("the number of " + std::string(what) + " is negative: " + std::to_string(count));
  }
  // A word takes a character and a blank or line end, which the last one may lack.
  if (static_cast<std::uint64_t>(count) > (text.remaining() + 1) / (2 * words)) {
    text.fail(std::to_string(count) + " " + std::string(what) +
              " are promised, but the file ends after " + std::to_string(text.remaining()) +
              " more bytes");
  }
}

double parse_coordinate(const TextCursor& text, std::string_view word) {
  const auto number = parse_real(word);
  if (!number) text.fail_expected("a coordinate", word);
  if (!is_usable(*number)) text.fail(bad_coordinate(*number));
  return *number;
}

Vec3 read_position(TextCursor& text) {
  Vec3 position;
  for (double& coordinate : position) coordinate = parse_coordinate(text, text.word());
  return position;
}

void read_polygon(TextCursor& text, std::size_t vertex_count, std::vector<VertexId>& corners,
                  ParsedMesh& loaded) {
  const std::int64_t count = text.integer("the number of corners of a face");
  if (count < 3) text.fail(bad_corner_count(count));
  corners.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t index = text.integer("a vertex index");
    if (static_cast<std::uint64_t>(index) >= vertex_count)
      text.fail(bad_index(index, vertex_count));
    corners.push_back(static_cast<VertexId>(index));
  }
  add_polygon(loaded, corners);
}

}  // namespace geolloyd

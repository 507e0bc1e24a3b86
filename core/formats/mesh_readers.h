#pragma once

// What the readers and the writer of mesh files share; not for users of the library.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "core/formats/mesh_io.h"
#include "core/formats/polygons.h"
#include "core/text/text_cursor.h"

namespace geolloyd {

/// What a reader finds: polygons are fans yet, as their vertices may come after them.
struct ParsedMesh : LoadedMesh {
  std::vector<PolygonFan> fans;  ///< of the faces of four and more corners
};

/// What read makes of a file that holds `bytes`; `name` opens every message. `folder` is where
/// the file lies, for glTF with buffers beside it; null: there are none.
LoadedMesh parse_mesh(MeshFormat format, std::string_view bytes, std::string_view name,
                      const ReadOptions& options = {},
                      const std::filesystem::path* folder = nullptr);

/// One reader per format: `bytes` is the whole file, `name` opens every message. Coordinates of the
/// result are usable and its indices in range; it may still be empty. Properties of triangles have
/// a value per face, yet. STL has none.
ParsedMesh read_ply(std::string_view bytes, std::string_view name, const ReadOptions& options);
ParsedMesh read_obj(std::string_view bytes, std::string_view name, const ReadOptions& options);
ParsedMesh read_off(std::string_view bytes, std::string_view name, const ReadOptions& options);
ParsedMesh read_stl(std::string_view bytes, std::string_view name);
ParsedMesh read_gmsh(std::string_view bytes, std::string_view name, const ReadOptions& options);
ParsedMesh read_medit(std::string_view bytes, std::string_view name, const ReadOptions& options);
ParsedMesh read_gltf(std::string_view bytes, std::string_view name, const ReadOptions& options,
                     const std::filesystem::path* folder);

/// Throws InvalidInput where the byte order mark of UTF-16 begins a text.
void refuse_utf16(std::string_view bytes, std::string_view name);

/// Throws InvalidInput "NAME: byte OFFSET: MESSAGE".
[[noreturn]] void fail_at_byte(std::string_view name, std::size_t offset,
                               const std::string& message);

// What is wrong with counts for which ids do not suffice (mesh.h; asked before memory is taken for
// what a header promises), a coordinate that is not usable, a face, an index.
std::string too_many(std::size_t vertices, std::size_t faces);
std::string bad_coordinate(double coordinate);
std::string bad_corner_count(std::int64_t count);
std::string bad_list_length(std::int64_t count);
std::string bad_index(std::int64_t index, std::size_t vertex_count);

/// Fails where the rest of the text cannot hold `count` lines of `words` words each: nobody should
/// take memory for a promise that the file does not keep.
void check_line_count(const TextCursor& text, std::int64_t count, std::size_t words,
                      std::string_view what);

/// `word` as a coordinate; fails where it is none, or not usable.
double parse_coordinate(const TextCursor& text, std::string_view word);
/// The next three words as a position.
Vec3 read_position(TextCursor& text);

/// Appends a polygon as a fan around its first corner.
inline void add_polygon(ParsedMesh& loaded, std::span<const VertexId> corners) {
  if (corners.size() > 3) {
    ++loaded.polygon_count;
    loaded.fans.push_back({static_cast<std::uint32_t>(loaded.mesh.triangles.size()),
                           static_cast<std::uint32_t>(corners.size() - 2)});
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    loaded.mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

/// Reads "n i_1 ... i_n", zero-based, and appends the polygon. `corners` is room to work in.
void read_polygon(TextCursor& text, std::size_t vertex_count, std::vector<VertexId>& corners,
                  ParsedMesh& loaded);

/// The number whose bytes lie at `bytes` in the given order.
template <class Number>
Number load(const char* bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), bytes, raw.size());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

}  // namespace geolloyd

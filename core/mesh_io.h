#pragma once

#include <filesystem>
#include <string>

#include "core/mesh.h"

namespace geolloyd {

/// A mesh as a file holds it, and what reading it had to do.
struct LoadedMesh {
  Mesh mesh;
  std::string format;              ///< for people: "PLY, binary little endian"
  std::size_t polygon_count = 0;   ///< faces of four and more corners, split into fans
  std::size_t welded_corners = 0;  ///< STL only: corners that fell on an earlier one
};

/// Reads PLY, OBJ, OFF/COFF or STL, told by the extension (case-insensitive).
///
/// Polygons become fans of triangles around their first corner, in order, so triangle ids count the
/// fans. Throws IoError where the file cannot be read, InvalidInput where it cannot be used
/// (syntax, non-finite or over-large coordinate, index out of range, no triangles), naming file and
/// line or byte offset. Never takes memory that the size of the file does not warrant.
LoadedMesh read_mesh(const std::filesystem::path& path);

/// Writes PLY (binary little endian), OBJ, OFF or STL (binary), told by the extension. Coordinates
/// are written in full in OBJ and OFF, as float32 in PLY and STL. The file appears whole or not at
/// all.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Coordinates beyond this are refused: the fourth power, an area squared, must not overflow.
inline constexpr double largest_coordinate = 1e75;

}  // namespace geolloyd

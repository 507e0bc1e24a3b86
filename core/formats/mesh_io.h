#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/mesh/mesh.h"
#include "core/text/file_writer.h"

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

/// Writes PLY (binary little endian), OBJ, OFF or STL (binary), told by the extension. No
/// coordinate loses a digit (PLY has float32 where these hold all of them, else float64), but in
/// STL, which knows float32 only.
void write_mesh(FileWriter& out, const Mesh& mesh);

/// The same as a file that appears whole or not at all.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Throws InvalidInput where the extension is none of these, which read_mesh and write_mesh do too.
void check_mesh_name(const std::filesystem::path& path);

/// That the extension is one of these.
bool has_mesh_name(const std::filesystem::path& path);

/// What a part of a mesh belongs to, and a colour that shows it.
struct Label {
  std::array<std::uint8_t, 3> colour;  ///< red, green, blue
  std::int32_t region;                 ///< -1: none
};

/// PLY as write_mesh does, with the properties red, green, blue and region for each vertex, or for
/// each triangle, or for both; an empty span is left out.
void write_labelled_ply(FileWriter& out, const Mesh& mesh, std::span<const Label> vertex_label,
                        std::span<const Label> triangle_label);

}  // namespace geolloyd

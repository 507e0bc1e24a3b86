#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "core/mesh/mesh.h"
#include "core/mesh/quad_pairs.h"
#include "core/text/file_writer.h"

namespace geolloyd {

/// Writes a mesh into an open file, as write (geolloyd/mesh.h) does; the format is told by the
/// extension. No
/// coordinate loses a digit (PLY has float32 where these hold all of them, else float64), but in
/// STL, which knows float32 only. Properties that the format cannot hold are passed over. Where
/// corners have values of their own, welded vertices are split again.
void write(FileWriter& out, const Mesh& mesh, const Properties& properties = {});

/// The same in this format, whatever the name is.
void write(FileWriter& out, MeshFormat format, const Mesh& mesh, const Properties& properties = {});

/// Removes what write would pass over in this format, and says so in `left_out`.
void keep_writable(MeshFormat format, Properties& properties);
/// The same for a file of that name.
void keep_writable(const std::filesystem::path& path, Properties& properties);

/// PLY as write does, with these faces. A quadrilateral has the properties of its first
/// triangle.
void write_faces_ply(FileWriter& out, const Mesh& mesh, std::span<const Face> faces,
                     const Properties& properties = {});

/// What a part of a mesh belongs to, and a colour that shows it.
struct Label {
  std::array<std::uint8_t, 3> colour;  ///< red, green, blue
  std::int32_t region;                 ///< -1: none
};

/// PLY as write does, with the properties red, green, blue and region for each vertex, or for
/// each triangle, or for both; an empty span is left out. The mesh's own properties of the same
/// name are input_red and so on.
void write_labelled_ply(FileWriter& out, const Mesh& mesh, std::span<const Label> vertex_label,
                        std::span<const Label> triangle_label, const Properties& properties = {});

}  // namespace geolloyd

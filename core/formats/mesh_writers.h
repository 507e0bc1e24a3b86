#pragma once

// What the writers of mesh files share; not for users of the library.

#include "core/formats/held_properties.h"
#include "core/formats/mesh_readers.h"
#include "core/text/file_writer.h"

namespace geolloyd {

/// As three float32.
inline void write_floats(FileWriter& out, const Vec3& position) {
  for (const double coordinate : position) out.raw(static_cast<float>(coordinate));
}

/// Throws InvalidInput where a coordinate is too large for a float, which `format` has.
void check_float_range(const FileWriter& out, const Mesh& mesh, const char* format);

/// glTF, binary or as text; one mesh with the colours, normals and texture coordinates of vertices.
void write_gltf(FileWriter& out, const Mesh& mesh, const HeldProperties& properties,
                bool is_binary);

/// medit and Gmsh: text, with a label of each triangle, and in medit of each vertex.
void write_medit(FileWriter& out, const Mesh& mesh, const HeldProperties& properties);
void write_gmsh(FileWriter& out, const Mesh& mesh, const HeldProperties& properties);

/// VTK's XML with all properties as arrays, their bytes appended.
void write_vtp(FileWriter& out, const Mesh& mesh, const Properties& properties);

}  // namespace geolloyd

#pragma once

#include <string>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "tools/words/named.h"

namespace geolloyd {

/// The formats that are read and those that are written, by their extensions without a dot.
extern const std::vector<Named<MeshFormat>> read_format_names;
extern const std::vector<Named<MeshFormat>> written_format_names;

/// Stands for standard input where a mesh is read, and for standard output where one is written.
inline constexpr const char* standard_input = "-";
inline constexpr const char* standard_output = "-";

// What help texts say of a mesh that is read or written.
extern const std::string input_mesh_text;
extern const std::string output_mesh_text;

}  // namespace geolloyd

#pragma once

#include <optional>

#include "core/formats/mesh_formats.h"

namespace geolloyd {

/// From now on, the format of meshes whose names do not tell it: standard input, for one.
void set_input_format(MeshFormat format);

/// Nothing where none was set.
std::optional<MeshFormat> input_format();

}  // namespace geolloyd

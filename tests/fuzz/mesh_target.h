#pragma once

#include <cstddef>
#include <cstdint>

#include "core/formats/mesh_readers.h"

namespace geolloyd::fuzz {

/// The bytes as a file of `format`: refused in one line, or a sound mesh in memory that the size of
/// the file warrants, of which everything that looks at any mesh can be asked, and which comes back
/// when it is written and read.
int try_mesh_file(MeshFormat format, const std::uint8_t* data, std::size_t size);

}  // namespace geolloyd::fuzz

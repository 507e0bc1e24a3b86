#pragma once

// What the writers of mesh files share; not for users of the library.

#include "core/formats/mesh_readers.h"
#include "core/text/file_writer.h"

namespace geolloyd {

/// As three float32.
inline void write_floats(FileWriter& out, const Vec3& position) {
  for (const double coordinate : position) out.raw(static_cast<float>(coordinate));
}

}  // namespace geolloyd

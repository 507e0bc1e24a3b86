#pragma once

#include <optional>

#include "core/formats/mesh_formats.h"

namespace geolloyd {

/// How mesh files are read, as options of the command line say it.
struct MeshReading {
  std::optional<MeshFormat> format = {};  ///< where the name does not tell it, as of standard input
  bool weld = true;                       ///< split vertices (geolloyd/mesh.h)
};

}  // namespace geolloyd

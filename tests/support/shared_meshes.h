#pragma once

#include <filesystem>
#include <string>

#include "core/formats/mesh_io.h"

namespace geolloyd {

/// A mesh that is not ours to pass on; without triangles where it is absent: the test then skips.
inline Mesh hard_mesh(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(GEOLLOYD_SHARED_MESHES) / "hard" / name;
  return std::filesystem::exists(file) ? read(file).mesh : Mesh{};
}

}  // namespace geolloyd

#pragma once

#include <filesystem>

#include "geolloyd/mesh.h"
#include "geolloyd/relax.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// From where a picture is taken, and how large it is.
struct RenderOptions {
  double azimuth = 25;    ///< degrees, around the mesh; 0: along its shortest side
  double elevation = 15;  ///< degrees, from -90 to 90
  int width = 1280;       ///< pixels, 64 to 8192
  int height = 0;         ///< pixels, 64 to 8192; 0: as high as the mesh needs
};

/// Draws a mesh with its edges into a PNG file, which appears whole or not at all. The ground is
/// transparent. Throws InvalidInput where the mesh or an option is not usable, IoError where the
/// file cannot be written.
void render_mesh(const std::filesystem::path& path, const Mesh& mesh,
                 const RenderOptions& options = {}, Runtime& runtime = all_threads());

/// Draws the regions of a tessellation of this mesh and its seeds.
void render_regions(const std::filesystem::path& path, const Mesh& mesh,
                    const Tessellation& tessellation, const RenderOptions& options = {},
                    Runtime& runtime = all_threads());

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/cli/relax_arguments.h"

namespace geolloyd {

/// All of `remesh`.
struct SurfaceRemeshArguments {
  std::filesystem::path mesh;
  std::size_t vertices = 0;
  EngineKind engine = EngineKind::parallel;
  ThreadArguments threads;
  PictureArguments picture;
  std::filesystem::path output;        ///< the remesh
  std::filesystem::path report_file;   ///< empty: none
  std::filesystem::path map_file;      ///< empty: none
  std::filesystem::path picture_file;  ///< empty: none
};

/// --vertices, with this description.
CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices, const std::string& what);

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/view/session/stepped_tessellation.h"

namespace geolloyd {

// The commands that give what a session shows, for a shell.

/// File of edited first seeds in the output folder.
inline constexpr const char* first_seeds_name = "first-seeds.csv";

/// `relax`, as far as the relaxation has come. Edited first seeds are in their file in `output`,
/// which may be empty: then the command lacks a folder.
std::string relax_command_line(const SteppedTessellation& tessellation,
                               const std::filesystem::path& output);

/// `remesh`, into remesh.ply.
std::string remesh_command_line(const Input& input, std::size_t vertices,
                                const std::filesystem::path& field,
                                const std::filesystem::path& output);

/// File of a surface remesh in the output folder.
inline constexpr const char* remesh_name = "remesh.ply";

/// A word that a shell takes as it is.
std::string quoted(const std::string& word);

}  // namespace geolloyd

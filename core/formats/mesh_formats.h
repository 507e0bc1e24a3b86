#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace geolloyd {

enum class MeshFormat { ply, obj, off, stl, glb, gltf, gmsh, medit, vtp };

/// What a format is called, and what is done with it.
struct MeshFormatFacts {
  MeshFormat format{};
  const char* name = "";       ///< as people write it
  const char* extension = "";  ///< of its files, in small letters
  bool is_read = true;
  bool is_written = true;
  bool is_binary = false;  ///< what is written is no text
};

/// All of them, in the order of the enumeration.
inline constexpr std::array<MeshFormatFacts, 9> mesh_formats{{
    {MeshFormat::ply, "PLY", ".ply", true, true, true},
    {MeshFormat::obj, "OBJ", ".obj"},
    {MeshFormat::off, "OFF", ".off"},
    {MeshFormat::stl, "STL", ".stl", true, true, true},
    {MeshFormat::glb, "GLB", ".glb", true, true, true},
    {MeshFormat::gltf, "glTF", ".gltf"},
    {MeshFormat::gmsh, "Gmsh", ".msh"},
    {MeshFormat::medit, "medit", ".mesh"},
    {MeshFormat::vtp, "VTP", ".vtp", false, true, true},
}};

const MeshFormatFacts& facts_of(MeshFormat format);

/// Told by the extension (case-insensitive), before which one of a compression is passed over.
/// Nothing where it is none of ours.
std::optional<MeshFormat> known_format(const std::filesystem::path& path);

// The same; throws InvalidInput where the extension is none of ours, or the format is not read or
// not written.
MeshFormat format_to_read(const std::filesystem::path& path);
MeshFormat format_to_write(const std::filesystem::path& path);

/// That the extension is one of a format that is read.
bool has_mesh_name(const std::filesystem::path& path);

}  // namespace geolloyd

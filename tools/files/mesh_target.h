#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/formats/mesh_io.h"
#include "core/text/file_writer.h"
#include "tools/system/console.h"

namespace geolloyd {

/// Where a command writes its mesh, as options of the command line say it.
struct MeshTarget {
  std::filesystem::path file;             ///< "-": standard output
  std::optional<MeshFormat> format = {};  ///< where the name does not tell it
  int stream = -1;                        ///< standard output, once it is the mesh's

  [[nodiscard]] bool is_stream() const;
  /// For people.
  [[nodiscard]] std::string name() const;
};

/// Throws InvalidInput where nothing tells it.
MeshFormat format_to_write(const MeshTarget& target);

/// Makes sure that the mesh can be written and would replace none of `others`, before any work
/// depends on it. Standard output is the mesh's alone from then on, and what else is printed goes
/// to standard error; without a format, it gets that of standard input, or PLY. Throws Error.
void prepare_target(MeshTarget& target, std::optional<MeshFormat> input_format,
                    std::span<const std::filesystem::path> others, Console& console);

/// Of a target that was prepared, or is a file.
std::unique_ptr<FileWriter> open_target(const MeshTarget& target);

/// The whole mesh, in one go.
void write(const MeshTarget& target, const Mesh& mesh, const Properties& properties = {});

}  // namespace geolloyd

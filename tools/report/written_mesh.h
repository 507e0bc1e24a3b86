#pragma once

#include <string>

#include "core/mesh/mesh.h"
#include "tools/files/mesh_target.h"
#include "tools/system/console.h"

namespace geolloyd {

/// What the commands print that write a mesh and measure nothing: its size.
void print_written_mesh(const std::string& command, const MeshTarget& target, const Mesh& mesh,
                        const Console& console);

/// The same of a mesh that was read and written again; also what reading it had to do, and which
/// properties it keeps.
void print_converted_mesh(const MeshTarget& target, const LoadedMesh& loaded,
                          const Console& console);

}  // namespace geolloyd

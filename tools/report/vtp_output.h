#pragma once

#include <filesystem>
#include <span>

#include "core/voronoi/partition.h"
#include "tools/run/stages.h"

namespace geolloyd {

/// Throws InvalidInput where the file is no VTP file, or would replace one of the others.
void check_vtp_target(const std::filesystem::path& path,
                      std::span<const std::filesystem::path> others);

/// VTP: the mesh with two arrays, per vertex, per triangle or both, as its graph has nodes.
/// `region` is -1 and `distance`, which is that along the graph to the seed in mesh units, is not a
/// number where there is no region. The mesh's own properties follow; those of these names are
/// input_region and input_distance.
void write_vtp(const std::filesystem::path& path, const PreparedInput& start,
               const Partition& partition);

}  // namespace geolloyd

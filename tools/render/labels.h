#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/graph/mesh_graph.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// Of what belongs to no region.
inline constexpr Colour no_colour = {128, 128, 128};

/// A colour per region, different for adjacent ones.
std::vector<Colour> colours_of_regions(const Graph& graph, const Partition& partition,
                                       std::size_t region_count);

/// Region and colour of each input id; no region is grey.
std::vector<Label> label_input_ids(const MeshGraph& mesh_graph, const Partition& partition,
                                   std::size_t region_count);

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"

namespace geolloyd {

/// Seeds in the order of the file, as nodes. Three forms, told by the first line: one input id a
/// line (mesh_graph.h); three coordinates a line, standing for the nearest node; or a seeds.csv as
/// geolloyd writes it. Blank lines and lines beginning with '#' are skipped. Throws InvalidInput,
/// naming the line, where a line is malformed, an id has no node, or a node comes twice; and where
/// a connected component of the graph has no seed. The file holds `text`; `name` opens every
/// message.
std::vector<NodeId> parse_seeds(std::string_view text, std::string_view name,
                                const MeshGraph& mesh_graph, const Components& components);
/// How many seeds that text has if nothing is wrong with it, or, of a seeds.csv, one more.
std::size_t most_seeds(std::string_view text);

}  // namespace geolloyd

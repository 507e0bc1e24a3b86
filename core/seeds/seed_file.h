#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/seeds/nearest_nodes.h"

namespace geolloyd {

/// By what a table names its seeds.
enum class SeedsBy {
  id,       ///< of the same mesh and kind of graph
  position  ///< of any mesh: the nearest node
};

/// A file of seeds.
struct SeedFile {
  std::filesystem::path path;  ///< empty: there is none
  SeedsBy by = SeedsBy::id;
};

/// Seeds in the order of their file.
struct GivenSeeds {
  std::vector<NodeId> nodes;
  std::optional<PositionFit> fit;  ///< empty: they were named by ids
};

/// A file of seeds in one of three forms, told by its first line: one input id a line
/// (mesh_graph.h); three coordinates a line; or a table with names of columns: a seeds.csv as
/// geolloyd writes it, or any table with columns x, y and z. `by` says which columns of a seeds.csv
/// count; ids alone have no position. Positions stand for the nearest node (nearest_nodes.h), ids
/// must differ. Blank lines and lines beginning with '#' are skipped. Throws InvalidInput, naming
/// the line, where a line is malformed, an id has no node, or comes twice; and where a connected
/// component of the graph has no seed. The file holds `text`; `name` opens every message.
GivenSeeds parse_seeds(std::string_view text, std::string_view name, SeedsBy by,
                       const MeshGraph& mesh_graph, const Components& components);

/// The seeds nearest to these positions, such as the vertices of another mesh. Throws InvalidInput
/// where there is none, and where a connected component of the graph has no seed.
GivenSeeds seeds_at(std::span<const Vec3> positions, std::string_view name,
                    const MeshGraph& mesh_graph, const Components& components);

/// How many seeds that text has if nothing is wrong with it, or, of a table, one more.
std::size_t most_seeds(std::string_view text);

}  // namespace geolloyd

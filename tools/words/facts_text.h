#pragma once

#include <string>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_topology.h"
#include "core/seeds/nearest_nodes.h"
#include "geolloyd/repair.h"

namespace geolloyd {

/// Who handles the flaws of a mesh: a graph of its vertices or triangles, a surface remesh, or a
/// repair, which tells of it itself.
enum class HandledBy { graph, surface, repair };

/// A mesh in a few lines for people: what it is, then what was found in it and how that is handled.
std::string describe(const LoadedMesh& input, const MeshFacts& facts,
                     HandledBy handled_by = HandledBy::graph);

/// What reading a mesh had to do, a line for each kind.
std::string describe_reading(const LoadedMesh& input);

/// What a repair did, a line for each kind.
std::string describe(const Repairs& repairs);
/// What was carried over from a mesh, and what was left out; nothing where there is neither.
std::string describe(const Properties& carried);

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);

/// "1 edge", "2,000 edges".
std::string counted(std::uint64_t number, const char* singular, const char* plural);

/// How far seeds given by position are from their nodes, and how many have none: a line.
std::string describe(const PositionFit& fit, const MeshFacts& facts);

/// How many pairs of triangles cross; nothing where none does.
std::string describe_self_intersections(std::size_t pairs);

/// Boundary loops, and whether it is a manifold.
std::string describe(const MeshTopology& topology);

/// As --fill-holes has it.
std::string name_of_hole_size(const RepairOptions& options);

}  // namespace geolloyd

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_edges.h"

namespace geolloyd {

// Text files about vertices of a mesh, which are counted from 0. Blank lines and lines beginning
// with '#' are skipped. Each throws InvalidInput, naming the line, where one is malformed or names
// a vertex that no triangle has. The file holds `text`; `name` opens every message. Where vertices
// were welded (`welded_to`, geolloyd/mesh.h), those that stand for them are meant.

/// A vertex a line.
std::vector<VertexId> parse_vertex_list(std::string_view text, std::string_view name,
                                        const Mesh& mesh, std::span<const VertexId> welded_to = {});

/// An edge a line: its two vertices. Throws also where the mesh has no such edge.
std::vector<std::array<VertexId, 2>> parse_edge_list(std::string_view text, std::string_view name,
                                                     const Mesh& mesh, const MeshEdges& edges,
                                                     std::span<const VertexId> welded_to = {});

/// A number a line, finite and above 0, for each vertex in turn.
std::vector<double> parse_vertex_values(std::string_view text, std::string_view name,
                                        std::size_t vertex_count);

}  // namespace geolloyd

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// A mesh with fewer vertices that replaces a finer one: no manifold, and its area is less.
struct CoarseMesh {
  FineMesh mesh;
  std::vector<VertexId> vertex_of;  ///< per vertex of the finer mesh: the one that replaces it
};

/// Per vertex: what it may be merged within, and how far.
struct Coarsening {
  std::span<const std::uint32_t> group;      ///< per vertex; groups are never merged
  std::span<const std::uint8_t> grid_level;  ///< per vertex: its cells have an edge of 2^(1-level)
};

/// Merges vertices that are in one cell of a grid and connected by edges within it, into one at
/// their mean, weighted by area, with the mean of their resolutions. Triangles of three such
/// vertices stay, each once, and edges of two such vertices, also where no triangle is left at
/// them, so that a thin limb stays connected. Cells are those of the spatial order of the finer
/// mesh's vertices; the same order is that of the result.
CoarseMesh coarsen(const FineMesh& finer, const Coarsening& coarsening,
                   Executor& executor = sequential());

}  // namespace geolloyd

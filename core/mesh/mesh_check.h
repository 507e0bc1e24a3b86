#pragma once

#include <cstddef>
#include <cstdint>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"

namespace geolloyd {

/// What a mesh is like. Everything counted here is handled, and how is said beside it.
struct MeshFacts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t unreferenced_vertices = 0;      ///< of no usable triangle: no node, no region
  std::size_t repeated_vertex_triangles = 0;  ///< name a vertex twice: no node, no region
  std::size_t zero_area_triangles = 0;        ///< others without area: no mass
  std::size_t duplicate_triangles = 0;        ///< mass counted once
  std::size_t boundary_edges = 0;             ///< one triangle
  std::size_t non_manifold_edges = 0;         ///< three and more: all connected to each other
  std::size_t inconsistent_edges = 0;         ///< two triangles of opposite orientation: connected
  std::size_t zero_length_edges = 0;          ///< one tick long
  std::size_t components = 0;                 ///< of vertices connected by edges
  std::int64_t euler_characteristic = 0;      ///< vertices - edges + triangles, usable ones only
  double area = 0;                            ///< square mesh units
  double bounding_diagonal = 0;               ///< of the referenced vertices, mesh units
};

MeshFacts check_mesh(const Mesh& mesh, const MeshEdges& edges, Executor& executor = sequential());

}  // namespace geolloyd

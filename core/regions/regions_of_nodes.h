#pragma once

#include <cstddef>

#include "core/dual/region_surface.h"
#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "core/voronoi/partition.h"

namespace geolloyd {

/// Of all edges of a mesh those that do not have two triangles, and the duplicates.
MeshEdges irregular_edges(const MeshEdges& edges);

/// `edges` are all of the mesh; in graphs of vertices, irregular_edges() suffice. The triangles may
/// be the mesh's, which then must live on.
RegionSurface make_region_surface(const Mesh& mesh, const MeshEdges& edges,
                                  const MeshGraph& mesh_graph, const Partition& partition,
                                  std::size_t region_count);

/// The point that a node is.
PointId point_of(const MeshGraph& mesh_graph, std::size_t vertex_count, NodeId node);
/// The node that a point is; no_id where it is none.
NodeId node_at(const MeshGraph& mesh_graph, std::size_t vertex_count, PointId point);

}  // namespace geolloyd

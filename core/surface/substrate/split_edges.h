#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/metric.h"

namespace geolloyd {

/// By what edges are measured. A middle has the mean of its ends.
struct EdgeSizes {
  std::vector<double> sizes;   ///< per vertex: wanted length; empty: 1 everywhere
  std::vector<Metric> metric;  ///< per vertex; empty: none
};

/// Halves edges that are longer than `longest` times the smaller size of their ends, and the
/// triangles at them with them, again and again until none is, or the mesh has `vertex_limit`
/// vertices. Edges that coordinates are too coarse to halve stay. `origin` has an entry per
/// triangle; pieces inherit it. All triangles have three vertices.
void split_long_edges(Mesh& mesh, std::vector<TriangleId>& origin, EdgeSizes& sizes, double longest,
                      std::size_t vertex_limit);

}  // namespace geolloyd

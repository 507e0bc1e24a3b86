#pragma once

#include <span>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_quality.h"
#include "geolloyd/choices.h"
#include "geolloyd/runtime.h"
#include "tools/evaluation/edge_lengths.h"

namespace geolloyd {

/// A remesh, judged in the metric of a tangent field of the mesh that it was made from.
struct MetricQuality {
  MeshQuality quality;       ///< angles and Q in the metric
  double mean_length = 0;    ///< of edges
  EdgeLengthRatios lengths;  ///< over the mean
  double energy_ratio = 0;   ///< of cells in the metric, over that of the hexagonal tiling
};

/// `original_edges` are those of the original. The remesh has an edge.
MetricQuality judge_in_metric(const Mesh& remesh, const MeshEdges& edges, const Mesh& original,
                              const MeshEdges& original_edges, std::span<const TangentSpace> field,
                              Runtime& runtime);

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/base/executor.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_quality.h"
#include "geolloyd/evaluation.h"
#include "geolloyd/remesh.h"
#include "tools/evaluation/edge_lengths.h"

namespace geolloyd {

/// What a remesh is judged by, beside the mesh that it was made from.
struct RemeshFigures {
  MeshQuality quality;
  std::optional<MeshQuality> in_metric;           ///< of the field, if there is one
  std::optional<EdgeLengthRatios> length_ratios;  ///< over what was asked for at the ends, in the
                                                  ///< mean; where lengths vary
  std::size_t samples = 0;                        ///< of the mesh
  std::optional<DistanceFigures> distance;  ///< from the mesh to the remesh, if that is a surface;
                                            ///< none after an interrupt, as it takes longest
  std::optional<double> volume_error;       ///< share of the mesh's volume; if both are closed;
                                            ///< none after an interrupt
};

/// Takes some tenths of a second, however large the mesh is. Of its edges only the duplicates
/// count.
RemeshFigures judge_remesh(const Mesh& mesh, const MeshEdges& edges, const MeshFacts& facts,
                           const Remesh& remesh, std::span<const TangentSpace> field,
                           Executor& executor);

}  // namespace geolloyd

#pragma once

#include <cstddef>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/evaluation.h"

namespace geolloyd {

/// Of points of one surface to another: of `samples` >= 1 of them and, the largest, of all
/// vertices. `edges` are those of `from`. The same for any number of threads. Throws InvalidInput
/// where `from` has no area or `to` no triangle.
DistanceFigures measure_distance_one_way(Executor& executor, const Mesh& from,
                                         const MeshEdges& edges, const Mesh& to,
                                         std::size_t samples);

/// Both ways, with `samples` >= 1 on each surface. The same for any number of threads. Throws
/// InvalidInput where one of them has no area.
SurfaceDistance measure_distance(Executor& executor, const Mesh& first, const Mesh& second,
                                 std::size_t samples);

}  // namespace geolloyd

#pragma once

#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// Per vertex of the mesh that `input` was made of: the root of the sum of the squares of the
/// principal curvatures, relative to the root of its mean square over the surface; 1 where all is
/// flat. It is that of normals averaged over about a third of `spacing` (unit frame), so that the
/// noise of a scan is no curvature, and features are none either.
///
/// There is another estimator, core/fields/curvature_field.h: that one has directions and depends
/// on the mesh alone; this one sizes edges, and so depends on how long they are to be.
std::vector<double> relative_curvatures(const Mesh& mesh, const SurfaceInput& input, double spacing,
                                        Executor& executor = sequential());

}  // namespace geolloyd

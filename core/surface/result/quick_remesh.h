#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/surface/substrate/surface_input.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// Per vertex of the mesh that `input` was made of, unit frame: how long the edges of a remesh with
/// `count` vertices are to be so that it is about equally far from the surface everywhere. A quick
/// remesh tells, whose sites hardly rest and whose fit is short. `shape` is that of cells, per
/// vertex of the mesh. Empty where the quick remesh is about equally far everywhere, or is no
/// manifold, or an interrupt came.
std::vector<double> lengths_by_quick_remesh(const Mesh& mesh, const SurfaceInput& input,
                                            std::span<const Metric> shape, std::size_t count,
                                            const RemeshOptions& options, Runtime& runtime);

}  // namespace geolloyd

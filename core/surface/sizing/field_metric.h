#pragma once

#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/metric.h"
#include "geolloyd/choices.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

// The metric of a tangent field is the shape of cells over the square of their size. With the
// principal directions t and b and the magnitudes k1 and k2:

/// Whether cells can follow it: no magnitude is 0, or more than 100 times the other.
bool can_shape(std::span<const TangentSpace> field);

/// k1/k2 t t^T + k2/k1 b b^T + n n^T. Across the surface lengths count as in the mean of
/// directions: where they count too little, sites leave the surface. A space whose directions span
/// no plane is round. Throws InvalidInput where can_shape() is false.
std::vector<Metric> shapes_of(std::span<const TangentSpace> field);

/// 1 / sqrt(k1 k2): so long are edges of length 1 in the metric, in the mean of directions.
std::vector<double> lengths_of(std::span<const TangentSpace> field);

/// Shapes at points of the mesh, interpolated between those of its vertices; none where there are
/// none.
std::vector<Metric> shapes_at(const Mesh& mesh, std::span<const Metric> shape,
                              std::span<const SurfacePoint> places);

}  // namespace geolloyd

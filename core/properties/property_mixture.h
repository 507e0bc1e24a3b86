#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "geolloyd/properties.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// A vertex or a triangle, and how much of it there is.
struct Share {
  std::uint32_t item = 0;
  double weight = 0;
};

/// What a new item is made of: at most four old ones. Weights are not negative and sum to 1, but
/// for rounding; what has no weight does not count.
using Mixture = std::array<Share, 4>;

/// Corners of one of the triangles by barycentric coordinates; nothing for a point of no triangle.
Mixture mixture_at(std::span<const Triangle> triangles, const SurfacePoint& place);

/// Properties of items that are mixtures. Numbers are weighted means, so a linear function stays
/// one, and never leave the range of what is mixed; integers are then rounded. Labels
/// (properties.h) go by majority: the largest sum of weights, the smaller label of equals. Normals
/// (nx, ny, nz) get length 1. Where all that is mixed is equal, it keeps its bits. A value that is
/// no number stays one only where it has a weight.
std::vector<Property> mix(std::span<const Property> properties, std::span<const Mixture> mixtures,
                          Executor& executor = sequential());

}  // namespace geolloyd

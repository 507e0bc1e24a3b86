#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace geolloyd {

// All ids are zero-based and 32 bits wide.
using VertexId = std::uint32_t;    ///< mesh vertex, in input order
using TriangleId = std::uint32_t;  ///< mesh triangle, in input order
using RegionId = std::uint32_t;    ///< region, and the seed that owns it

/// What results speak. Where the nodes of a graph are vertices: the vertex. Where they are
/// triangles: the triangle. Where they are both: the vertex, or (number of vertices) + triangle.
using InputId = std::uint32_t;

/// Stands for "none" wherever an id is expected.
inline constexpr std::uint32_t no_id = std::numeric_limits<std::uint32_t>::max();

using Vec3 = Eigen::Vector3d;

}  // namespace geolloyd

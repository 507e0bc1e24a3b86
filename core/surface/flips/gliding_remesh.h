#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/fit/fit_functional.h"
#include "core/surface/fit/surface_samples.h"
#include "core/surface/flips/flippable_triangles.h"
#include "core/surface/substrate/surface_input.h"

namespace geolloyd {

/// A sample of the surface, with its square distance from the triangle it is nearest to.
struct PlacedSample {
  std::uint32_t sample;
  double square_distance;
};

/// A remesh in the unit frame while its edges are flipped. The first `held` vertices are on curves
/// and do not move; edges of `kept` (each ascending; ascending) are not flipped, and nothing
/// changes about vertices that are `barred`.
struct GlidingRemesh {
  GlidingRemesh(const SurfaceInput& input, std::span<const RegionId> labels, std::size_t held,
                std::span<const std::array<VertexId, 2>> kept, std::span<const std::uint8_t> barred,
                const Mesh& remesh, Executor& executor);

  /// Inside, with more or fewer than six neighbours.
  [[nodiscard]] bool is_irregular(VertexId v) const {
    return triangles.is_inside(v) && triangles.count_around(v) != 6;
  }
  [[nodiscard]] bool is_kept(VertexId a, VertexId b) const;

  SurfaceSamples samples;
  std::span<const std::array<VertexId, 2>> kept;
  std::span<const std::uint8_t> barred;  ///< per vertex: not 0 where it is
  FlippableTriangles triangles;
  std::vector<Vec3> positions;
  std::vector<std::vector<PlacedSample>> on_triangle;  ///< per triangle: the samples nearest to it
  FitSetting fit;
  double price = 0;           ///< of a triangle's strain
  double largest_square = 0;  ///< of a sample's distance, before any glide
};

}  // namespace geolloyd

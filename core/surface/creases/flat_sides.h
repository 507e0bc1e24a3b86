#pragma once

#include <span>

#include "core/surface/creases/edge_angles.h"

namespace geolloyd {

/// Whether the surface is flat beside a sharp edge: so it is where a crease was made, by whatever
/// program, and not where a scan has noise or a soft shape a groove.
/// How far one looks from the edge: half a spacing, or twice the side of the triangle there (the
/// root of its area) and not more than two lengths of the edge or 8 spacings; and never across
/// another sharp edge. Flat is where the mean of the normals has a length of .995, which is about 6
/// degrees from each other, or where they turn evenly along the edge, as beside the rim of a
/// cylinder or a cone, and are about 4 degrees from that; and where there is enough of a surface to
/// say so. Refers to `angles` and `sharp`.
class FlatSides {
 public:
  /// `sharp` is ascending; `spacing` in mesh units.
  FlatSides(const EdgeAngles& angles, std::span<const EdgeId> sharp, double spacing)
      : angles_(angles), sharp_(sharp), spacing_(spacing) {}

  /// Whether one side of the edge is flat. Where the surface turns back by 122 degrees and more, as
  /// in the folds of a scan and hardly in a part (a thread's by 120), both must be.
  [[nodiscard]] bool has_enough(EdgeId e) const;
  /// Whether it is a spacing long and has a plane on both sides, which then are a fact of the
  /// shape, whatever else is near: two triangles and more in a plane, of 4 squares of a spacing.
  [[nodiscard]] bool has_planes(EdgeId e) const;

 private:
  [[nodiscard]] bool is_on_plane(TriangleId side) const;
  [[nodiscard]] bool is_flat(EdgeId e, TriangleId side) const;
  [[nodiscard]] EdgeId edge_opposite(CornerId c) const;
  // no_id where the edge is sharp or has not two triangles.
  [[nodiscard]] TriangleId triangle_beyond(EdgeId e, TriangleId t) const;
  [[nodiscard]] bool is_near(EdgeId e, EdgeId other, double reach) const;

  const EdgeAngles& angles_;
  std::span<const EdgeId> sharp_;
  double spacing_;
};

}  // namespace geolloyd

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/dual/region_surface.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// Where a tessellation lacks the closed ball property (DualMesh, below).
enum class ViolationKind {
  region,    ///< not a disc, or cut up by the surface's boundary
  contact,   ///< two regions that do not meet along one curve with two ends, or meet at the
             ///< boundary more than once
  triple,    ///< three regions that meet at several corners
  isolation  ///< a region that no corner touches
};

struct ClosedBallViolation {
  ViolationKind kind = ViolationKind::region;
  std::array<RegionId, 3> regions = {no_id, no_id, no_id};  ///< whose it is; the first ones
  /// The regions reach edges of three and more triangles: the region itself, both regions of a
  /// contact, two of a triple. There the input is no manifold, and no seed makes it one.
  bool is_of_input = false;
};

/// The dual of a tessellation: vertex r stands for region r, a triangle for each corner at which
/// three regions meet, with the orientation of the surface there.
///
/// Where there are no violations it is homeomorphic to the surface: all regions, the curves where
/// two meet and the corners where three meet are balls, and so are their intersections with the
/// boundary (the closed ball property; Edelsbrunner and Shah 1997).
struct DualMesh {
  std::vector<Triangle> triangles;    ///< of regions; each different
  std::vector<std::uint32_t> corner;  ///< per triangle: the surface's triangle it came from
  std::size_t repeated = 0;           ///< corners left out because their triangle was there
  std::size_t back_to_back = 0;       ///< triangles that lie on another of opposite orientation
  std::vector<ClosedBallViolation> violations;  ///< by kind, then regions ascending
};

std::size_t count(std::span<const ClosedBallViolation> violations, ViolationKind kind);

/// Whether seeds may remove any of them: not all are of the input.
bool any_removable(std::span<const ClosedBallViolation> violations);

DualMesh make_dual(const RegionSurface& surface, Executor& executor = sequential());

}  // namespace geolloyd

#pragma once

#include <span>
#include <vector>

#include "core/surface/cells/cells.h"
#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// What the sites of a surface are labelled with and measured by. Engines differ in how they work,
/// never in what comes out.
///
/// Every vertex of the fine mesh has the label of one site, or none. In a sweep each vertex that is
/// not fixed takes, of its own label and its neighbours', that whose site is nearest to it (in the
/// metric of the vertex, if the mesh has one), of equals the smallest. All read the old labels.
/// Sweeps end when one changes nothing; they do end, because the distance from a vertex to its site
/// only falls. Labels spread along edges alone, so that two sheets that lie close together never
/// share a cell.
class SurfaceEngine {
 public:
  SurfaceEngine() = default;
  SurfaceEngine(const SurfaceEngine&) = delete;
  SurfaceEngine& operator=(const SurfaceEngine&) = delete;
  virtual ~SurfaceEngine() = default;

  /// Begins anew with these labels (no_id: none), some of which never change.
  virtual void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) = 0;
  /// Sweeps to the end, then measures the cell of each site (cell_pieces.h).
  virtual const Cells& evaluate(std::span<const Vec3> sites) = 0;
  /// Of the last evaluate().
  [[nodiscard]] virtual const std::vector<RegionId>& labels() const = 0;
  [[nodiscard]] virtual const Cells& cells() const = 0;
};

}  // namespace geolloyd

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/cells/moments.h"
#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

inline MomentUnit moment_unit(const FineMesh& mesh) {
  return MomentUnit(mesh.whole_mass, mesh.largest_trace);
}

/// The cells of sites, as their moments.
struct Cells {
  std::vector<Moments> moments;        ///< per site
  std::vector<MetricIntegral> metric;  ///< per site; empty where the mesh has no metric

  [[nodiscard]] std::size_t size() const { return moments.size(); }
  void assign(std::span<const Moments> sums) { moments.assign(sums.begin(), sums.end()); }
  void assign(std::span<const MetricMoments> sums);
  void add_empty();
  void remove(std::span<const std::uint8_t> is_removed);

  friend bool operator==(const Cells&, const Cells&) = default;
};

/// The energy of each cell as a function of its site's place: the integral over the cell of the
/// square of the distance to the site.
class CellEnergies {
 public:
  /// `cells` are referred to.
  CellEnergies(const FineMesh& mesh, const Cells& cells)
      : unit_(moment_unit(mesh)), cells_(cells) {}

  [[nodiscard]] double area(std::size_t r) const { return unit_.area(cells_.moments[r]); }
  [[nodiscard]] double at(std::size_t r, const Vec3& site) const {
    return cells_.metric.empty() ? unit_.energy(cells_.moments[r], site)
                                 : unit_.energy(cells_.moments[r], cells_.metric[r], site);
  }
  /// Of cells with an area.
  [[nodiscard]] Vec3 gradient(std::size_t r, const Vec3& site) const {
    return cells_.metric.empty() ? Vec3((site - unit_.centroid(cells_.moments[r])) * (2 * area(r)))
                                 : unit_.gradient(cells_.moments[r], cells_.metric[r], site);
  }
  /// The move that takes a site with this gradient to the minimum, if the cell stays as it is; none
  /// where the cell has no area.
  [[nodiscard]] Vec3 newton_step(std::size_t r, const Vec3& gradient) const {
    if (!(area(r) > 0)) return Vec3::Zero();
    return cells_.metric.empty() ? Vec3(gradient * (-1 / (2 * area(r))))
                                 : Vec3(metric(r).solve(gradient) / -2);
  }
  /// Of a displacement, in the mean of the metric over the cell.
  [[nodiscard]] double mean_length(std::size_t r, const Vec3& displacement) const {
    if (cells_.metric.empty() || !(area(r) > 0)) return norm(displacement);
    return std::sqrt(metric(r).square(displacement) / area(r));
  }

 private:
  [[nodiscard]] Metric metric(std::size_t r) const { return unit_.metric(cells_.metric[r]); }

  MomentUnit unit_;
  const Cells& cells_;
};

}  // namespace geolloyd

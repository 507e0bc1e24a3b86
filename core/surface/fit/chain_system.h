#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"

namespace geolloyd {

/// The moves of a polyline's vertices that bring it closest to points near it, in the mean square,
/// if the foot of each keeps its place on its edge.
class ChainSystem {
 public:
  /// `along`: the direction of each edge, from a vertex to the next one; a loop has one for each
  /// vertex. `stiffness`, up to 1: what a move along an edge counts, beside one away from it.
  ChainSystem(std::span<const Vec3> along, std::size_t vertices, double stiffness);

  /// A point that is `away` from its foot, at a `share` of the way along an edge.
  void add(std::size_t edge, double share, double weight, const Vec3& away);

  /// Vertices that are held (not 0) stay.
  [[nodiscard]] std::vector<Vec3> solve(std::span<const std::uint8_t> is_held) const;

 private:
  // Sums of weight times shares, of the points on an edge.
  struct Shares {
    double first = 0;
    double both = 0;
    double second = 0;
    void add(double weight, double u, double v) {
      first += weight * u * u;
      both += weight * u * v;
      second += weight * v * v;
    }
  };
  struct Edge {
    Vec3 along;
    Shares inside;
    Shares at_ends;  // there a move along counts as any other
  };

  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == pull_.size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return i == 0 ? pull_.size() - 1 : i - 1;
  }
  [[nodiscard]] Vec3 apply(const Edge& edge, double inside, double at_ends, const Vec3& move) const;
  [[nodiscard]] Vec3 best_move(std::size_t i, const std::vector<Vec3>& move) const;

  double stiffness_;
  std::vector<Edge> edges_;  // one for each vertex; that of an open end is empty
  std::vector<Vec3> pull_;   // per vertex
};

}  // namespace geolloyd

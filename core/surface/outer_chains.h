#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/surface_input.h"

namespace geolloyd {

/// A piece of the boundary between two of its corners, or a loop without corners. Sites on it are
/// evenly spaced and stay where they are.
struct OuterChain {
  std::vector<VertexId> vertices;  ///< from end to end; a loop ends where it begins
  std::vector<double> arc;         ///< per vertex: the length up to it, unit frame
  double of_chords = 0;            ///< the length of chords about a spacing of the last level long
  std::size_t least_intervals = 1;
  bool is_loop = false;  ///< one end, which is no corner

  [[nodiscard]] double length() const { return arc.back(); }
  /// Intervals with chords about `spacing` long, and no more than it has edges.
  [[nodiscard]] std::size_t intervals(double spacing) const;
};

/// The boundary of a surface.
struct OuterChains {
  std::vector<OuterChain> chains;
  std::vector<VertexId> corners;                ///< ends of chains, each once, ascending
  std::vector<VertexId> vertices;               ///< on chains, each once, ascending
  std::vector<std::vector<VertexId>> pinholes;  ///< loops too short for sites of their own
  std::vector<VertexId> loops;                  ///< a vertex of each loop, pinholes or not
};

/// A corner is where the boundary turns by more than 50 degrees within half a spacing to either
/// side. A loop is a pinhole, if `may_have_pinholes`, where it is short, two of three even places
/// on it are less than 0.6 spacings apart, and its part has room for some sites beside it.
OuterChains find_outer_chains(const SurfaceInput& input, double spacing, bool may_have_pinholes);

/// Sites on chains: first the corners, then those of each chain from end to end. Each has the label
/// of a vertex, at least.
struct OuterSites {
  std::vector<Vec3> sites;
  std::vector<std::uint32_t> part;  ///< per site
  std::vector<RegionId> label;      ///< per vertex on chains: the nearest site along the chain
};

OuterSites place_outer_sites(const SurfaceInput& input, const OuterChains& outer, double spacing);

/// Pairs of sites that are neighbours on a chain: ascending within, and each once.
std::vector<std::array<RegionId, 2>> neighbours_on_chains(const OuterChains& outer,
                                                          std::span<const RegionId> label);

}  // namespace geolloyd

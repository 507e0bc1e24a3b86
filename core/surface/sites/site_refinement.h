#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/surface/features/curve_sites.h"
#include "core/surface/features/patches.h"
#include "core/surface/sites/level_mesh.h"
#include "core/surface/sites/surface_sites.h"

namespace geolloyd {

/// The first sites: free ones evenly along the spatial order by area, each on a vertex of its own,
/// which gets its label; those on curves as given.
void start_sites(const LevelMesh& level, std::span<const std::size_t> wanted_free,
                 const CurveSites& at_curves, SurfaceSites& sites, std::vector<RegionId>& labels);

/// Which sites a vertex with an old label may belong to after a refinement.
struct Refinement {
  SurfaceSites sites;  ///< those on curves, old free ones, then the middles between neighbours
  std::vector<std::vector<RegionId>> child_sites;  ///< per old site: it, if free, and its middles
};

/// Two sites whose cells meet in a patch.
struct Adjacency {
  std::array<RegionId, 2> sites;  ///< ascending
  PatchId patch = 0;
  friend bool operator==(const Adjacency&, const Adjacency&) = default;
  friend bool operator<(const Adjacency& a, const Adjacency& b) {
    return std::pair(a.sites, a.patch) < std::pair(b.sites, b.patch);
  }
};

/// Those along an edge of the mesh; ascending, and each once.
std::vector<Adjacency> adjacent_cells(const LevelMesh& level, std::span<const RegionId> labels);

/// Free sites are kept, and each pair of adjacent cells gets a new free site midway, unless they
/// are neighbours on a curve. Every new site then has six neighbours. Those on curves are replaced.
/// Midway in `metric` (metric_at_sites()), if there is one: the square distances to both sites,
/// each in its metric, have the least sum there.
Refinement refine_sites(const SurfaceSites& old, std::span<const Adjacency> adjacent,
                        std::span<const std::array<RegionId, 2>> on_curves,
                        const CurveSites& at_curves, std::span<const Metric> metric = {});

/// Per vertex: the nearest child site, in its patch, of its old label's site, of equals the
/// smallest; no_id where there is none. `old_label` is per vertex of a coarser mesh, of which
/// `stands_for` names one for each vertex.
std::vector<RegionId> inherit_labels(const LevelMesh& level, const Refinement& refinement,
                                     std::span<const RegionId> old_label,
                                     std::span<const VertexId> stands_for,
                                     Executor& executor = sequential());

/// Vertices on curves get the labels that are theirs.
void label_curve_vertices(const LevelMesh& level, const CurveSites& at_curves,
                          std::vector<RegionId>& labels);

}  // namespace geolloyd

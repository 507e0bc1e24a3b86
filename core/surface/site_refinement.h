#pragma once

#include <span>
#include <vector>

#include "core/surface/level_mesh.h"
#include "core/surface/outer_chains.h"
#include "core/surface/surface_sites.h"

namespace geolloyd {

/// The first sites: free ones evenly along the spatial order by area, each on a vertex of its own,
/// which gets its label; outer ones as given.
void start_sites(const LevelMesh& level, std::span<const std::size_t> wanted_free,
                 const OuterSites& outer, SurfaceSites& sites, std::vector<RegionId>& labels);

/// Which sites a vertex with an old label may belong to after a refinement.
struct Refinement {
  SurfaceSites sites;  ///< outer ones, old free ones, then the middles between neighbours
  std::vector<std::vector<RegionId>> heirs;  ///< per old site: it, if free, and its middles
};

/// Free sites stay, and each pair of adjacent cells gets a new free site midway, unless they are
/// neighbours on a chain. Every new site then has six neighbours. The outer sites are replaced.
Refinement refine_sites(const SurfaceSites& old, std::span<const std::array<RegionId, 2>> adjacent,
                        std::span<const std::array<RegionId, 2>> on_chains,
                        const OuterSites& outer);

/// Per vertex: the nearest heir of its old label's site, of equals the smallest; no_id where there
/// is none. `old_label` is per vertex of a coarser mesh, of which `stands_for` names one for each
/// vertex.
std::vector<RegionId> inherit_labels(const FineMesh& mesh, const Refinement& refinement,
                                     std::span<const RegionId> old_label,
                                     std::span<const VertexId> stands_for,
                                     Executor& executor = sequential());

/// Vertices on chains get the labels that are theirs.
void label_outer_vertices(const LevelMesh& level, const OuterSites& outer,
                          std::vector<RegionId>& labels);

}  // namespace geolloyd

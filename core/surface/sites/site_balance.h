#pragma once

#include <span>
#include <vector>

#include "core/surface/cells/surface_engine.h"
#include "core/surface/sites/level_mesh.h"
#include "core/surface/sites/surface_sites.h"

namespace geolloyd {

/// Gives each patch the number of free sites that it is to have: removes the sites whose cells have
/// least energy, and puts new ones where cells have most, at the vertex farthest from the site.
/// Cells with more than twice the mean energy of their patch get a new site in any case, at the
/// cost of the least ones. Sites without a vertex are removed. `cells` are those of `sites` with
/// these labels. Ties go to the smaller id.
void balance_sites(const LevelMesh& level, std::span<const std::size_t> wanted_free,
                   const Cells& cells, SurfaceSites& sites, std::vector<RegionId>& labels);

/// Takes out the sites that are marked, none on the boundary. Their vertices lose their labels.
void remove_sites(std::span<const std::uint8_t> is_removed, SurfaceSites& sites,
                  std::vector<RegionId>& labels);

}  // namespace geolloyd

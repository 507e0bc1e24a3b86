#pragma once

#include <vector>

#include "core/dual/dual_mesh.h"

namespace geolloyd {

/// A place for a further seed, and the regions that it is to help.
struct SeedInsertion {
  std::array<RegionId, 3> regions = {no_id, no_id, no_id};
  PointId point = no_id;  ///< a node, but no seed
};

/// Where further seeds would remove the violations of a dual, in the order of the violations. The
/// places are where the waves that run from the seeds meet in a way they should not: a region that
/// is no disc   at the end of each edge that closes a loop which nothing fills; a
///                            sphere, at its farthest point
/// its share of the boundary, or a contact   of each of its curves the point nearest to the seed,
///                            and of these the farthest
/// a triple                   the farthest of the points at its corners
/// isolation                  the farthest point of the region
/// None for a violation of the input, nor for one whose regions have no node but their seed.
std::vector<SeedInsertion> find_seed_insertions(const RegionSurface& surface, const DualMesh& dual);

/// Of these, those of one violation, but of no two that concern the same region: one seed may mend
/// both. The earlier ones stay, in their order.
std::vector<SeedInsertion> leave_out_neighbours(std::vector<SeedInsertion> insertions,
                                                std::size_t region_count);

}  // namespace geolloyd

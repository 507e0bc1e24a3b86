#pragma once

#include "core/base/executor.h"
#include "core/dual/dual_mesh.h"
#include "core/surface/features/patches.h"
#include "core/surface/sites/site_levels.h"

namespace geolloyd {

/// Sites, the moments of their cells, and the dual of the cells.
struct DualisedSites {
  LabelledSites state;
  Cells cells;
  DualMesh dual;
};

/// Lets all sites move on the fine mesh, and inserts sites where the dual has violations of the
/// closed ball property (seed_insertion.h), until it has none. As many sites with little energy are
/// removed elsewhere, so that there are as many sites as before. Where moving brings violations
/// back, as where a sheet is thinner than a spacing, the inserted sites and their neighbours are
/// fixed; if the others cannot make room either, there are more sites than wanted. Where a place
/// for a site is on a curve that has no room, it goes beside the curve. Where a triangle of the
/// dual has no area, as of three sites on a straight curve, a further site comes between. An
/// interrupt ends the moving of sites, and their insertion after a few more rounds; a few hundred
/// rounds end it in any case, and so do more sites than `most_sites`. Then `dual.violations` is not
/// empty.
DualisedSites repair_dual(const DividedSurface& surface, RestingSites resting,
                          std::size_t most_sites, SiteRelaxer& relaxer,
                          Executor& executor = sequential());

}  // namespace geolloyd

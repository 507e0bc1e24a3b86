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
/// fixed; if the others cannot make room either, there are more sites than wanted. An interrupt
/// ends the moving of sites, not their insertion.
DualisedSites repair_dual(const DividedSurface& surface, RestingSites resting, SiteRelaxer& relaxer,
                          Executor& executor = sequential());

}  // namespace geolloyd

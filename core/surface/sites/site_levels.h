#pragma once

#include "core/base/executor.h"
#include "core/surface/features/patches.h"
#include "core/surface/sites/site_budget.h"
#include "core/surface/sites/site_relaxer.h"

namespace geolloyd {

/// Sites that have come to rest on the mesh of the last level, and their labels on the fine mesh.
struct RestingSites {
  LabelledSites state;
  SiteBudget budget;  ///< how many there are to be
};

/// How much work is done until sites rest.
struct RestEffort {
  std::size_t vertex_visits = 5'000'000;  ///< in the iterations of a level, within these limits:
  std::size_t fewest_iterations = 35;
  std::size_t most_iterations = 200;
  bool tries_again = true;  ///< from the few sites of the first levels, shaken
};

/// Moves sites from coarse to fine. The first level has some hundred sites. Each next one has about
/// four times as many: the old ones and the middles between neighbours, which makes nearly all of
/// them regular. The sites of a level move downhill on a mesh that is just fine enough for them.
/// There are `count`, or the least that the patches of the surface need.
RestingSites rest_sites(const DividedSurface& surface, std::size_t count, SiteRelaxer& relaxer,
                        const RestEffort& effort, Executor& executor = sequential());

}  // namespace geolloyd

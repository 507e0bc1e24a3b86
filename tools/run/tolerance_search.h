#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tools/evaluation/vertex_search.h"
#include "tools/run/remesh.h"

namespace geolloyd {

/// What a search for the fewest vertices found.
struct ToleranceSearch {
  TimedRemesh best;  ///< the fewest vertices whose distance was within the tolerance
  std::vector<ToleranceTrial> trials;
};

/// Tries remeshes (evaluation/vertex_search.h) until it has the fewest vertices within `tolerance`,
/// mesh units. After an interrupt the best one so far, or the last one. `make` makes one of so many
/// vertices.
ToleranceSearch search_within(double tolerance, const LoadedInput& loaded,
                              const std::function<TimedRemesh(std::size_t vertices)>& make,
                              Scheduler& scheduler, ProgressLine& progress);

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tools/run/surface_remesh.h"

namespace geolloyd {

/// A remesh that was tried, and how far it is from the input: the largest distance, of both ways,
/// that samples and vertices find.
struct ToleranceTrial {
  std::size_t vertices = 0;
  double distance = 0;
};

/// What a search for the fewest vertices found.
struct ToleranceSearch {
  TimedRemesh best;  ///< the fewest vertices whose distance was within the tolerance
  std::vector<ToleranceTrial> trials;
};

/// Tries remeshes, whose distance falls about as the number of vertices grows, until the best one
/// has at most a twentieth more vertices than one that is too far. Throws InvalidInput where none
/// of up to `most` vertices is within `tolerance`, mesh units. After an interrupt the best one so
/// far, or the last one. `make` makes one of so many vertices.
ToleranceSearch search_within(double tolerance, std::size_t most, const LoadedInput& loaded,
                              const std::function<TimedRemesh(std::size_t vertices)>& make,
                              Scheduler& scheduler, ProgressLine& progress);

}  // namespace geolloyd

#pragma once

#include <vector>

#include "core/course/remesh_course.h"
#include "geolloyd/evaluation.h"

namespace geolloyd {

/// What a search for the fewest vertices found.
struct ToleranceSearch {
  TimedRemesh best;       ///< the fewest vertices whose distance was within the tolerance
  DistanceBounds bounds;  ///< of its distance
  std::vector<ToleranceTrial> trials;
};

/// Tries remeshes (vertex_search.h) until it has the fewest vertices within `tolerance`, mesh
/// units. Where a hook or the options' progress ends the work, the best one so far, or where
/// there is none, the one at work: nobody has measured that. Throws InvalidInput also where many
/// vertices are not enough.
ToleranceSearch search_within(double tolerance, RemeshCourse course);

}  // namespace geolloyd

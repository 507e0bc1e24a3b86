#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "core/regions/tessellation.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/run/dual.h"
#include "tools/run/resumable.h"

namespace geolloyd {

/// What a run of `relax` found.
struct Result {
  Relaxation relaxation;
  std::size_t threads = 0;  ///< of the relaxation
  std::optional<EarlierPart> resumed;
  std::optional<GroundTruth> ground_truth;
  std::optional<MadeDual> dual;
  std::vector<RegionSummary> regions;
  bool interrupted = false;  ///< before the results were written: they may be less than otherwise
};

/// What a run of `relax` took after its start.
struct Cost {
  double relax_seconds = 0;
  double ground_truth_seconds = 0;
  double dual_seconds = 0;
  double write_seconds = 0;
  double total_seconds = 0;             ///< of everything
  std::uint64_t peak_memory_bytes = 0;  ///< until the results were written
};

}  // namespace geolloyd

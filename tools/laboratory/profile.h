#pragma once

#include <array>
#include <cstdint>

#include "core/lloyd/relaxation.h"
#include "tools/report/report_parts.h"

namespace geolloyd {

/// What one phase of a relaxation came to.
struct PhaseProfile {
  std::size_t steps = 0;
  std::size_t microsteps = 0;
  std::uint64_t node_visits = 0;
  KernelSeconds seconds;

  /// Share of the time in which regions are found: Dijkstra's algorithm in the reference, whatever
  /// stands for it in the parallel engine.
  [[nodiscard]] double search_share() const {
    const double all = total(seconds);
    return all > 0 ? (seconds.free_search + seconds.locked_search) / all : 0;
  }
};

PhaseProfile profile_of(const Relaxation& relaxation, Phase phase);

/// Regions whose seed moved at all during the step. A seed that stays in the first microstep of a
/// macrostep stays to its end.
std::uint32_t active_regions(const Step& step);

/// JSON objects: per phase that has steps, and per step.
Json phase_rows(const Relaxation& relaxation);
Json step_rows(const Relaxation& relaxation);

}  // namespace geolloyd

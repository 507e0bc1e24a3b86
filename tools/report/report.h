#pragma once

#include <span>
#include <string>

#include "geolloyd/threads.h"
#include "tools/run/result.h"

namespace geolloyd {

/// How a result came about, as far as its report tells.
struct RelaxFacts {
  RunRequest request;
  RelaxationOptions options;
  EngineKind engine = EngineKind::parallel;
  Frontier frontier = Frontier::automatic;
  Backend backend = Backend::tbb;
  DualRequest dual;
};

/// report.json: everything a script may want to know of a run; the README lists the keys.
std::string report_text(const RelaxFacts& facts, const PreparedInput& start, const Result& result,
                        const Cost& cost);

/// Energy of the hexagonal tiling with as much area and as many regions.
double hexagonal_energy(std::span<const RegionSummary> regions, const MeshFacts& facts);

}  // namespace geolloyd

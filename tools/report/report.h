#pragma once

#include <span>
#include <string>

#include "tools/run/result.h"

namespace geolloyd {

/// report.json: everything a script may want to know of a run; the README lists the keys.
std::string report_text(const RelaxArguments& arguments, const Start& start, const Result& result,
                        const Cost& cost);

/// Energy of the hexagonal tiling with as much area and as many regions.
double hexagonal_energy(std::span<const RegionSummary> regions, const MeshFacts& facts);

}  // namespace geolloyd

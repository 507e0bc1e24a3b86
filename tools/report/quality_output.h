#pragma once

#include <string>

#include "geolloyd/evaluation.h"
#include "geolloyd/quality.h"
#include "tools/files/json.h"
#include "tools/run/quality.h"

namespace geolloyd {

/// Angles, quality and valences: three lines for people, and the part `quality` of JSON files.
std::string describe(const MeshQuality& quality);
/// Two lines, without the valences, which a metric does not change.
std::string describe_in_metric(const MeshQuality& quality);
Json quality_part(const MeshQuality& quality);
/// Mesh units, and percent of `diagonal`.
Json distance_part(const DistanceFigures& figures, double diagonal);
Json bounds_part(const DistanceBounds& bounds, double diagonal);

/// For people.
std::string quality_text(const QualityRecord& record);

/// For scripts: JSON.
std::string quality_report(const QualityRecord& record);

}  // namespace geolloyd

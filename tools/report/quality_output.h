#pragma once

#include <string>

#include "tools/run/quality.h"

namespace geolloyd {

/// For people.
std::string quality_text(const QualityRecord& record);

/// For scripts: JSON.
std::string quality_report(const QualityRecord& record);

}  // namespace geolloyd

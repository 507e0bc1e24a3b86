#pragma once

#include <string>

#include "tools/run/run_record.h"

namespace geolloyd {

/// report.json: everything a script may want to know of a run; the README lists the keys.
std::string report_text(const RunRecord& run);

}  // namespace geolloyd

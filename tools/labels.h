#pragma once

#include <vector>

#include "core/mesh_io.h"
#include "tools/run_record.h"

namespace geolloyd {

/// Region and colour of each input id; adjacent regions differ in colour, no region is grey.
std::vector<Label> label_input_ids(const RunRecord& run);

}  // namespace geolloyd

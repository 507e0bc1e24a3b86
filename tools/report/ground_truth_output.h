#pragma once

#include <string>

#include "tools/report/report_parts.h"
#include "tools/run/run_record.h"

namespace geolloyd {

// What is told of a run's ground truth, which there must be.

/// A few lines for people.
std::string describe(const GroundTruth& truth);

/// The README lists the keys.
Json ground_truth_part(const GroundTruth& truth);

/// Makes the folder of the command `ground-truth` and makes sure that the results can be written
/// and would replace no input. Throws Error.
void prepare_ground_truth_output(const RelaxArguments& arguments);

/// ground-truth-regions.csv: a line per input id. ground-truth-seeds.csv: a line per region.
/// ground-truth.json, the last to appear.
void write_ground_truth(const RunRecord& run);

}  // namespace geolloyd

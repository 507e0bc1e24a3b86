#pragma once

#include <filesystem>
#include <string>

#include "tools/evaluation/ground_truth.h"
#include "tools/files/output_folder.h"
#include "tools/report/report_parts.h"
#include "tools/run/stages.h"

namespace geolloyd {

// What is told of a ground truth.

/// A few lines for people.
std::string describe(const GroundTruth& truth);

/// The README lists the keys.
Json ground_truth_part(const GroundTruth& truth);

/// The partition of the seeds with which a run begins, and what it is judged by.
struct JudgedPartition {
  Partition partition;
  GroundTruth truth;
  std::size_t threads = 0;
  double seconds = 0;  ///< to find the ground truth
};

/// Makes the folder of the command `ground-truth`, if it is named, and makes sure that the results
/// can be written and would replace no input. Throws Error.
[[nodiscard]] MadeFolders prepare_ground_truth_output(const std::filesystem::path& folder,
                                                      const RunRequest& request);

/// ground-truth-regions.csv: a line per input id. ground-truth-seeds.csv: a line per region.
/// ground-truth.json, the last to appear. No file where no folder is named. Returns the text of
/// ground-truth.json.
std::string write_ground_truth(const std::filesystem::path& folder, const RunRequest& request,
                               const PreparedInput& start, const JudgedPartition& judged);

}  // namespace geolloyd

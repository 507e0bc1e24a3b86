#pragma once

#include <nlohmann/json.hpp>

#include "tools/run_record.h"

namespace geolloyd {

/// Everything a script may want to know of a run; the README lists the keys.
nlohmann::ordered_json make_report(const RunRecord& run);

/// The same as text. Names that are not UTF-8 get replacement characters.
std::string report_text(const RunRecord& run);

/// The fingerprint as 16 hexadecimal digits.
std::string fingerprint_text(std::uint64_t fingerprint);

/// Most memory this process has held, bytes.
std::uint64_t peak_memory_bytes();

/// Of the first seeds.
double initial_energy(const Relaxation& relaxation);

/// Sums over the steps of a trace.
struct StepCounts {
  std::size_t greedy = 0;
  std::size_t macro = 0;
  std::size_t micro = 0;
  std::size_t partitions = 0;  ///< searches, regions free and locked
  std::uint64_t node_visits = 0;
};
StepCounts count_steps(const Relaxation& relaxation);

}  // namespace geolloyd

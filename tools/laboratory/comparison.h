#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/lloyd/relaxation.h"
#include "tools/report/report_parts.h"
#include "tools/system/progress.h"
#include "tools/words/names.h"

namespace geolloyd {

/// One way of relaxing, and what came of it.
struct Contender {
  EngineKind engine = EngineKind::parallel;
  Frontier frontier = Frontier::automatic;
  Backend backend = Backend::tbb;
  std::size_t threads = 1;

  std::vector<double> seconds;  ///< of each turn, ascending
  std::uint64_t peak_memory_bytes = 0;
  std::uint64_t fingerprint = 0;  ///< of the first turn, or of the first that differs from it

  [[nodiscard]] double median() const {
    return (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]) / 2;
  }
};

/// The same relaxation in several ways. The first of them says what is right; it is the reference
/// engine unless that was left out.
struct Comparison {
  std::vector<Contender> contenders;  ///< those with results
  StepCounts steps;
  std::size_t nodes = 0;

  [[nodiscard]] bool is_equal(const Contender& c) const {
    return c.fingerprint == contenders.front().fingerprint;
  }
  /// Against the reference engine.
  [[nodiscard]] std::optional<double> speedup(const Contender& c) const;
  /// Speed-up against the same with one thread, per thread.
  [[nodiscard]] std::optional<double> efficiency(const Contender& c) const;
};

/// Lets the contenders take turns, so that what disturbs the machine for a while disturbs all; the
/// reference engine, slow enough to be measured well, has one turn only. An interrupt ends it.
Comparison compare(std::vector<Contender> contenders, std::size_t turns, const Graph& graph,
                   const std::vector<NodeId>& seeds, const RelaxationOptions& options,
                   ProgressLine& progress);

/// For people: "parallel regions tbb, 2 threads".
std::string title_of(const Contender& contender);

/// A JSON object per contender.
Json rows_of(const Comparison& comparison);

}  // namespace geolloyd

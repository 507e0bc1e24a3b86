#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/stopwatch.h"
#include "core/course/prepared_run.h"
#include "geolloyd/runtime.h"
#include "tools/run/checkpoint.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// What was done before a run that resumed it.
struct EarlierPart {
  std::size_t steps = 0;
  double seconds = 0;  ///< of the relaxation
};

/// A relaxation that has ended.
struct EndedRelaxation {
  Relaxation relaxation;
  std::unique_ptr<Engine> engine;  ///< with the partition of the seeds as they are now
  double seconds = 0;
};

/// How a relaxation can be resumed.
struct CheckpointPlan {
  std::filesystem::path folder;
  double seconds = 60;     ///< between two checkpoints
  bool begins_it = false;  ///< the relaxation begins with the one that is there
};

/// The relaxation of one run of `relax`: keeps checkpoints of itself, and may begin with one.
class ResumableRelaxation {
 public:
  /// Reads the checkpoint if the plan says so. `run` must live on. Throws Error.
  ResumableRelaxation(const PreparedRun& run, const RelaxationOptions& options,
                      const CheckpointPlan& plan);

  /// Of a run that goes on.
  [[nodiscard]] const std::optional<EarlierPart>& resumed() const { return resumed_; }

  /// Goes on until the relaxation ends or an interrupt comes.
  EndedRelaxation relax(Runtime& runtime, ProgressLine& progress,
                        const StepStartCallback& beginning);

  /// Writes a checkpoint of the last boundary between two steps. Where it cannot, that is said, and
  /// no reason to lose the work: returns false.
  bool save(ProgressLine& progress);

  /// Takes the checkpoint away.
  void forget();

 private:
  const PreparedRun& run_;
  RelaxationOptions options_;
  double seconds_between_;
  CheckpointFile file_;
  std::optional<EarlierPart> resumed_;
  RelaxationState state_;
  Stopwatch watch_;
  Stopwatch since_saved_;
};

}  // namespace geolloyd

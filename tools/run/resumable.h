#pragma once

#include <memory>
#include <vector>

#include "core/base/stopwatch.h"
#include "parallel/threads/scheduler.h"
#include "tools/run/checkpoint.h"
#include "tools/run/run_record.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// The relaxation of one run of `relax`: keeps checkpoints of itself in the output folder, and may
/// begin with one.
class ResumableRelaxation {
 public:
  /// Reads the checkpoint if the arguments say so. `run` must live on. Throws Error.
  ResumableRelaxation(RunRecord& run, std::vector<NodeId> first_seeds);

  /// Until it ends or an interrupt comes. Returns the engine, with the partition of the seeds as
  /// they are then.
  std::unique_ptr<Engine> relax(Scheduler& scheduler, ProgressLine& progress);

  /// Writes a checkpoint of the last boundary between two steps. Where it cannot, that is said, and
  /// no reason to lose the work: returns false.
  bool save(ProgressLine& progress);

  /// Takes the checkpoint away.
  void forget();

 private:
  RunRecord& run_;
  std::vector<NodeId> first_seeds_;
  CheckpointFile file_;
  RelaxationState state_;
  double earlier_seconds_ = 0;
  Stopwatch watch_;
  Stopwatch since_saved_;
};

}  // namespace geolloyd

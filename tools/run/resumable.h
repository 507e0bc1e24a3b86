#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/stopwatch.h"
#include "geolloyd/runtime.h"
#include "tools/cli/relax_arguments.h"
#include "tools/run/checkpoint.h"
#include "tools/run/stages.h"
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
  /// Seeds at the start of each step that this run took, the last ones; for a page, else none.
  std::vector<std::vector<NodeId>> course;
  std::size_t threads = 0;
  double seconds = 0;
};

/// The relaxation of one run of `relax`: keeps checkpoints of itself in the output folder, and may
/// begin with one.
class ResumableRelaxation {
 public:
  /// Reads the checkpoint if the arguments say so. Both must live on. Throws Error.
  ResumableRelaxation(const RelaxArguments& arguments, const Start& start);

  /// Of a run that goes on.
  [[nodiscard]] const std::optional<EarlierPart>& resumed() const { return resumed_; }

  /// Goes on until the relaxation ends or an interrupt comes.
  EndedRelaxation relax(Runtime& runtime, ProgressLine& progress);

  /// Writes a checkpoint of the last boundary between two steps. Where it cannot, that is said, and
  /// no reason to lose the work: returns false.
  bool save(ProgressLine& progress);

  /// Takes the checkpoint away.
  void forget();

 private:
  const RelaxArguments& arguments_;
  const Start& start_;
  CheckpointFile file_;
  std::optional<EarlierPart> resumed_;
  RelaxationState state_;
  Stopwatch watch_;
  Stopwatch since_saved_;
};

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/course/remesh_course.h"
#include "geolloyd/properties.h"
#include "parallel/threads/scheduler.h"
#include "tools/evaluation/remesh_figures.h"
#include "tools/run/remesh.h"
#include "tools/words/names.h"

namespace geolloyd {

/// Who makes a remesh.
struct RemeshWorkers {
  EngineKind engine = EngineKind::parallel;
  Backend backend = Backend::tbb;
  std::size_t threads = 0;
};

/// All there is to tell of one run of `remesh`.
struct RemeshResult {
  TimedRemesh made;
  std::vector<ToleranceTrial> trials;    ///< none without a tolerance
  std::optional<DistanceBounds> bounds;  ///< of the distance, of both ways; if there is a tolerance
  RemeshFigures figures;
  Properties properties;  ///< of the remesh
  RemeshWorkers workers;
  std::uint64_t memory_estimate = 0;  ///< bytes
  double judge_seconds = 0;
  double write_seconds = 0;
  double total_seconds = 0;             ///< of everything until the files were written
  std::uint64_t peak_memory_bytes = 0;  ///< until then
};

/// A mesh that was read, and its remesh.
struct RemeshedInput {
  LoadedInput loaded;
  std::vector<TangentSpace> field;
  RemeshResult result;
};

/// Is told how many bytes the run will hold at most, each time before it holds more. May throw,
/// which ends the run.
using MemoryCheck = std::function<void(std::uint64_t bytes)>;

/// Reads the mesh, remeshes it, carries its properties over and judges the remesh: all of `remesh`
/// but its files. Shows progress. `picture`: of one that will be drawn.
RemeshedInput remesh_input(const RemeshRequest& request, const std::optional<PictureLook>& picture,
                           EngineKind engine, const MemoryCheck& check_memory, Scheduler& scheduler,
                           ProgressLine& progress);

}  // namespace geolloyd

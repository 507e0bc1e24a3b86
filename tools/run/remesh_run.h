#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "geolloyd/properties.h"
#include "parallel/threads/scheduler.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/run/input.h"
#include "tools/run/remesh.h"
#include "tools/run/tolerance_search.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// All there is to tell of one run of `remesh`.
struct RemeshResult {
  TimedRemesh made;
  std::vector<ToleranceTrial> trials;  ///< none without a tolerance
  RemeshFigures figures;
  Properties properties;  ///< of the remesh
  std::size_t threads = 0;
  std::uint64_t memory_estimate = 0;  ///< bytes
  double judge_seconds = 0;
  double write_seconds = 0;
  double total_seconds = 0;             ///< of everything until the files were written
  std::uint64_t peak_memory_bytes = 0;  ///< until then
};

/// A mesh that was read, and its remesh.
struct RemeshedInput {
  LoadedInput loaded;
  RemeshResult result;
};

/// Is told how many bytes the run will hold at most, each time before it holds more. May throw,
/// which ends the run.
using MemoryCheck = std::function<void(std::uint64_t bytes)>;

/// Throws InvalidInput where options contradict each other, before anything is read.
void check_remesh(const RemeshArguments& arguments);

/// Reads the mesh, remeshes it, carries its properties over and judges the remesh: all of `remesh`
/// but its files. Shows progress.
RemeshedInput remesh_input(const RemeshArguments& arguments, const MemoryCheck& check_memory,
                           Scheduler& scheduler, ProgressLine& progress);

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/executor.h"
#include "geolloyd/threads.h"
#include "parallel/threads/backends.h"

namespace geolloyd {

/// The threads of this machine as an executor. The results of a stage never depend on the number of
/// threads, on the backend, or on who did what.
class Scheduler : public Executor {
 public:
  /// `threads` 0: as many as can run at once (available_cores.h). More are allowed, and slower.
  explicit Scheduler(std::size_t threads = 0, Backend backend = Backend::tbb);
  [[nodiscard]] Backend backend() const { return backend_; }

  void run(std::size_t workers, const std::function<void(std::size_t worker)>& work) override;

  /// The same for long works that have schedulers of their own, with the same backend. With oneTBB
  /// a thread that has no work left helps the others in their loops.
  void run_apart(std::size_t workers, const std::function<void(std::size_t worker)>& work);

 private:
  Backend backend_;
  TbbPoolPointer tbb_;  // null where not used
};

/// Numbers of threads to compare: 1, 2, 4 and so on, up to all that can run at once.
std::vector<std::size_t> thread_ladder();

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "parallel/threads/backends.h"

namespace geolloyd {

/// Whose threads do the work: oneTBB's or OpenMP's.
enum class Backend { tbb, openmp };

/// The threads that the parallel twins of core's functions work on. Everything parallel is said in
/// terms of run(), by way of primitives.h; results never depend on the number of threads, on the
/// backend, or on who did what. To be used by one thread at a time.
class Scheduler {
 public:
  /// `threads` 0: as many as the machine has. More than that is allowed, and slower.
  explicit Scheduler(std::size_t threads = 0, Backend backend = Backend::tbb);
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;
  ~Scheduler() = default;

  [[nodiscard]] std::size_t threads() const { return threads_; }
  [[nodiscard]] Backend backend() const { return backend_; }

  /// Calls `work` once with each number in [0, workers), on that many threads as far as these are
  /// free, the caller's among them, and returns when all calls have. `workers` <= threads(). What
  /// the caller wrote before, they see; what they wrote, the caller sees after. What is
  /// thrown first reaches the caller, after all calls.
  void run(std::size_t workers, const std::function<void(std::size_t worker)>& work);

 private:
  std::size_t threads_;
  Backend backend_;
  TbbPoolPointer tbb_;  // null where not used
};

/// Numbers of threads to compare: 1, 2, 4 and so on, up to all that the machine has.
std::vector<std::size_t> thread_ladder();

}  // namespace geolloyd

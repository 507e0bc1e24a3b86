#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <vector>

#include "parallel/threads/scheduler.h"

namespace geolloyd {

/// A work that waits for its turn.
struct QueuedWork {
  std::uint64_t work = 0;          ///< in any unit
  std::uint64_t memory_bytes = 0;  ///< that it holds at most, as far as that is known
};

class WorkQueue;

/// Of the memory that may be held, what one work may hold.
class MemoryShare {
 public:
  MemoryShare(WorkQueue& queue, std::uint64_t bytes) : queue_(queue), bytes_(bytes) {}
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;
  ~MemoryShare();

  /// Becomes so many. Throws TooLittleMemory where others leave less.
  void become(std::uint64_t bytes);
  [[nodiscard]] bool is_everything() const;

 private:
  WorkQueue& queue_;
  std::uint64_t bytes_;
};

/// Ends a work, which begins anew when others leave so much.
struct TooLittleMemory {
  std::uint64_t bytes;
};

/// Does several works at once, such as remeshes, the largest first. Each has one thread; threads
/// that find none left help the others where these have loops to share (Scheduler::run_apart). So a
/// few large works and many small ones keep all threads busy. Of works that would hold more memory
/// than is allowed, some wait.
class WorkQueue {
 public:
  /// Does the n-th work. Where it throws TooLittleMemory, that goes back into the queue. Any other
  /// exception ends the queue, once the works begun have ended, and reaches the caller.
  using Work = std::function<void(std::size_t n, MemoryShare& share)>;

  /// Together the works may hold so many bytes; one alone may ask for all. `scheduler` must live
  /// on.
  WorkQueue(std::vector<QueuedWork> works, std::uint64_t memory_bytes, Scheduler& scheduler);

  /// Until all works are done, or an interrupt (interrupt.h) comes: then works begun still end.
  void run(const Work& work);

 private:
  friend class MemoryShare;

  void serve(const Work& work);
  std::optional<std::size_t> take();
  void put_back(std::size_t n, std::uint64_t bytes);

  std::vector<QueuedWork> works_;
  std::uint64_t memory_;
  Scheduler& scheduler_;
  std::mutex mutex_;                // of all that follows
  std::list<std::size_t> waiting_;  // most work first
  std::uint64_t held_ = 0;
  bool ends_round_ = false;
};

}  // namespace geolloyd

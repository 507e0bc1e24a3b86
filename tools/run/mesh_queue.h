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

/// A mesh that waits for its turn.
struct QueuedMesh {
  std::uint64_t work = 0;          ///< in any unit
  std::uint64_t memory_bytes = 0;  ///< that the work holds at most, as far as that is known
};

class MeshQueue;

/// Of the memory that may be held, what the work on a mesh may hold.
class MemoryShare {
 public:
  MemoryShare(MeshQueue& queue, std::uint64_t bytes) : queue_(queue), bytes_(bytes) {}
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;
  ~MemoryShare();

  /// Becomes so many. Throws TooLittleMemory where others leave less.
  void become(std::uint64_t bytes);
  [[nodiscard]] bool is_everything() const;

 private:
  MeshQueue& queue_;
  std::uint64_t bytes_;
};

/// Ends the work on a mesh, which begins anew when others leave so much.
struct TooLittleMemory {
  std::uint64_t bytes;
};

/// Works on several meshes at once, the one with the most work first. Each mesh has one thread;
/// threads that find none left help those that are still at work (Scheduler::run_apart). So a few
/// large meshes and many small ones keep all threads busy. Of meshes that would hold more memory
/// than is allowed, some wait.
class MeshQueue {
 public:
  /// Where it throws TooLittleMemory, the mesh goes back into the queue. Any other exception ends
  /// the queue, once the works begun have ended, and reaches the caller.
  using Work = std::function<void(std::size_t mesh, MemoryShare& share)>;

  /// Together the works may hold so many bytes; one alone may ask for all. `scheduler` must live
  /// on.
  MeshQueue(std::vector<QueuedMesh> meshes, std::uint64_t memory_bytes, Scheduler& scheduler);

  /// Until all meshes are done, or an interrupt (interrupt.h) comes: then works begun still end.
  void run(const Work& work);

 private:
  friend class MemoryShare;

  void serve(const Work& work);
  std::optional<std::size_t> take();
  void put_back(std::size_t mesh, std::uint64_t bytes);

  std::vector<QueuedMesh> meshes_;
  std::uint64_t memory_;
  Scheduler& scheduler_;
  std::mutex mutex_;                // of all that follows
  std::list<std::size_t> waiting_;  // most work first
  std::uint64_t held_ = 0;
  bool ends_round_ = false;
};

}  // namespace geolloyd

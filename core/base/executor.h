#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace geolloyd {

/// Who does the work of a stage: the calling thread, or several threads (parallel/threads). Every
/// stage between a mesh and its graph takes an executor and is written once, by the loops of
/// loops.h. The result of a stage is the same to the byte on any executor.
class Executor {
 public:
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// At least 1.
  [[nodiscard]] std::size_t threads() const { return threads_; }

  /// Calls `work` once with each number in [0, workers) and returns when all calls have. `workers`
  /// <= threads(). What the caller wrote before, the calls see; what they wrote, the caller sees
  /// after. The first exception reaches the caller, after all calls. One thread at a time may call
  /// this.
  virtual void run(std::size_t workers, const std::function<void(std::size_t worker)>& work) = 0;

  /// Something to be called often, never twice at once: whenever the work comes by heed(), as each
  /// loop of loops.h does again and again, by the calling thread or, with oneTBB, now and then by
  /// another. What it throws ends the work. Not for sequential(), which is everybody's.
  void set_watch(std::function<void()> watch) { watch_ = std::move(watch); }
  void heed() const {
    if (watch_) watch_();
  }

 protected:
  explicit Executor(std::size_t threads) : threads_(threads) {}

 private:
  std::size_t threads_;
  std::function<void()> watch_;  // empty: nobody watches
};

/// The calling thread alone. Has no state: any number of threads may use it at once.
Executor& sequential();

}  // namespace geolloyd

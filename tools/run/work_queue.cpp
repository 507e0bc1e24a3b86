#include "tools/run/work_queue.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tools/system/interrupt.h"

namespace geolloyd {

MemoryShare::~MemoryShare() {
  const std::lock_guard lock(queue_.mutex_);
  queue_.held_ -= bytes_;
}

void MemoryShare::become(std::uint64_t bytes) {
  const std::lock_guard lock(queue_.mutex_);
  bytes = std::min(bytes, queue_.memory_);
  if (bytes > queue_.memory_ - (queue_.held_ - bytes_)) throw TooLittleMemory{bytes};
  queue_.held_ += bytes - bytes_;
  bytes_ = bytes;
}

bool MemoryShare::is_everything() const {
  return bytes_ == queue_.memory_;
}

WorkQueue::WorkQueue(std::vector<QueuedWork> works, std::uint64_t memory_bytes,
                     Scheduler& scheduler)
    : works_(std::move(works)), memory_(memory_bytes), scheduler_(scheduler) {
  std::vector<std::size_t> order(works_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return works_[a].work > works_[b].work; });
  waiting_.assign(order.begin(), order.end());
}

// A thread that finds no work small enough for the memory left ends its part of the round, and
// helps others meanwhile. They then end theirs, too, so that all can begin anew.
void WorkQueue::run(const Work& work) {
  while (!waiting_.empty() && !interrupted()) {
    ends_round_ = false;
    scheduler_.run_apart(std::min(scheduler_.threads(), waiting_.size()),
                         [&](std::size_t) { serve(work); });
  }
}

void WorkQueue::serve(const Work& work) {
  while (const std::optional<std::size_t> n = take()) {
    MemoryShare share(*this, works_[*n].memory_bytes);
    try {
      work(*n, share);
    } catch (const TooLittleMemory& needed) {
      put_back(*n, needed.bytes);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      waiting_.clear();
      throw;
    }
  }
}

std::optional<std::size_t> WorkQueue::take() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty() || ends_round_ || interrupted()) return std::nullopt;
  const auto fits = [&](std::size_t n) {
    std::uint64_t& bytes = works_[n].memory_bytes;
    bytes = std::min(bytes, memory_);
    return bytes <= memory_ - held_;
  };
  const auto place = std::find_if(waiting_.begin(), waiting_.end(), fits);
  if (place == waiting_.end()) {
    ends_round_ = true;
    return std::nullopt;
  }
  const std::size_t n = *place;
  waiting_.erase(place);
  held_ += works_[n].memory_bytes;
  return n;
}

void WorkQueue::put_back(std::size_t n, std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  works_[n].memory_bytes = bytes;
  waiting_.push_front(n);
}

}  // namespace geolloyd

#include "parallel/threads/scheduler.h"

#include <atomic>
#include <exception>
#include <latch>
#include <thread>

#include "parallel/threads/available_cores.h"

namespace geolloyd {
namespace {

// The hand-over between threads is made by these atomics too, and not only inside the threading
// library, so that ThreadSanitizer, which cannot see into that, knows of it.
struct Job {
  const std::function<void(std::size_t)>& work;
  std::atomic<bool> open{false};
  std::atomic<std::size_t> done{0};
  std::atomic<bool> has_failed{false};
  std::exception_ptr error{};  // the first
};

void enter(void* context, std::size_t worker) {
  Job& job = *static_cast<Job*>(context);
  if (!job.open.load(std::memory_order_acquire)) return;  // never: opened before any thread enters
  try {
    job.work(worker);
  } catch (...) {
    if (!job.has_failed.exchange(true)) job.error = std::current_exception();
  }
  job.done.fetch_add(1, std::memory_order_release);
}

// A job whose end may be long in coming: it is waited for without being looked at all the time.
struct LongJob {
  Job job;
  std::latch ended;
};

void enter_long(void* context, std::size_t worker) {
  LongJob& long_job = *static_cast<LongJob*>(context);
  enter(&long_job.job, worker);
  long_job.ended.count_down();
}

std::size_t resolve(std::size_t threads) {
  return threads != 0 ? threads : available_cores();
}

}  // namespace

Scheduler::Scheduler(std::size_t threads, Backend backend)
    : Executor(resolve(threads)), backend_(backend) {
  if (backend == Backend::tbb && this->threads() > 1) tbb_ = make_tbb_pool(this->threads());
}

void Scheduler::run(std::size_t workers, const std::function<void(std::size_t)>& work) {
  if (workers == 1) {
    work(0);
    return;
  }
  Job job{work};
  job.open.store(true, std::memory_order_release);
  if (backend_ == Backend::tbb) {
    run_on_tbb(*tbb_, workers, enter, &job);
  } else {
    run_on_openmp(threads(), workers, enter, &job);
  }
  while (job.done.load(std::memory_order_acquire) != workers) std::this_thread::yield();
  if (job.error) std::rethrow_exception(job.error);
}

void Scheduler::run_apart(std::size_t workers, const std::function<void(std::size_t)>& work) {
  if (workers == 1 || backend_ == Backend::openmp) {
    run(workers, work);
    return;
  }
  LongJob long_job{Job{work}, std::latch(static_cast<std::ptrdiff_t>(workers))};
  long_job.job.open.store(true, std::memory_order_release);
  begin_on_tbb(workers, enter_long, &long_job);
  long_job.ended.wait();
  if (long_job.job.error) std::rethrow_exception(long_job.job.error);
}

std::vector<std::size_t> thread_ladder() {
  const std::size_t all = resolve(0);
  std::vector<std::size_t> ladder;
  for (std::size_t threads = 1; threads < all; threads *= 2) ladder.push_back(threads);
  ladder.push_back(all);
  return ladder;
}

}  // namespace geolloyd

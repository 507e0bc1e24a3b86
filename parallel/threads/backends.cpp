#include "parallel/threads/backends.h"

#include <omp.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <mutex>

namespace geolloyd {

struct TbbPool {
  tbb::task_arena arena;
};

namespace {

// oneTBB starts no more threads than the machine has cores unless told so, and of several such
// wishes heeds the smallest. So there is one at a time, the largest so far.
void allow_threads(std::size_t threads) {
  static std::mutex mutex;
  static auto allowed = static_cast<std::size_t>(tbb::info::default_concurrency());
  static std::unique_ptr<tbb::global_control> limit;
  const std::lock_guard lock(mutex);
  if (threads <= allowed) return;
  limit.reset();
  limit =
      std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
  allowed = threads;
}

}  // namespace

TbbPoolPointer make_tbb_pool(std::size_t threads) {
  allow_threads(threads);
  return TbbPoolPointer(new TbbPool{tbb::task_arena(static_cast<int>(threads))});
}

void TbbPoolDeleter::operator()(TbbPool* pool) const {
  delete pool;
}

void run_on_tbb(TbbPool& pool, std::size_t workers, Enter enter, void* context) {
  pool.arena.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, workers, [&](std::size_t i) { enter(context, i); },
        tbb::simple_partitioner());
  });
}

// Each pool's arena keeps a place for a thread that comes from outside. In this one that would be
// the calling thread, which could join no other arena when there is nothing left to do here. So it
// has no place, and there is one thread more.
void begin_on_tbb(std::size_t workers, Enter enter, void* context) {
  allow_threads(workers + 1);
  tbb::task_arena arena(static_cast<int>(workers), 0, tbb::task_arena::priority::high);
  for (std::size_t i = 0; i < workers; ++i) {
    arena.enqueue([=] { enter(context, i); });
  }
}

// Always with all threads: a team that changes its size is made anew. The caller is thread 0.
void run_on_openmp(std::size_t threads, std::size_t workers, Enter enter, void* context) {
#pragma omp parallel num_threads(static_cast <int>(threads))
  {
    if (omp_get_thread_num() == 0) enter(context, 0);
#pragma omp for schedule(dynamic, 1) nowait
    for (std::size_t i = 1; i < workers; ++i) enter(context, i);
  }
}

}  // namespace geolloyd

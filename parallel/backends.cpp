#include "parallel/backends.h"

#include <omp.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace geolloyd {

// oneTBB starts no more threads than the machine has cores unless told so.
struct TbbPool {
  tbb::global_control limit;
  tbb::task_arena arena;
};

TbbPoolPointer make_tbb_pool(std::size_t threads) {
  const auto cores = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  return TbbPoolPointer(
      new TbbPool{{tbb::global_control::max_allowed_parallelism, std::max(threads, cores)},
                  tbb::task_arena(static_cast<int>(threads))});
}

void TbbPoolDeleter::operator()(TbbPool* pool) const {
  delete pool;
}

void run_on_tbb(TbbPool& pool, std::size_t threads, Enter enter, void* context) {
  pool.arena.execute([&] {
    tbb::parallel_for(
        std::size_t{0}, threads, [&](std::size_t i) { enter(context, i); },
        tbb::simple_partitioner());
  });
}

void run_on_openmp(std::size_t threads, Enter enter, void* context) {
#pragma omp parallel for num_threads(static_cast <int>(threads)) schedule(dynamic, 1)
  for (std::size_t i = 0; i < threads; ++i) enter(context, i);
}

}  // namespace geolloyd

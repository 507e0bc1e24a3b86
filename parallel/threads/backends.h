#pragma once

#include <cstddef>
#include <memory>

namespace geolloyd {

/// The two threading libraries, each behind one function that calls `enter(context, i)` once for
/// each i < workers. Only backends.cpp includes them; it is the one file compiled without
/// ThreadSanitizer, whose false alarms come from their templates, compiled here, handing over to
/// their uninstrumented libraries. The hand-over that counts is made by scheduler.cpp.
using Enter = void (*)(void* context, std::size_t i);

struct TbbPool;
struct TbbPoolDeleter {
  void operator()(TbbPool* pool) const;
};
using TbbPoolPointer = std::unique_ptr<TbbPool, TbbPoolDeleter>;
TbbPoolPointer make_tbb_pool(std::size_t threads);

void run_on_tbb(TbbPool& pool, std::size_t workers, Enter enter, void* context);
void run_on_openmp(std::size_t threads, std::size_t workers, Enter enter, void* context);

/// Begins what run_on_tbb does and returns at once; the calling thread takes no part. `enter` may
/// run loops in other pools, and a thread that has nothing left to do here joins those.
void begin_on_tbb(std::size_t workers, Enter enter, void* context);

}  // namespace geolloyd

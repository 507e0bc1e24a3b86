#include "core/large_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <memory>
#endif

namespace geolloyd {

#ifdef __linux__
void prefer_large_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t worthwhile = 1 << 22;
  if (bytes < worthwhile) return;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::size_t space = bytes;
  if (std::align(page, page, memory, space) == nullptr) return;
  (void)madvise(memory, space / page * page, MADV_HUGEPAGE);  // a wish: refusal does no harm
}
#else
void prefer_large_pages(void* /*memory*/, std::size_t /*bytes*/) {}
#endif

}  // namespace geolloyd

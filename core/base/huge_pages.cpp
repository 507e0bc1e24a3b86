#include "core/base/huge_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace geolloyd {

// Only whole pages inside may be spoken of. The advice may be refused: nothing depends on it.
void prefer_huge_pages(void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t least = std::size_t{2} << 20;
  constexpr std::uintptr_t page = std::uintptr_t{1} << 16;  // a multiple of the small page anywhere
  if (bytes < least) return;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::size_t before = (page - address % page) % page;
  const std::size_t whole = (bytes - before) / page * page;
  static_cast<void>(madvise(static_cast<std::byte*>(memory) + before, whole, MADV_HUGEPAGE));
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

}  // namespace geolloyd

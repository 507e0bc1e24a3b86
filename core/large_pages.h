#pragma once

#include <cstddef>
#include <vector>

namespace geolloyd {

/// Asks the system to back memory not yet written to by large pages where it knows of them: the
/// first write to a page costs as much as hundreds to it later, and it is the number of pages that
/// counts.
void prefer_large_pages(void* memory, std::size_t bytes);

/// vector.resize(size), for an empty one that may become large.
template <class T>
void resize_large(std::vector<T>& vector, std::size_t size) {
  vector.reserve(size);
  prefer_large_pages(vector.data(), size * sizeof(T));
  vector.resize(size);
}

}  // namespace geolloyd

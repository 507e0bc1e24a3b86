#pragma once

#include <cstddef>
#include <vector>

namespace geolloyd {

/// Says of memory that is about to be written for the first time that huge pages suit it: the
/// system then hands it out, and finds it, by 2 MB instead of 4 KB. Does nothing for small memory,
/// or where the system has no such pages.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// Reserves room for `size` elements, if there is not enough, where huge pages suit.
template <class T>
void reserve_huge(std::vector<T>& values, std::size_t size) {
  if (values.capacity() >= size) return;
  values.reserve(size);
  prefer_huge_pages(values.data(), values.capacity() * sizeof(T));
}

/// A vector of `size` zeros, or of copies of `value`.
template <class T>
std::vector<T> huge_vector(std::size_t size, const T& value = T{}) {
  std::vector<T> values;
  reserve_huge(values, size);
  values.resize(size, value);
  return values;
}

}  // namespace geolloyd

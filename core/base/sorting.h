#pragma once

#include <algorithm>
#include <vector>

namespace geolloyd {

/// Leaves each value once, ascending.
template <class T>
void sort_and_deduplicate(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace geolloyd

#pragma once

#include <algorithm>
#include <array>

namespace geolloyd {

/// Wall time by kernel, seconds.
struct KernelSeconds {
  double free_search = 0;    ///< keys and parents, regions free
  double locked_search = 0;  ///< keys and parents, regions locked
  double subtree_sums = 0;
  double scoring = 0;  ///< in engines that find digests of nodes with the scores, those too
  double movement = 0;
  double gathering = 0;  ///< which nodes are a region's; copying regions out and back
  double other = 0;
};

/// To do something for each of them.
inline constexpr std::array kernels = {
    &KernelSeconds::free_search, &KernelSeconds::locked_search, &KernelSeconds::subtree_sums,
    &KernelSeconds::scoring,     &KernelSeconds::movement,      &KernelSeconds::gathering,
    &KernelSeconds::other,
};

inline double total(const KernelSeconds& seconds) {
  double sum = 0;
  for (const auto kernel : kernels) sum += seconds.*kernel;
  return sum;
}

/// What was added since `before`, and as `other` what is missing to `elapsed`.
inline KernelSeconds since(const KernelSeconds& before, KernelSeconds now, double elapsed) {
  for (const auto kernel : kernels) now.*kernel -= before.*kernel;
  now.other += elapsed - total(now);
  if (now.other > -1e-9) now.other = std::max(now.other, 0.0);  // rounding
  return now;
}

inline KernelSeconds& operator+=(KernelSeconds& sum, const KernelSeconds& more) {
  for (const auto kernel : kernels) sum.*kernel += more.*kernel;
  return sum;
}

/// Adds `elapsed` wall time to `sum`, by the shares that kernels running side by side had in the
/// time of all threads together.
inline void share_out(double elapsed, const KernelSeconds& of_threads, KernelSeconds& sum) {
  const double all = total(of_threads);
  if (all == 0) return;
  for (const auto kernel : kernels) sum.*kernel += elapsed * (of_threads.*kernel / all);
}

}  // namespace geolloyd

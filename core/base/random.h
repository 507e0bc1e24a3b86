#pragma once

#include <cstdint>

#include "core/base/types.h"

namespace geolloyd {

/// Mixes all bits of `x` into all bits of the result; a bijection (finaliser of SplitMix64, Steele
/// et al. 2014).
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The n-th number of the sequence `random_seed`: a hash, not a state, so that any order of asking,
/// on any thread, gets the same numbers.
constexpr std::uint64_t random_bits(std::uint64_t random_seed, std::uint64_t n) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  return mix_bits(mix_bits(random_seed + golden) + (n + 1) * golden);
}

/// Uniform in [0, 1), a multiple of 2^-53.
constexpr double random_unit(std::uint64_t random_seed, std::uint64_t n) {
  return static_cast<double>(random_bits(random_seed, n) >> 11) * 0x1p-53;
}

/// Uniform in [0, bound), `bound` > 0. Draws numbers 2n and 2n+1 of the sequence.
constexpr Uint128 random_below(std::uint64_t random_seed, std::uint64_t n, Uint128 bound) {
  const Uint128 high = random_bits(random_seed, 2 * n);
  return ((high << 64) | random_bits(random_seed, 2 * n + 1)) % bound;
}

}  // namespace geolloyd

#include "core/fingerprint.h"

#include "core/random.h"

namespace geolloyd {
namespace {

// Odd, from the golden ratio: keeps equal contents at different places apart.
constexpr std::uint64_t stride = 0x9e3779b97f4a7c15u;

std::uint64_t at_place(std::uint64_t place, std::uint64_t content) {
  return mix_bits(content + (place + 1) * stride);
}

}  // namespace

std::uint64_t digest(std::span<const NodeId> seeds) {
  std::uint64_t sum = 0;
  for (std::size_t r = 0; r < seeds.size(); ++r) sum += at_place(r, seeds[r]);
  return mix_bits(sum);
}

std::uint64_t digest(std::span<const NodeId> seeds, const Partition& partition) {
  std::uint64_t sum = digest(seeds);
  for (std::size_t v = 0; v < partition.key.size(); ++v) {
    sum += mix_bits(at_place(v, partition.key[v]) ^ partition.parent[v]);
  }
  return mix_bits(sum);
}

std::uint64_t chain(std::uint64_t fingerprint, std::uint64_t next_digest) {
  return mix_bits(fingerprint * stride + next_digest);
}

}  // namespace geolloyd

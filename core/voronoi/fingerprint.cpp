#include "core/voronoi/fingerprint.h"

#include <bit>

namespace geolloyd {

using fingerprint_detail::at_place;
using fingerprint_detail::stride;

std::uint64_t digest(std::span<const NodeId> seeds) {
  std::uint64_t sum = 0;
  for (std::size_t r = 0; r < seeds.size(); ++r) sum += at_place(r, seeds[r]);
  return mix_bits(sum);
}

std::uint64_t digest(std::span<const NodeId> seeds, const Partition& partition) {
  std::uint64_t sum = 0;
  for (NodeId v = 0; v < partition.key.size(); ++v) {
    sum += digest(v, partition.key[v], partition.parent[v]);
  }
  return digest(seeds, sum);
}

std::uint64_t digest(std::span<const NodeId> seeds, std::uint64_t sum_of_nodes) {
  return mix_bits(digest(seeds) + sum_of_nodes);
}

std::uint64_t digest(const Graph& graph) {
  std::uint64_t all = 0;
  for (const auto* numbers : {&graph.first_arc, &graph.target, &graph.length, &graph.mass}) {
    all = chain(all, digest(*numbers));
  }
  for (const double tick : {graph.tick_length, graph.tick_mass}) {
    all = chain(all, std::bit_cast<std::uint64_t>(tick));
  }
  return all;
}

std::uint64_t chain(std::uint64_t fingerprint, std::uint64_t next_digest) {
  return mix_bits(fingerprint * stride + next_digest);
}

}  // namespace geolloyd

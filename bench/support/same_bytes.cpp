#include "bench/support/same_bytes.h"

#include <array>

namespace geolloyd {

bool same_bytes(const MeshEdges& a, const MeshEdges& b) {
  return same_bytes(a.ends, b.ends) && same_bytes(a.first_corner, b.first_corner) &&
         same_bytes(a.corner, b.corner) && same_bytes(a.duplicates, b.duplicates);
}

// All of its members are words, so there are no others between them.
bool same_bytes(const MeshFacts& a, const MeshFacts& b) {
  using Words = std::array<std::uint64_t, sizeof(MeshFacts) / sizeof(std::uint64_t)>;
  return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

bool same_bytes(const Graph& a, const Graph& b) {
  return same_bytes(a.first_arc, b.first_arc) && same_bytes(a.target, b.target) &&
         same_bytes(a.length, b.length) && same_bytes(a.mass, b.mass) &&
         same_bytes(a.tick_length, b.tick_length) && same_bytes(a.tick_mass, b.tick_mass);
}

bool same_bytes(const MeshGraph& a, const MeshGraph& b) {
  return a.kind == b.kind && a.first_triangle_id == b.first_triangle_id &&
         same_bytes(a.input_id, b.input_id) && same_bytes(a.node_of, b.node_of) &&
         same_bytes(a.position, b.position) && same_bytes(a.graph, b.graph);
}

}  // namespace geolloyd

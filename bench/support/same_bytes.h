#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh_check.h"

namespace geolloyd {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
inline bool same_bytes(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bytes(const MeshEdges& a, const MeshEdges& b);
bool same_bytes(const MeshFacts& a, const MeshFacts& b);
bool same_bytes(const Graph& a, const Graph& b);
bool same_bytes(const MeshGraph& a, const MeshGraph& b);

}  // namespace geolloyd

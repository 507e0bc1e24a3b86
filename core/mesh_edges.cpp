#include "core/mesh_edges.h"

#include <algorithm>
#include <utility>

namespace geolloyd {
namespace {

// One entry per edge of each triangle, in the bucket of the edge's smaller vertex. The larger
// vertex in the high half, so that sorting a bucket brings equal edges together, corners ascending.
struct Buckets {
  std::vector<std::uint32_t> first;
  std::vector<std::uint64_t> entry;
};

// The ends of the edge opposite to a corner, the smaller first.
std::pair<VertexId, VertexId> sorted_ends(const Mesh& mesh, CornerId corner) {
  return std::minmax({edge_start(mesh, corner), edge_end(mesh, corner)});
}

// A vertex has some six edges: insertion beats a library sort by the cost of its call.
void sort_bucket(std::span<std::uint64_t> bucket) {
  constexpr std::size_t few = 32;
  if (bucket.size() > few) {
    std::sort(bucket.begin(), bucket.end());
    return;
  }
  for (std::size_t i = 1; i < bucket.size(); ++i) {
    const std::uint64_t entry = bucket[i];
    std::size_t slot = i;
    for (; slot > 0 && bucket[slot - 1] > entry; --slot) bucket[slot] = bucket[slot - 1];
    bucket[slot] = entry;
  }
}

Buckets sort_corners(const Mesh& mesh) {
  Buckets buckets;
  buckets.first.assign(mesh.vertex_count() + 1, 0);
  for_each_corner(mesh,
                  [&](CornerId corner) { ++buckets.first[sorted_ends(mesh, corner).first + 1]; });
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) buckets.first[v + 1] += buckets.first[v];

  buckets.entry.resize(buckets.first.back());
  std::vector<std::uint32_t> next(buckets.first.begin(), buckets.first.end() - 1);
  for_each_corner(mesh, [&](CornerId corner) {
    const auto [low, high] = sorted_ends(mesh, corner);
    buckets.entry[next[low]++] = (std::uint64_t{high} << 32) | corner;
  });
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    sort_bucket(
        {buckets.entry.data() + buckets.first[v], buckets.entry.data() + buckets.first[v + 1]});
  }
  return buckets;
}

}  // namespace

MeshEdges find_edges(const Mesh& mesh) {
  const Buckets buckets = sort_corners(mesh);
  MeshEdges edges;
  edges.corner.resize(buckets.entry.size());
  edges.ends.reserve(buckets.entry.size() / 2 + 1);
  edges.first_corner.reserve(buckets.entry.size() / 2 + 2);
  for (VertexId low = 0; low < mesh.vertex_count(); ++low) {
    VertexId previous = no_id;
    for (std::uint32_t i = buckets.first[low]; i < buckets.first[low + 1]; ++i) {
      const auto high = static_cast<VertexId>(buckets.entry[i] >> 32);
      if (high != previous) {
        edges.ends.push_back({low, high});
        edges.first_corner.push_back(i);
        previous = high;
      }
      edges.corner[i] = static_cast<CornerId>(buckets.entry[i]);
    }
  }
  edges.first_corner.push_back(static_cast<std::uint32_t>(edges.corner.size()));
  return edges;
}

}  // namespace geolloyd

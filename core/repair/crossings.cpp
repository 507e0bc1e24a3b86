#include "core/repair/crossings.h"

#include <algorithm>

#include "core/mesh/box_tree.h"
#include "core/mesh/mesh_quality.h"
#include "core/repair/crossing_triangles.h"
#include "core/repair/plain_stars.h"

namespace geolloyd {
namespace {

// Of one triangle, with those after it in the tree. Many in one place would have too many.
constexpr std::uint8_t most_pairs = 100;

bool are_in_plain_star(const Triangle& one, const Triangle& other,
                       const std::vector<std::uint8_t>& is_plain) {
  return std::any_of(one.begin(), one.end(), [&](VertexId v) {
    return (v == other[0] || v == other[1] || v == other[2]) && is_plain[v] != 0;
  });
}

}  // namespace

std::vector<TrianglePair> find_crossings(const Mesh& mesh, Executor& executor) {
  const auto corners = [&](TriangleId t) { return corners_of(mesh, mesh.triangles[t]); };
  const BoxTree tree(
      mesh.triangle_count(),
      [&](std::size_t t) { return box_around(corners(static_cast<TriangleId>(t))); }, executor);
  const std::vector<std::uint8_t> is_plain = find_plain_stars(mesh, executor);
  std::vector<std::vector<TrianglePair>> of_worker(executor.threads());
  std::vector<std::uint8_t> count(mesh.triangle_count(), 0);
  tree.for_each_pair(executor, [&](TriangleId one, TriangleId other, std::size_t worker) {
    if (are_in_plain_star(mesh.triangles[one], mesh.triangles[other], is_plain)) return true;
    if (!do_cross(corners(one), corners(other))) return true;
    of_worker[worker].push_back({std::min(one, other), std::max(one, other)});
    return ++count[one] < most_pairs;
  });
  std::vector<TrianglePair> found;
  for (const auto& pairs : of_worker) found.insert(found.end(), pairs.begin(), pairs.end());
  std::sort(found.begin(), found.end());
  return found;
}

void mark_corners(const Mesh& mesh, std::span<const TrianglePair> pairs,
                  std::vector<std::uint8_t>& marked) {
  for (const TrianglePair& pair : pairs) {
    for (const TriangleId t : pair) {
      for (const VertexId v : mesh.triangles[t]) marked[v] = 1;
    }
  }
}

}  // namespace geolloyd

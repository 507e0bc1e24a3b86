#include "core/repair/crossings.h"

#include <algorithm>

#include "core/base/box_tree.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_quality.h"
#include "core/repair/crossing_triangles.h"

namespace geolloyd {
namespace {

bool are_crossing(const Mesh& mesh, TriangleId one, TriangleId other) {
  const Triangle& s = mesh.triangles[one];
  const Triangle& t = mesh.triangles[other];
  return std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) == s.end() &&
         do_cross(corners_of(mesh, s), corners_of(mesh, t));
}

}  // namespace

std::vector<TrianglePair> find_crossings(const Mesh& mesh, Executor& executor) {
  constexpr std::size_t some_triangles = 256;
  std::vector<GrowingBox> boxes(mesh.triangle_count());
  for (TriangleId t = 0; t < boxes.size(); ++t) {
    for (const Vec3& p : corners_of(mesh, mesh.triangles[t])) boxes[t].add(p);
  }
  const BoxTree tree(boxes);
  std::vector<std::vector<TrianglePair>> of_worker(executor.threads());
  parallel_for_ranges(executor, boxes.size(), some_triangles,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        for (auto t = static_cast<TriangleId>(begin); t < end; ++t) {
                          tree.any(boxes[t], [&](std::uint32_t other) {
                            if (other < t && are_crossing(mesh, other, t))
                              of_worker[worker].push_back({other, t});
                            return false;  // and on to all others
                          });
                        }
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

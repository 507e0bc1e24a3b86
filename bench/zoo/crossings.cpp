#include "bench/zoo/crossings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/box_tree.h"
#include "core/repair/crossing_triangles.h"

namespace geolloyd::zoo {
namespace {

std::array<Vec3, 3> corners_in(const Mesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

bool go_through_each_other(const Mesh& mesh, TriangleId one, TriangleId other) {
  const Triangle& s = mesh.triangles[one];
  const Triangle& t = mesh.triangles[other];
  return std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) == s.end() &&
         do_cross(corners_in(mesh, one), corners_in(mesh, other));
}

}  // namespace

std::size_t count_crossings(const Mesh& mesh) {
  std::vector<GrowingBox> boxes(mesh.triangle_count());
  for (TriangleId t = 0; t < boxes.size(); ++t) {
    for (const Vec3& p : corners_in(mesh, t)) boxes[t].add(p);
  }
  const BoxTree tree(boxes);
  std::size_t found = 0;
  for (TriangleId t = 0; t < boxes.size(); ++t) {
    tree.any(boxes[t], [&](std::uint32_t other) {
      found += other < t && go_through_each_other(mesh, other, t) ? 1 : 0;
      return false;  // and on to all others
    });
  }
  return found;
}

}  // namespace geolloyd::zoo

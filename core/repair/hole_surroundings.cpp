#include "core/repair/hole_surroundings.h"

#include <algorithm>
#include <utility>

#include "core/mesh/mesh_quality.h"
#include "core/repair/crossing_triangles.h"

namespace geolloyd {
namespace {

using Corners = HoleSurroundings::Corners;

std::vector<TriangleId> triangles_in(const Mesh& mesh, const BoxTree& boxes) {
  std::vector<TriangleId> found;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (boxes.any(box_around(corners_of(mesh, mesh.triangles[t])),
                  [](std::uint32_t) { return true; })) {
      found.push_back(t);
    }
  }
  return found;
}

BoxTree tree_of(const std::vector<GrowingBox>& boxes) {
  return {boxes.size(), [&](std::size_t i) { return boxes[i]; }};
}

}  // namespace

HoleSurroundings::HoleSurroundings(const Mesh& mesh, const std::vector<GrowingBox>& holes)
    : mesh_(mesh),
      holes_(tree_of(holes)),
      near_(triangles_in(mesh, holes_)),
      surface_(
          near_.size(),
          [&](std::size_t i) { return box_around(corners_of(mesh, mesh.triangles[near_[i]])); }),
      filling_(holes.size()) {}

bool HoleSurroundings::is_in_the_way_of(const Corners& triangle) const {
  const GrowingBox box = box_around(triangle);
  const auto crosses = [&](const Corners& other) { return do_cross(triangle, other); };
  return surface_.any(box, [&](std::uint32_t i) {
    return crosses(corners_of(mesh_, mesh_.triangles[near_[i]]));
  }) || holes_.any(box, [&](std::uint32_t hole) {
    return std::any_of(filling_[hole].begin(), filling_[hole].end(), crosses);
  });
}

bool HoleSurroundings::is_in_the_way_of(std::span<const Corners> filling) const {
  if (std::any_of(filling.begin(), filling.end(),
                  [&](const Corners& triangle) { return is_in_the_way_of(triangle); })) {
    return true;
  }
  const BoxTree own(filling.size(), [&](std::size_t i) { return box_around(filling[i]); });
  bool crosses = false;
  own.for_each_pair(sequential(), [&](std::uint32_t i, std::uint32_t k, std::size_t) {
    crosses = crosses || do_cross(filling[i], filling[k]);
    return !crosses;
  });
  return crosses;
}

void HoleSurroundings::add(std::size_t hole, std::vector<Corners> filling) {
  filling_[hole] = std::move(filling);
}

}  // namespace geolloyd

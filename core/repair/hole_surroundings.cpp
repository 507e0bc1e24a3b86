#include "core/repair/hole_surroundings.h"

#include <algorithm>
#include <utility>

#include "core/mesh/mesh_quality.h"
#include "core/repair/crossing_triangles.h"

namespace geolloyd {
namespace {

using Corners = HoleSurroundings::Corners;

GrowingBox box_of(const Corners& triangle) {
  GrowingBox box;
  for (const Vec3& corner : triangle) box.add(corner);
  return box;
}

std::vector<TriangleId> triangles_in(const Mesh& mesh, const BoxTree& boxes) {
  std::vector<TriangleId> found;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (boxes.any(box_of(corners_of(mesh, mesh.triangles[t])),
                  [](std::uint32_t) { return true; })) {
      found.push_back(t);
    }
  }
  return found;
}

std::vector<GrowingBox> boxes_of(const Mesh& mesh, std::span<const TriangleId> triangles) {
  std::vector<GrowingBox> boxes;
  boxes.reserve(triangles.size());
  for (const TriangleId t : triangles) boxes.push_back(box_of(corners_of(mesh, mesh.triangles[t])));
  return boxes;
}

}  // namespace

HoleSurroundings::HoleSurroundings(const Mesh& mesh, const std::vector<GrowingBox>& holes)
    : mesh_(mesh),
      holes_(holes),
      near_(triangles_in(mesh, holes_)),
      surface_(boxes_of(mesh, near_)),
      filling_(holes.size()) {}

bool HoleSurroundings::is_in_the_way_of(const Corners& triangle) const {
  const GrowingBox box = box_of(triangle);
  const auto crosses = [&](const Corners& other) { return do_cross(triangle, other); };
  return surface_.any(box, [&](std::uint32_t i) {
    return crosses(corners_of(mesh_, mesh_.triangles[near_[i]]));
  }) || holes_.any(box, [&](std::uint32_t hole) {
    return std::any_of(filling_[hole].begin(), filling_[hole].end(), [&](const Corners& other) {
      return overlap(box_of(other), box) && crosses(other);
    });
  });
}

bool HoleSurroundings::is_in_the_way_of(std::span<const Corners> filling) const {
  std::vector<GrowingBox> boxes;
  boxes.reserve(filling.size());
  for (const Corners& triangle : filling) {
    if (is_in_the_way_of(triangle)) return true;
    boxes.push_back(box_of(triangle));
  }
  const BoxTree own(boxes);
  for (std::uint32_t i = 0; i < filling.size(); ++i) {
    const bool crosses = own.any(
        boxes[i], [&](std::uint32_t k) { return k < i && do_cross(filling[i], filling[k]); });
    if (crosses) return true;
  }
  return false;
}

void HoleSurroundings::add(std::size_t hole, std::vector<Corners> filling) {
  filling_[hole] = std::move(filling);
}

}  // namespace geolloyd

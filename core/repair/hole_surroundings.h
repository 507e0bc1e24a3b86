#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

namespace geolloyd {

/// What is about the holes of a mesh: its triangles there, and those that fill holes already.
class HoleSurroundings {
 public:
  using Corners = std::array<Vec3, 3>;

  /// `holes`: a box of each hole. The mesh must live on.
  HoleSurroundings(const Mesh& mesh, const std::vector<GrowingBox>& holes);

  /// Whether a triangle in the box of a hole would pass through what is there.
  [[nodiscard]] bool is_in_the_way_of(const Corners& triangle) const;
  /// Whether a filling would, or would pass through itself.
  [[nodiscard]] bool is_in_the_way_of(std::span<const Corners> filling) const;

  void add(std::size_t hole, std::vector<Corners> filling);

 private:
  const Mesh& mesh_;
  BoxTree holes_;
  std::vector<TriangleId> near_;               // triangles of the mesh in boxes of holes
  BoxTree surface_;                            // of these
  std::vector<std::vector<Corners>> filling_;  // per hole
};

}  // namespace geolloyd

#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// Where a ray first meets a mesh.
struct RayHit {
  TriangleId triangle = no_id;  ///< no_id: nowhere
  float u = 0;                  ///< weight of the triangle's second corner
  float v = 0;                  ///< weight of its third
  float z = 0;
};

/// First hits of rays along z with a mesh that lies at z > 0 (Embree).
class RayCaster {
 public:
  static constexpr std::size_t packet = 16;  ///< rays at a time; fastest where these are near

  /// `threads` put the triangles in order.
  RayCaster(const Mesh& mesh, std::size_t threads);
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;
  ~RayCaster();

  [[nodiscard]] std::array<RayHit, packet> cast(const std::array<float, packet>& x,
                                                const std::array<float, packet>& y) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace geolloyd

#pragma once

#include <memory>
#include <optional>

#include "core/mesh.h"

namespace geolloyd {

/// Where a ray meets a mesh.
struct RayHit {
  TriangleId triangle;
  double u;  ///< weight of the triangle's second corner
  double v;  ///< weight of its third
};

/// First hits of rays with a mesh (Embree).
class RayCaster {
 public:
  explicit RayCaster(const Mesh& mesh);
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;
  ~RayCaster();

  [[nodiscard]] std::optional<RayHit> cast(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace geolloyd

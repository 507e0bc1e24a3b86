#include "tools/ray_caster.h"

#include <limits>

#include "tools/embree_scene.h"

namespace geolloyd {

struct RayCaster::Scene : EmbreeScene {
  void intersect(RTCRayHit& ray) const {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
  }
};

RayCaster::RayCaster(const Mesh& mesh) : scene_(std::make_unique<Scene>()) {
  scene_->commit(scene_->triangles(mesh));
}

RayCaster::~RayCaster() = default;

std::optional<RayHit> RayCaster::cast(const Vec3& origin, const Vec3& direction) const {
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(origin.x());
  ray.ray.org_y = static_cast<float>(origin.y());
  ray.ray.org_z = static_cast<float>(origin.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = std::numeric_limits<unsigned>::max();
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  scene_->intersect(ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{ray.hit.primID, ray.hit.u, ray.hit.v};
}

}  // namespace geolloyd

#include "tools/render/ray_caster.h"

#include <algorithm>
#include <limits>

#include "tools/evaluation/distances/embree_scene.h"

namespace geolloyd {
namespace {

constexpr auto all_valid = [] {
  std::array<int, RayCaster::packet> valid{};
  valid.fill(-1);
  return valid;
}();

}  // namespace

struct RayCaster::Scene : EmbreeScene {
  using EmbreeScene::EmbreeScene;

  void intersect(RTCRayHit16& rays) const {
    alignas(64) const auto valid = all_valid;
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments{};
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(valid.data(), scene, &rays, &arguments);
#else
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid.data(), scene, &context, &rays);
#endif
  }
};

RayCaster::RayCaster(const Mesh& mesh, std::size_t threads)
    : scene_(std::make_unique<Scene>(threads)) {
  scene_->commit(scene_->triangles(mesh));
}

RayCaster::~RayCaster() = default;

std::array<RayHit, RayCaster::packet> RayCaster::cast(const std::array<float, packet>& x,
                                                      const std::array<float, packet>& y) const {
  RTCRayHit16 rays{};
  std::copy(x.begin(), x.end(), rays.ray.org_x);
  std::copy(y.begin(), y.end(), rays.ray.org_y);
  std::fill_n(rays.ray.dir_z, packet, 1.0F);
  std::fill_n(rays.ray.tfar, packet, std::numeric_limits<float>::infinity());
  std::fill_n(rays.ray.mask, packet, std::numeric_limits<unsigned>::max());
  std::fill_n(rays.hit.geomID, packet, RTC_INVALID_GEOMETRY_ID);
  scene_->intersect(rays);
  std::array<RayHit, packet> hits;
  for (std::size_t i = 0; i < packet; ++i) {
    if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[i] = {rays.hit.primID[i], rays.hit.u[i], rays.hit.v[i], rays.ray.tfar[i]};
  }
  return hits;
}

}  // namespace geolloyd

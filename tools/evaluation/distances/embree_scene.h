#pragma once

// Debian 12 has Embree 3, newer distributions Embree 4. This file, ray_caster.cpp and
// point_queries.cpp are all that knows Embree.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstdint>
#include <new>
#include <string>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// An Embree device with one scene; geometry has 24 bits only (unit_frame.h).
struct EmbreeScene {
  RTCDevice device;
  RTCScene scene;

  /// `threads` make the scene.
  explicit EmbreeScene(std::size_t threads)
      : device(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
        scene(rtcNewScene(device)) {}
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  template <class T>
  static T* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                       std::size_t count) {
    void* const memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(T), count);
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }

  /// The triangles of a mesh, as geometry that has not been committed.
  [[nodiscard]] RTCGeometry triangles(const Mesh& mesh) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* coordinate =
        new_buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertex_count());
    for (const Vec3& p : mesh.positions) {
      for (const double x : p) *coordinate++ = static_cast<float>(x);
    }
    auto* index = new_buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                            mesh.triangle_count());
    for (const Triangle& t : mesh.triangles) index = std::copy(t.begin(), t.end(), index);
    return geometry;
  }

  /// Makes `geometry` the scene's, and the scene ready.
  void commit(RTCGeometry geometry) const {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    // Embree throws nothing: without memory it leaves a scene with nothing in it.
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::bad_alloc();
  }
};

}  // namespace geolloyd

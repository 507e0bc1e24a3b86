#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// The nearest of some sites (Embree), exactly as brute force in double finds it: the least
/// dot(p - site, p - site), the smaller index of equals. find() may be called by many threads.
class NearestSite {
 public:
  /// Keeps a copy of the sites. At least one. `threads` put them in order.
  NearestSite(std::span<const Vec3> sites, std::size_t threads);
  NearestSite(const NearestSite&) = delete;
  NearestSite& operator=(const NearestSite&) = delete;
  ~NearestSite();

  /// `guess`: a site thought to be near. Any will do, a good one is faster.
  [[nodiscard]] std::uint32_t find(const Vec3& p, std::uint32_t guess = 0) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// A point of a mesh's surface, and how far from it the point is that was asked for (mesh units).
struct FoundPoint {
  TriangleId triangle;
  Vec3 position;
  double distance;
};

/// The closest point of a mesh's surface (Embree), as brute force over all triangles in double
/// finds it, the smaller triangle of equals. Triangles without area count as the segments or points
/// that they are. find() may be called by many threads.
class ClosestPoint {
 public:
  /// Keeps a reference to the mesh, whose triangles `threads` put in order. Throws InvalidInput
  /// where it has none.
  ClosestPoint(const Mesh& mesh, std::size_t threads);
  ClosestPoint(const ClosestPoint&) = delete;
  ClosestPoint& operator=(const ClosestPoint&) = delete;
  ~ClosestPoint();

  /// `guess`: a triangle thought to be near, or no_id. Any will do, a good one is faster.
  [[nodiscard]] FoundPoint find(const Vec3& p, TriangleId guess = no_id) const;
  /// Some triangle that is no farther from `p` than this, or no_id. Faster than find(), and says
  /// the same of what is near.
  [[nodiscard]] TriangleId find_within(const Vec3& p, double distance) const;
  /// From `p` to the nearest point of one triangle: never less than find() says.
  [[nodiscard]] double distance_to(const Vec3& p, TriangleId triangle) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace geolloyd

#include "tools/evaluation/distances/point_queries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mesh/closest_on_triangle.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/distances/embree_scene.h"
#include "tools/evaluation/distances/unit_frame.h"

namespace geolloyd {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

float to_float(double x) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -largest, largest));
}

// A radius, in the unit frame, in which Embree finds everything up to `distance` from `q`: more
// than that, because it rounds to 24 bits the geometry, `q`, and the squares of lengths that it
// compares. Where these squares overflow they are equal, and everything is found.
float search_radius(const Vec3& q, double distance) {
  constexpr double slack = 0x1p-22;
  return to_float((distance + slack * (1 + norm(q))) * (1 + 4 * slack));
}

// Calls nearest.visit(primitive) for all primitives within nearest.distance() (in the unit frame)
// of `q`, and may do so for others. `visit` returns whether the distance has become less.
template <class Nearest>
void search(RTCScene scene, const Vec3& q, Nearest& nearest) {
  struct Search {
    const Vec3& q;
    Nearest& nearest;
  } search{q, nearest};
  RTCPointQuery query{};
  query.x = to_float(q.x());
  query.y = to_float(q.y());
  query.z = to_float(q.z());
  query.radius = search_radius(q, nearest.distance());
  RTCPointQueryContext context{};
  rtcInitPointQueryContext(&context);
  const auto visit = [](RTCPointQueryFunctionArguments* found) {
    const auto& [at, best] = *static_cast<Search*>(found->userPtr);
    if (!best.visit(found->primID)) return false;
    found->query->radius = search_radius(at, best.distance());
    return true;
  };
  rtcPointQuery(scene, &query, &context, visit, &search);
}

// Keeps the first of those that are in the very same place, ascending. The others are nearest to
// nothing, and where there are very many of them a search would visit them all.
template <class PlaceOf>
void keep_first_in_place(std::vector<std::uint32_t>& items, const PlaceOf& place_of) {
  const auto key = [&](std::uint32_t i) {
    const Vec3& p = place_of(i);
    return std::tuple(p.x(), p.y(), p.z());
  };
  std::sort(items.begin(), items.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(key(a), a) < std::tuple(key(b), b);
  });
  const auto end = std::unique(items.begin(), items.end(),
                               [&](std::uint32_t a, std::uint32_t b) { return key(a) == key(b); });
  items.erase(end, items.end());
  std::sort(items.begin(), items.end());
}

}  // namespace

struct NearestSite::Scene : EmbreeScene {
  std::vector<Vec3> sites;
  std::vector<std::uint32_t> site_of;  // per primitive
  UnitFrame frame;

  Scene(std::span<const Vec3> all, std::size_t threads)
      : EmbreeScene(threads), sites(all.begin(), all.end()), site_of(all.size()), frame(all) {
    std::iota(site_of.begin(), site_of.end(), 0U);
    keep_first_in_place(site_of, [&](std::uint32_t i) -> const Vec3& { return sites[i]; });
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(site_of.size()));
    rtcSetGeometryBoundsFunction(geometry, find_bounds, this);
    rtcSetGeometryUserData(geometry, this);
    commit(geometry);
  }

  static void find_bounds(const RTCBoundsFunctionArguments* asked) {
    const Scene& scene = *static_cast<const Scene*>(asked->geometryUserPtr);
    const Vec3 q = scene.frame(scene.sites[scene.site_of[asked->primID]]);
    RTCBounds& box = *asked->bounds_o;
    box.lower_x = box.upper_x = to_float(q.x());
    box.lower_y = box.upper_y = to_float(q.y());
    box.lower_z = box.upper_z = to_float(q.z());
  }
};

NearestSite::NearestSite(std::span<const Vec3> sites, std::size_t threads)
    : scene_(std::make_unique<Scene>(sites, threads)) {}

NearestSite::~NearestSite() = default;

std::uint32_t NearestSite::find(const Vec3& p, std::uint32_t guess) const {
  struct Nearest {
    const Scene& scene;
    const Vec3& p;
    double square = infinity;
    std::uint32_t site = no_id;

    bool visit(std::uint32_t primitive) { return offer(scene.site_of[primitive]); }
    bool offer(std::uint32_t i) {
      const Vec3 away = p - scene.sites[i];
      const double offered = dot(away, away);
      if (offered > square || (offered == square && i >= site)) return false;
      square = offered;
      site = i;
      return true;
    }
    // As far as squares this small can differ by underflow alone.
    [[nodiscard]] double distance() const {
      return std::sqrt(square + std::numeric_limits<double>::min()) * scene.frame.scale;
    }
  } nearest{*scene_, p};
  nearest.offer(guess);
  search(scene_->scene, scene_->frame(p), nearest);
  return nearest.site;
}

struct ClosestPoint::Scene : EmbreeScene {
  const Mesh& mesh;
  std::vector<TriangleId> triangle_of;  // per primitive; none: each is its triangle
  UnitFrame frame;

  Scene(const Mesh& whole, std::size_t threads)
      : EmbreeScene(threads), mesh(whole), frame(whole.positions) {
    if (mesh.triangles.empty()) throw InvalidInput("a mesh without triangles has no surface");
    Mesh framed = frame(mesh);
    leave_out_repeated_points(framed);
    commit(triangles(framed));
  }

  // Triangles whose corners are all in one place, where an earlier one is.
  void leave_out_repeated_points(Mesh& framed) {
    const auto is_point = [&](TriangleId t) {
      const auto& [a, b, c] = mesh.triangles[t];
      return mesh.positions[a] == mesh.positions[b] && mesh.positions[b] == mesh.positions[c];
    };
    std::vector<TriangleId> points;
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      if (is_point(t)) points.push_back(t);
    }
    const std::size_t all = points.size();
    keep_first_in_place(
        points, [&](TriangleId t) -> const Vec3& { return mesh.positions[mesh.triangles[t][0]]; });
    if (points.size() == all) return;
    std::vector<Triangle> kept;
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      if (is_point(t) && !std::binary_search(points.begin(), points.end(), t)) continue;
      kept.push_back(framed.triangles[t]);
      triangle_of.push_back(t);
    }
    framed.triangles = std::move(kept);
  }

  [[nodiscard]] TriangleId triangle_at(std::uint32_t primitive) const {
    return triangle_of.empty() ? primitive : triangle_of[primitive];
  }

  [[nodiscard]] Vec3 closest_to(const Vec3& p, TriangleId t) const {
    std::array<Vec3, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.positions[mesh.triangles[t][i]];
    const auto& [a, b, c] = corner;
    const auto [v, w] = barycentric_closest_to_origin(
        {(a - p) * frame.scale, (b - p) * frame.scale, (c - p) * frame.scale});
    return a + v * (b - a) + w * (c - a);
  }

  // In the unit frame.
  [[nodiscard]] double square_distance(const Vec3& p, const Vec3& point) const {
    const Vec3 away = (p - point) * frame.scale;
    return dot(away, away);
  }
};

ClosestPoint::ClosestPoint(const Mesh& mesh, std::size_t threads)
    : scene_(std::make_unique<Scene>(mesh, threads)) {}

ClosestPoint::~ClosestPoint() = default;

FoundPoint ClosestPoint::find(const Vec3& p, TriangleId guess) const {
  struct Nearest {
    const Scene& scene;
    const Vec3& p;
    double square = infinity;  // in the unit frame
    TriangleId triangle = no_id;
    Vec3 position = Vec3::Zero();

    bool visit(std::uint32_t primitive) { return offer(scene.triangle_at(primitive)); }
    bool offer(TriangleId t) {
      const Vec3 point = scene.closest_to(p, t);
      const double offered = scene.square_distance(p, point);
      if (offered > square || (offered == square && t >= triangle)) return false;
      square = offered;
      triangle = t;
      position = point;
      return true;
    }
    [[nodiscard]] double distance() const { return std::sqrt(square); }
  } nearest{*scene_, p};
  if (guess != no_id) nearest.offer(guess);
  search(scene_->scene, scene_->frame(p), nearest);
  return {nearest.triangle, nearest.position, nearest.distance() / scene_->frame.scale};
}

TriangleId ClosestPoint::find_within(const Vec3& p, double distance) const {
  struct Within {
    const ClosestPoint& closest;
    const Vec3& p;
    double most = 0;
    TriangleId triangle = no_id;

    bool visit(std::uint32_t primitive) {
      const TriangleId t = closest.scene_->triangle_at(primitive);
      if (triangle != no_id || closest.distance_to(p, t) > most) return false;
      triangle = t;
      return true;
    }
    // Nothing more is looked for once there is one.
    [[nodiscard]] double distance() const {
      return triangle == no_id ? most * closest.scene_->frame.scale : -1;
    }
  } within{*this, p, distance};
  search(scene_->scene, scene_->frame(p), within);
  return within.triangle;
}

double ClosestPoint::distance_to(const Vec3& p, TriangleId triangle) const {
  return std::sqrt(scene_->square_distance(p, scene_->closest_to(p, triangle))) /
         scene_->frame.scale;
}

}  // namespace geolloyd

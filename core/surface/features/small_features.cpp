#include "core/surface/features/small_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "core/base/sorting.h"
#include "core/surface/features/edge_network.h"

namespace geolloyd {
namespace {

constexpr double sites_on_loop = 9;
constexpr double length_per_width = 2;  // of edges along a wall
constexpr double most_share = 1.0 / 3;

// A vertex of a curve: which curve, and how far along it.
struct CurvePlace {
  std::uint32_t curve = no_id;  // no_id: none, or several: a corner
  double arc = 0;
};

struct Curve {
  std::array<VertexId, 2> ends = {no_id, no_id};  // of a loop: none
  double length = 0;
  std::vector<VertexId> vertices;
  std::vector<double> arc;  // per vertex
  bool is_boundary = false;
};

class SmallFeatureFinder {
 public:
  SmallFeatureFinder(const SurfaceInput& input, double spacing, double growth)
      : input_(input),
        fine_(input.fine),
        spacing_(spacing),
        slope_(growth - 1),
        place_(fine_.vertex_count()),
        at_loop_(fine_.vertex_count(), spacing),
        at_wall_(fine_.vertex_count(), spacing) {
    std::vector<EdgeNetwork::Edge> edges = input.feature_edges;
    edges.insert(edges.end(), input.boundary_edges.begin(), input.boundary_edges.end());
    EdgeNetwork network(std::move(edges), input.fixed_vertices);
    for (const auto& path : network.take_paths()) add_curve(path, false);
    for (const auto& loop : network.take_loops()) {
      add_curve(loop, true);
      shorten_loop(loop, is_boundary(loop) ? shortest_kept_hole : shortest_kept_loop);
    }
  }

  // Loops first: a wall that is too thin for its triangles stays a wall, but a hole of three
  // vertices is none.
  SmallFeatures run() {
    find_opposite_curves();
    if (!has_small(at_loop_) && !has_small(at_wall_)) return {};
    find_own_sizes();
    Floors floors;
    const bool has_room = lower(floors, &Floors::loops) && lower(floors, &Floors::walls);
    SmallFeatures found = at(floors);
    found.is_limited = !has_room && binds(floors);
    if (!(found.share > 0)) found.sizes = {};
    return found;
  }

 private:
  // Smallest sizes that are allowed. Spacings.
  struct Floors {
    double loops = 1;
    double walls = 1;
  };

  // To 1/8 or as far, to 4 %, as small features do not take too much. False where not to 1/8.
  bool lower(Floors& floors, double Floors::*floor) const {
    double least = 0.125;
    floors.*floor = least;
    if (at(floors).share <= most_share) return true;
    double most = 1;
    while (most > 1.04 * least) {
      const double middle = std::sqrt(least * most);
      floors.*floor = middle;
      (at(floors).share <= most_share ? most : least) = middle;
    }
    floors.*floor = most;
    return false;
  }

  // Whether some edges are much longer than they were to be: a loop that was to have nine has
  // fewer than six.
  [[nodiscard]] bool binds(const Floors& floors) const {
    constexpr double much = sites_on_loop / 6;
    const double unit = factor_at(floors) * spacing_;
    return much * *std::min_element(at_loop_.begin(), at_loop_.end()) < floors.loops * unit ||
           much * *std::min_element(at_wall_.begin(), at_wall_.end()) < floors.walls * unit;
  }

  [[nodiscard]] bool has_small(const std::vector<double>& lengths) const {
    return std::any_of(lengths.begin(), lengths.end(), [&](double x) { return x < spacing_; });
  }

  // With more sites in small places all are further apart.
  [[nodiscard]] double factor_at(const Floors& floors) const {
    return std::sqrt(sites(sizes(floors, 1)) / even_);
  }

  [[nodiscard]] SmallFeatures at(const Floors& floors) const {
    const SizesAtSome shorter = sizes(floors, factor_at(floors));
    SmallFeatures found;
    found.share = 1 - even_ / sites(shorter);
    found.sizes = shorter.sizes;
    return found;
  }

  [[nodiscard]] double way(VertexId a, VertexId b) const {
    return norm(fine_.positions[a] - fine_.positions[b]);
  }

  [[nodiscard]] bool is_boundary(const std::vector<VertexId>& vertices) const {
    return std::binary_search(input_.boundary_edges.begin(), input_.boundary_edges.end(),
                              ascending(vertices[0], vertices[1]));
  }

  void add_curve(const std::vector<VertexId>& vertices, bool is_loop) {
    const auto id = static_cast<std::uint32_t>(curves_.size());
    Curve curve;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i > 0) curve.length += way(vertices[i - 1], vertices[i]);
      const bool is_end = !is_loop && (i == 0 || i + 1 == vertices.size());
      if (!is_end) place_[vertices[i]] = {id, curve.length};
      curve.arc.push_back(curve.length);
      sources_.push_back(vertices[i]);
    }
    if (is_loop) {
      curve.length += way(vertices.back(), vertices.front());
    } else {
      curve.ends = {vertices.front(), vertices.back()};
    }
    curve.vertices = vertices;
    curve.is_boundary = is_boundary(vertices);
    curves_.push_back(std::move(curve));
  }

  // The last curve that was added.
  void shorten_loop(const std::vector<VertexId>& vertices, double shortest) {
    const double length = curves_.back().length;
    if (length < shortest * spacing_) return;
    for (const VertexId v : vertices) {
      at_loop_[v] = std::min(at_loop_[v], length / sites_on_loop);
    }
  }

  // From all curves at once, each vertex is reached from the one nearest along edges. Where two
  // fronts meet, curves are opposite to each other.
  void find_opposite_curves() {
    std::vector<double> distance(fine_.vertex_count(), spacing_);
    std::vector<VertexId> from(fine_.vertex_count(), no_id);
    using Entry = std::tuple<double, VertexId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const VertexId v : sources_) {
      distance[v] = 0;
      from[v] = v;
      queue.emplace(0, v);
    }
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v]) continue;
      for (const VertexId u : fine_.neighbours(v)) {
        const double further = d + way(v, u);
        if (!(further < distance[u])) continue;
        distance[u] = further;
        from[u] = from[v];
        queue.emplace(further, u);
      }
    }
    for (VertexId v = 0; v < fine_.vertex_count(); ++v) {
      for (const VertexId u : fine_.neighbours(v)) {
        if (u < v || from[u] == no_id || from[v] == no_id) continue;
        const double between = distance[u] + way(u, v) + distance[v];
        if (!are_opposite(from[u], from[v], between)) continue;
        for (const VertexId w : {from[u], from[v]}) {
          at_wall_[w] = std::min(at_wall_[w], length_per_width * between);
        }
      }
    }
  }

  // Not where the curves meet, or one goes from one place to the other itself.
  [[nodiscard]] bool are_opposite(VertexId a, VertexId b, double between) const {
    const CurvePlace& p = place_[a];
    const CurvePlace& q = place_[b];
    if (p.curve == no_id || q.curve == no_id) return false;
    const Curve& one = curves_[p.curve];
    if (p.curve != q.curve) {
      const Curve& other = curves_[q.curve];
      return std::none_of(one.ends.begin(), one.ends.end(), [&](VertexId end) {
        return end != no_id && (end == other.ends[0] || end == other.ends[1]);
      });
    }
    const double detour = one.is_boundary ? 6 : 3;  // a boundary may be ragged
    const double along = std::abs(p.arc - q.arc);
    const bool is_loop = one.ends[0] == no_id;
    const bool is_around = is_loop && 2 * along > one.length;
    const double way_along = is_around ? one.length - along : along;
    const double from = is_around ? std::max(p.arc, q.arc) : std::min(p.arc, q.arc);
    return way_along >= detour * between && !is_wedge(one, from, way_along, between);
  }

  // Whether a curve turns back between two places as the tip of a wedge does, which is closer
  // further in and opens to a spacing further out.
  [[nodiscard]] bool is_wedge(const Curve& curve, double from, double along, double apart) const {
    constexpr double narrower = 0.75;
    const auto width = [&](double length) {
      const double start = from + (along - length) / 2;
      return norm(point_at(curve, start) - point_at(curve, start + length));
    };
    const double opened = along * (spacing_ / apart);
    const double before = from + (along - opened) / 2;
    const bool is_loop = curve.ends[0] == no_id;
    if (!is_loop && (before < 0 || before + opened > curve.length)) return false;
    return opened < curve.length && width(along / 2) < narrower * apart &&
           width(opened) > narrower * spacing_;
  }

  [[nodiscard]] Vec3 point_at(const Curve& curve, double arc) const {
    arc = arc < 0 ? arc + curve.length : arc < curve.length ? arc : arc - curve.length;
    const auto above = std::upper_bound(curve.arc.begin(), curve.arc.end(), arc);
    const auto i = static_cast<std::size_t>(above - curve.arc.begin()) - 1;
    const bool is_last = i + 1 == curve.arc.size();
    const Vec3& from = fine_.positions[curve.vertices[i]];
    const Vec3& to = fine_.positions[curve.vertices[is_last ? 0 : i + 1]];
    const double length = (is_last ? curve.length : curve.arc[i + 1]) - curve.arc[i];
    return length > 0 ? Vec3(from + (to - from) * ((arc - curve.arc[i]) / length)) : from;
  }

  void find_own_sizes() {
    own_.resize(fine_.vertex_count());
    for (VertexId v = 0; v < own_.size(); ++v) own_[v] = 1 / fine_.inverse_sizing_at(v);
    even_ = 0;
    for (TriangleId t = 0; t < fine_.triangle_count(); ++t) even_ += sites_on(t, own_);
  }

  struct SizesAtSome {
    std::vector<double> sizes;
    std::vector<VertexId> changed;  // more than once, perhaps
  };

  // Where sites are `factor` times the spacing apart.
  [[nodiscard]] SizesAtSome sizes(const Floors& floors, double factor) const {
    SizesAtSome result = {own_, {}};
    std::vector<double>& sizes = result.sizes;
    const double unit = factor * spacing_;
    using Entry = std::pair<double, VertexId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto shorten = [&](VertexId v, double size) {
      if (!(size < sizes[v])) return;
      sizes[v] = size;
      result.changed.push_back(v);
      queue.emplace(size, v);
    };
    for (VertexId v = 0; v < sizes.size(); ++v) {
      if (at_loop_[v] < spacing_) shorten(v, std::max(at_loop_[v] / unit, floors.loops));
      if (at_wall_[v] < spacing_) shorten(v, std::max(at_wall_[v] / unit, floors.walls));
    }
    while (!queue.empty()) {
      const auto [size, v] = queue.top();
      queue.pop();
      if (size > sizes[v]) continue;
      for (const VertexId u : fine_.neighbours(v)) shorten(u, size + slope_ * way(v, u) / unit);
    }
    return result;
  }

  // In proportion.
  [[nodiscard]] double sites(const SizesAtSome& at) const {
    std::vector<TriangleId> triangles;
    for (const VertexId v : at.changed) {
      const auto around = fine_.triangles_at(v);
      triangles.insert(triangles.end(), around.begin(), around.end());
    }
    sort_and_deduplicate(triangles);
    double sum = even_;
    for (const TriangleId t : triangles) sum += sites_on(t, at.sizes) - sites_on(t, own_);
    return sum;
  }

  [[nodiscard]] double sites_on(TriangleId t, const std::vector<double>& sizes) const {
    const auto& [a, b, c] = fine_.triangles[t];
    const double inverse = (1 / sizes[a] + 1 / sizes[b] + 1 / sizes[c]) / 3;
    return fine_.area(t) * (inverse * inverse);
  }

  const SurfaceInput& input_;
  const FineMesh& fine_;
  double spacing_;
  double slope_;
  std::vector<Curve> curves_;
  std::vector<VertexId> sources_;
  std::vector<CurvePlace> place_;  // per vertex
  // Per vertex: length of edges, at most the spacing.
  std::vector<double> at_loop_;
  std::vector<double> at_wall_;
  std::vector<double> own_;  // per vertex: its size without small features
  double even_ = 0;          // sites without small features
};

}  // namespace

SmallFeatures find_small_features(const SurfaceInput& input, double spacing, double growth) {
  if (input.feature_edges.empty() && input.boundary_edges.empty()) return {};
  return SmallFeatureFinder(input, spacing, growth).run();
}

}  // namespace geolloyd

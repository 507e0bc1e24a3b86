#include "core/surface/substrate/split_needles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "core/base/loops.h"
#include "core/base/sorting.h"
#include "core/base/types.h"
#include "core/mesh/closest_on_triangle.h"
#include "core/mesh/mesh_measure.h"
#include "core/surface/substrate/edge_ruler.h"

namespace geolloyd {
namespace {

using Ends = std::array<VertexId, 2>;  // ascending

// Asked for single edges only: their order is nobody's.
class EdgeSet {
 public:
  void add(const Ends& e) { keys_.insert(key(e)); }
  void remove(const Ends& e) { keys_.erase(key(e)); }
  [[nodiscard]] bool has(const Ends& e) const { return keys_.contains(key(e)); }
  [[nodiscard]] std::vector<Ends> all() const {
    std::vector<Ends> ends;
    for (const std::uint64_t k : keys_) {
      ends.push_back({static_cast<VertexId>(k >> 32), static_cast<VertexId>(k)});
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

 private:
  static std::uint64_t key(const Ends& e) { return (std::uint64_t{e[0]} << 32) | e[1]; }
  std::unordered_set<std::uint64_t> keys_;
};

// An edge as one of its triangles sees it: opposite to its corner.
struct Side {
  TriangleId triangle;
  std::uint32_t corner;
};

class NeedleSplitter {
 public:
  NeedleSplitter(Mesh& mesh, std::vector<TriangleId>& origin, EdgeSizes& sizes, double longest,
                 std::span<const TrianglePair> features)
      : mesh_(mesh),
        origin_(origin),
        sizes_(sizes),
        ruler_(mesh, sizes, longest),
        whole_(mesh.triangles),
        whole_origin_(origin),
        source_(mesh.triangle_count()),
        across_(mesh.triangle_count(), {no_id, no_id, no_id}),
        drift_(mesh.triangle_count(), 0) {
    std::iota(source_.begin(), source_.end(), TriangleId{0});
    connect(features);
  }

  void run(std::size_t vertex_limit) {
    for (TriangleId t = 0; t < across_.size(); ++t) look_at(t);
    flip_all();
    while (!longest_first_.empty() && mesh_.vertex_count() < vertex_limit) {
      const LongEdge edge = longest_first_.top();
      longest_first_.pop();
      if (ends_of(edge.side) != edge.ends) continue;  // it was flipped or halved since
      halve(edge.side);
      flip_all();
    }
    origin_.clear();
    for (const TriangleId source : source_) origin_.push_back(whole_origin_[source]);
  }

  [[nodiscard]] std::vector<Ends> features() const { return features_.all(); }

 private:
  struct LongEdge {
    double ratio;  // its length, over what is long
    Ends ends;
    Side side;

    friend bool operator<(const LongEdge& a, const LongEdge& b) {
      return std::tie(a.ratio, b.ends, b.side.triangle) <
             std::tie(b.ratio, a.ends, a.side.triangle);
    }
  };

  [[nodiscard]] VertexId corner(TriangleId t, std::uint32_t k) const {
    return mesh_.triangles[t][k % 3];
  }
  [[nodiscard]] const Vec3& at(VertexId v) const { return mesh_.positions[v]; }
  [[nodiscard]] Ends ends_of(Side side) const {
    return ascending(corner(side.triangle, side.corner + 1),
                     corner(side.triangle, side.corner + 2));
  }

  void connect(std::span<const TrianglePair> features) {
    std::vector<std::pair<Ends, Side>> sides;
    for (TriangleId t = 0; t < across_.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) sides.push_back({ends_of({t, k}), {t, k}});
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto& [ends, side] = sides[i];
      edges_.add(ends);
      if (i == 0 || sides[i - 1].first != ends) continue;
      const Side other = sides[i - 1].second;
      across_[side.triangle][side.corner] = other.triangle;
      across_[other.triangle][other.corner] = side.triangle;
      const TrianglePair pair = ascending(origin_[side.triangle], origin_[other.triangle]);
      if (std::binary_search(features.begin(), features.end(), pair)) features_.add(ends);
    }
  }

  // The corner of `t` across whose opposite edge `other` is.
  [[nodiscard]] std::uint32_t corner_before(TriangleId t, TriangleId other) const {
    const auto found = std::find(across_[t].begin(), across_[t].end(), other);
    return static_cast<std::uint32_t>(found - across_[t].begin());
  }
  void join(TriangleId t, TriangleId before, TriangleId now) {
    if (t != no_id) across_[t][corner_before(t, before)] = now;
  }

  // A triangle that is new or has changed.
  void look_at(TriangleId t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Ends ends = ends_of({t, k});
      if (is_long(ends)) longest_first_.push({ruler_.ratio(ends[0], ends[1]), ends, {t, k}});
      if (across_[t][k] != no_id) to_flip_.push_back({{t, k}, ends});
    }
  }

  // Where coordinates are too coarse for a middle, an edge is as short as it can be
  // (split_edges.cpp).
  [[nodiscard]] bool is_long(const Ends& ends) const {
    if (!ruler_.is_long(ends[0], ends[1])) return false;
    const double length = norm(at(ends[1]) - at(ends[0]));
    const Vec3 middle = (at(ends[0]) + at(ends[1])) / 2;
    return norm(middle - at(ends[0])) < 0.75 * length && norm(middle - at(ends[1])) < 0.75 * length;
  }

  void halve(Side side) {
    const Ends ends = ends_of(side);
    const auto m = static_cast<VertexId>(mesh_.positions.size());
    mesh_.positions.emplace_back((at(ends[0]) + at(ends[1])) / 2);
    add_sizes_between(ends);
    const TriangleId t = side.triangle;
    const TriangleId u = across_[t][side.corner];
    const std::uint32_t other = u == no_id ? 0 : corner_before(u, t);
    // The halves at ends[0] stay with the old triangles.
    const TriangleId of_t = cut(side, ends[1], m);
    const TriangleId of_u = u == no_id ? no_id : cut({u, other}, ends[1], m);
    across_[of_t][side.corner] = of_u;
    if (of_u != no_id) across_[of_u][other] = of_t;
    replace_edge(ends, m);
    for (const TriangleId piece : {t, of_t, u, of_u}) {
      if (piece != no_id) look_at(piece);
    }
  }

  void add_sizes_between(const Ends& ends) {
    auto& [sizes, metric] = sizes_;
    if (!sizes.empty()) sizes.push_back((sizes[ends[0]] + sizes[ends[1]]) / 2);
    if (!metric.empty()) metric.push_back(0.5 * (metric[ends[0]] + metric[ends[1]]));
  }

  void replace_edge(const Ends& ends, VertexId m) {
    edges_.remove(ends);
    const bool is_feature = features_.has(ends);
    if (is_feature) features_.remove(ends);
    for (const VertexId v : ends) {
      edges_.add({v, m});
      if (is_feature) features_.add({v, m});
    }
  }

  // Gives the half at `end` to a new triangle, with the same corners in the same places. The other
  // half stays across from what it was.
  TriangleId cut(Side side, VertexId end, VertexId m) {
    const auto [t, k] = side;
    const auto piece = static_cast<TriangleId>(mesh_.triangles.size());
    const std::uint32_t at_end = corner(t, k + 1) == end ? (k + 1) % 3 : (k + 2) % 3;
    const std::uint32_t at_start = 3 - k - at_end;
    Triangle whole = mesh_.triangles[t];
    std::array<TriangleId, 3> beyond = across_[t];
    edges_.add(ascending(whole[k], m));
    mesh_.triangles[t][at_end] = m;
    across_[t][at_start] = piece;
    whole[at_start] = m;
    join(beyond[at_start], t, piece);
    beyond[at_end] = t;
    mesh_.triangles.push_back(whole);
    across_.push_back(beyond);
    source_.push_back(TriangleId{source_[t]});
    drift_.push_back(double{drift_[t]});
    return piece;
  }

  // a: the side's corner; b, c: the edge; d: the corner beyond it.
  struct Quad {
    VertexId a, b, c, d;
  };

  void flip_all() {
    // Of n points of a plane flips end by themselves, mostly after a few for each. Where rounding
    // or bends keep them going, there is an end, too.
    std::size_t left = 64 * (to_flip_.size() + 1);
    while (!to_flip_.empty()) {
      const auto [side, ends] = to_flip_.back();
      to_flip_.pop_back();
      if (left > 0 && ends_of(side) == ends && flip_if_better(side)) --left;
    }
  }

  bool flip_if_better(Side side) {
    const auto [t, k] = side;
    const TriangleId u = across_[t][k];
    if (u == no_id || features_.has(ends_of(side))) return false;
    const std::uint32_t at_d = corner_before(u, t);
    if (corner(u, at_d + 1) != corner(t, k + 2)) return false;  // of another orientation
    const Quad quad = {corner(t, k), corner(t, k + 1), corner(t, k + 2), corner(u, at_d)};
    if (is_delaunay(quad) || edges_.has(ascending(quad.a, quad.d))) return false;
    const double most = most_drift(quad);
    const double drift = std::max(drift_[t], drift_[u]) + counted(sag(quad), most);
    if (!(drift <= most) || !is_flat(quad)) return false;
    flip(side, quad);
    drift_[t] = drift_[u] = drift;
    return true;
  }

  // The angles opposite to the edge sum up to no more than half a turn.
  [[nodiscard]] bool is_delaunay(const Quad& q) const {
    constexpr double rounding = 1e-9;
    const Vec3 ab = at(q.b) - at(q.a);
    const Vec3 ac = at(q.c) - at(q.a);
    const Vec3 db = at(q.b) - at(q.d);
    const Vec3 dc = at(q.c) - at(q.d);
    const double sine_of_sum =
        norm(cross(ab, ac)) * dot(db, dc) + dot(ab, ac) * norm(cross(db, dc));
    return sine_of_sum >= -rounding * (norm(ab) * norm(ac) * norm(db) * norm(dc));
  }

  // The distance of the lines through the two diagonals: by at most that the surface moves.
  [[nodiscard]] double sag(const Quad& q) const {
    const Vec3 normal = cross(at(q.c) - at(q.b), at(q.d) - at(q.a));
    const double length = norm(normal);
    return length > 0 ? std::abs(dot(normal, at(q.b) - at(q.a))) / length
                      : std::numeric_limits<double>::infinity();
  }
  // Rounding of the coordinates of a plane does not add up.
  static double counted(double sag, double most) {
    constexpr double rounding = 1.0 / 32;
    return sag <= rounding * most ? 0 : sag;
  }
  [[nodiscard]] double most_drift(const Quad& q) const {
    constexpr double share = 1.0 / 32;
    return share * std::min(ruler_.longest_at(q.b, q.c), ruler_.longest_at(q.a, q.d));
  }

  // Both pairs of triangles face the same way. One that is so thin that rounding of coordinates may
  // have turned it over may have faced any way before, but not after.
  [[nodiscard]] bool is_flat(const Quad& q) const {
    constexpr double least_cosine = 0.5;  // of 60 degrees
    const Vec3 whole = doubled_area(q.a, q.b, q.c) + doubled_area(q.d, q.c, q.b);
    const auto faces_so = [&](VertexId a, VertexId b, VertexId c) {
      const Vec3 n = doubled_area(a, b, c);
      const double lengths = norm(n) * norm(whole);
      return lengths > 0 && dot(n, whole) >= least_cosine * lengths;
    };
    const double thin = most_drift(q) / 16;
    return (faces_so(q.a, q.b, q.c) || is_thin(q.a, q.b, q.c, thin)) &&
           (faces_so(q.d, q.c, q.b) || is_thin(q.d, q.c, q.b, thin)) && faces_so(q.a, q.b, q.d) &&
           faces_so(q.a, q.d, q.c);
  }
  [[nodiscard]] bool is_thin(VertexId a, VertexId b, VertexId c, double height) const {
    const double base = std::max({norm(at(b) - at(a)), norm(at(c) - at(b)), norm(at(a) - at(c))});
    return norm(doubled_area(a, b, c)) <= height * base;
  }
  [[nodiscard]] Vec3 doubled_area(VertexId a, VertexId b, VertexId c) const {
    return cross(at(b) - at(a), at(c) - at(a));
  }

  void flip(Side side, const Quad& q) {
    const TriangleId t = side.triangle;
    const TriangleId u = across_[t][side.corner];
    const std::uint32_t at_d = corner_before(u, t);
    const TriangleId beyond_ab = across_[t][(side.corner + 2) % 3];
    const TriangleId beyond_ca = across_[t][(side.corner + 1) % 3];
    const TriangleId beyond_dc = across_[u][(at_d + 2) % 3];
    const TriangleId beyond_bd = across_[u][(at_d + 1) % 3];
    mesh_.triangles[t] = {q.a, q.b, q.d};
    mesh_.triangles[u] = {q.a, q.d, q.c};
    const std::array<TriangleId, 2> sources = {source_[t], source_[u]};
    for (const TriangleId flipped : {t, u})
      source_[flipped] = nearer(barycentre(mesh_, flipped), sources);
    across_[t] = {beyond_bd, u, beyond_ab};
    across_[u] = {beyond_dc, beyond_ca, t};
    join(beyond_bd, u, t);
    join(beyond_ca, t, u);
    edges_.remove(ascending(q.b, q.c));
    edges_.add(ascending(q.a, q.d));
    look_at(t);
    look_at(u);
  }

  [[nodiscard]] TriangleId nearer(const Vec3& p, const std::array<TriangleId, 2>& sources) const {
    if (sources[0] == sources[1]) return sources[0];
    return square_distance(p, sources[1]) < square_distance(p, sources[0]) ? sources[1]
                                                                           : sources[0];
  }
  [[nodiscard]] double square_distance(const Vec3& p, TriangleId source) const {
    const Triangle& t = whole_[source];
    const Vec3 a = at(t[0]) - p;
    const Vec3 b = at(t[1]) - p;
    const Vec3 c = at(t[2]) - p;
    const auto [v, w] = barycentric_closest_to_origin({a, b, c});
    const Vec3 away = a + v * (b - a) + w * (c - a);
    return dot(away, away);
  }

  Mesh& mesh_;
  std::vector<TriangleId>& origin_;
  EdgeSizes& sizes_;
  EdgeRuler ruler_;
  std::vector<Triangle> whole_;                    // as they were
  std::vector<TriangleId> whole_origin_;           // theirs
  std::vector<TriangleId> source_;                 // per triangle: one of those, near it
  std::vector<std::array<TriangleId, 3>> across_;  // per triangle: beyond the edge opposite to each
                                                   // corner
  std::vector<double> drift_;                      // per triangle: how far flips have moved it
  EdgeSet edges_;
  EdgeSet features_;
  std::vector<std::pair<Side, Ends>> to_flip_;
  std::priority_queue<LongEdge> longest_first_;
};

}  // namespace

double pieces_of_long_edges(const Mesh& mesh, const EdgeSizes& sizes, double longest,
                            Executor& executor) {
  if (!(longest > 0)) return 0;
  const EdgeRuler ruler(mesh, sizes, longest);
  const auto pieces_at = [&](const Triangle& t) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (ruler.is_long(t[c], t[(c + 1) % 3])) sum += ruler.ratio(t[c], t[(c + 1) % 3]) / 2;
    }
    return sum;
  };
  std::vector<double> of_range(mesh.triangle_count() / small_items + 1, 0);
  parallel_for_ranges(executor, mesh.triangle_count(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        double sum = 0;
                        for (std::size_t t = begin; t < end; ++t) {
                          sum += pieces_at(mesh.triangles[t]);
                        }
                        of_range[begin / small_items] = sum;
                      });
  return std::accumulate(of_range.begin(), of_range.end(), 0.0);
}

std::vector<std::array<VertexId, 2>> split_needles(Mesh& mesh, std::vector<TriangleId>& origin,
                                                   EdgeSizes& sizes, double longest,
                                                   std::size_t vertex_limit,
                                                   std::span<const TrianglePair> features) {
  NeedleSplitter splitter(mesh, origin, sizes, longest, features);
  splitter.run(vertex_limit);
  return splitter.features();
}

}  // namespace geolloyd

#include "core/surface/features/feature_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/rounding.h"
#include "core/base/sorting.h"

namespace geolloyd {
namespace {

using Edge = std::array<VertexId, 2>;

// A polygon of vertices, open or closed.
class Path {
 public:
  Path(const FineMesh& mesh, std::vector<VertexId> vertices, bool is_closed)
      : mesh_(mesh), vertices_(std::move(vertices)), is_closed_(is_closed), arc_(1, 0) {
    for (std::size_t i = 0; i < edges(); ++i) {
      length_ += norm(position(i + 1) - position(i));
      arc_.push_back(arc_.back() + mesh_.sized_length(vertices_[i], vertices_[(i + 1) % size()]));
    }
  }

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  /// Counted by the inverse sizing.
  [[nodiscard]] double sized_length() const { return arc_.back(); }

  /// Of a closed one: three sites on it would be closer together than they should.
  [[nodiscard]] bool is_subresolution_hole(double spacing) const {
    constexpr double least_share = 0.6;  // of a spacing
    spacing /= inverse_sizing(0);
    const double third = length_ / 3;
    if (third < least_share * spacing) return true;
    if (third > 1.5 * spacing) return false;
    const Vec3 a = position(0);
    const Vec3 b = point_at(0, third);
    const Vec3 c = point_at(0, 2 * third);
    return std::min({norm(a - b), norm(b - c), norm(c - a)}) < least_share * spacing;
  }

  /// Places in `vertices` at which it turns most sharply within half a spacing, ascending; no ends.
  [[nodiscard]] std::vector<std::size_t> corners(double spacing) const {
    const auto reach_at = [&](std::size_t i) { return spacing / 2 / inverse_sizing(i); };
    const std::size_t first = is_closed_ ? 0 : 1;
    const std::size_t last = is_closed_ ? size() : size() - 1;
    std::vector<double> turn(size(), 1);  // cosine
    for (std::size_t i = first; i < last; ++i) turn[i] = cosine_of_turn(i, reach_at(i));
    std::vector<std::size_t> found;
    for (std::size_t i = first; i < last; ++i) {
      const double reach = reach_at(i);
      if (is_corner(turn[i], i, reach) && is_sharpest(turn, i, reach)) found.push_back(i);
    }
    return found;
  }

  /// From one place to a later one, or around to it.
  [[nodiscard]] FeatureCurve curve(std::size_t from, std::size_t to) const {
    FeatureCurve curve;
    for (std::size_t i = from; i <= to; ++i) {
      curve.vertices.push_back(vertices_[i % size()]);
      curve.arc.push_back(
          i == from ? 0 : curve.arc.back() + (arc_[(i - 1) % size() + 1] - arc_[(i - 1) % size()]));
    }
    return curve;
  }

 private:
  [[nodiscard]] std::size_t edges() const { return is_closed_ ? size() : size() - 1; }
  [[nodiscard]] const Vec3& position(std::size_t i) const {
    return mesh_.positions[vertices_[i % size()]];
  }
  [[nodiscard]] double inverse_sizing(std::size_t i) const {
    return mesh_.inverse_sizing_at(vertices_[i % size()]);
  }
  // Whether it goes on from vertex i; else that is an end.
  [[nodiscard]] bool goes_on(std::size_t i, bool forward) const {
    return is_closed_ || i != (forward ? size() - 1 : 0);
  }

  // At `way` along the path from vertex i, or at its end; negative: backward.
  [[nodiscard]] Vec3 point_at(std::size_t i, double way) const {
    const std::size_t step = way > 0 ? 1 : size() - 1;
    if (!(length_ > 0)) return position(i);
    double left = std::abs(way);
    if (left >= length_) left = std::fmod(left, length_);  // which is exact
    while (goes_on(i, way > 0)) {
      const std::size_t next = (i + step) % size();
      const double edge = norm(position(next) - position(i));
      if (left < edge) return position(i) + (position(next) - position(i)) * (left / edge);
      left -= edge;
      i = next;
    }
    return position(i);
  }

  [[nodiscard]] double cosine_of_turn(std::size_t i, double reach) const {
    const Vec3 in = normalized(position(i) - point_at(i, -reach));
    const Vec3 out = normalized(point_at(i, reach) - position(i));
    return dot(in, out);
  }

  // Where the sides are not straight, a smaller turn may be that of a smooth curve, or of a jag.
  [[nodiscard]] bool is_corner(double cosine, std::size_t i, double reach) const {
    constexpr double sharp_cosine = 0.6427876096865394;  // of 50 degrees
    constexpr double blunt_cosine = 0.8660254037844386;  // of 30 degrees
    if (cosine >= blunt_cosine) return false;
    if (cosine < sharp_cosine) return true;
    constexpr double straight = 0.995;
    return norm(point_at(i, reach) - position(i)) > straight * reach &&
           norm(point_at(i, -reach) - position(i)) > straight * reach;
  }

  // Of equals, the first one.
  [[nodiscard]] bool is_sharpest(const std::vector<double>& turn, std::size_t i,
                                 double reach) const {
    for (const std::size_t step : {std::size_t{1}, size() - 1}) {
      double way = 0;
      for (std::size_t j = i; way <= reach && goes_on(j, step == 1);) {
        const std::size_t next = (j + step) % size();
        way += norm(position(next) - position(j));
        j = next;
        if (j == i || way > reach) break;
        if (std::pair(turn[j], j) < std::pair(turn[i], i)) return false;
      }
    }
    return true;
  }

  const FineMesh& mesh_;
  std::vector<VertexId> vertices_;
  bool is_closed_;
  double length_ = 0;
  std::vector<double> arc_;
};

// Edges as seen from both of their ends.
class Network {
 public:
  Network(std::vector<Edge> edges, std::vector<VertexId> fixed)
      : ends_(std::move(edges)), fixed_(std::move(fixed)) {
    const std::size_t count = ends_.size();
    for (std::size_t i = 0; i < count; ++i) ends_.push_back({ends_[i][1], ends_[i][0]});
    std::sort(ends_.begin(), ends_.end());
    is_done_.assign(ends_.size(), 0);
  }

  [[nodiscard]] std::size_t degree(VertexId v) const {
    std::size_t count = 0;
    for (std::size_t i = first_at(v); i < ends_.size() && ends_[i][0] == v; ++i) ++count;
    return count;
  }
  /// Where other than two edges meet, and where a vertex is fixed.
  [[nodiscard]] bool is_node(VertexId v) const {
    return degree(v) != 2 || std::binary_search(fixed_.begin(), fixed_.end(), v);
  }
  /// Ascending.
  [[nodiscard]] std::vector<VertexId> nodes() const {
    std::vector<VertexId> nodes = fixed_;
    for (const Edge& e : ends_) {
      if (is_node(e[0])) nodes.push_back(e[0]);
    }
    sort_and_deduplicate(nodes);
    return nodes;
  }

  /// From node to node; each once.
  std::vector<std::vector<VertexId>> take_paths() {
    std::vector<std::vector<VertexId>> paths;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (is_done_[i] == 0 && is_node(ends_[i][0])) paths.push_back(walk(i));
    }
    return paths;
  }
  /// What is left: each begins at its smallest vertex and goes toward the smaller of its
  /// neighbours.
  std::vector<std::vector<VertexId>> take_loops() {
    std::vector<std::vector<VertexId>> loops;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (is_done_[i] != 0) continue;
      loops.push_back(walk(i));
      loops.back().pop_back();
    }
    return loops;
  }

 private:
  [[nodiscard]] std::size_t first_at(VertexId v) const {
    return static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), Edge{v, 0}) -
                                    ends_.begin());
  }

  // To the next node, or around.
  std::vector<VertexId> walk(std::size_t at) {
    const VertexId start = ends_[at][0];
    std::vector<VertexId> path = {start};
    while (true) {
      const auto [from, to] = ends_[at];
      take(from, to);
      path.push_back(to);
      if (to == start || is_node(to)) return path;
      const std::size_t first = first_at(to);
      at = ends_[first][1] != from ? first : first + 1;
    }
  }
  void take(VertexId a, VertexId b) {
    for (const Edge& e : {Edge{a, b}, Edge{b, a}}) {
      is_done_[static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), e) -
                                        ends_.begin())] = 1;
    }
  }

  std::vector<Edge> ends_;  // both directions; ascending
  std::vector<VertexId> fixed_;
  std::vector<std::uint8_t> is_done_;
};

// The edge on which the place `at` is.
std::size_t edge_at(const FeatureCurve& curve, double at) {
  const auto above = std::upper_bound(curve.arc.begin() + 1, curve.arc.end() - 1, at);
  return static_cast<std::size_t>(above - curve.arc.begin()) - 1;
}

Vec3 point_at(const FineMesh& mesh, const FeatureCurve& curve, double at) {
  const std::size_t edge = edge_at(curve, at);
  const Vec3& a = mesh.positions[curve.vertices[edge]];
  const Vec3& b = mesh.positions[curve.vertices[edge + 1]];
  const double length = curve.arc[edge + 1] - curve.arc[edge];
  return length > 0 ? Vec3(a + (b - a) * ((at - curve.arc[edge]) / length)) : a;
}

// Of a displacement, as edges are counted there.
double sized_length(const FineMesh& mesh, const FeatureCurve& curve, double at,
                    const Vec3& displacement) {
  const std::size_t edge = edge_at(curve, at);
  const VertexId a = curve.vertices[edge];
  const VertexId b = curve.vertices[edge + 1];
  return mesh.length_between(a, b, displacement) *
         ((mesh.inverse_sizing_at(a) + mesh.inverse_sizing_at(b)) / 2);
}

// How often `spacing` goes into `length`, and no more than a curve has edges.
std::size_t intervals_of(const FeatureCurve& curve, double length, double spacing) {
  const std::size_t most = curve.vertices.size() - 1;
  if (!(length < spacing * static_cast<double>(most))) return most;
  return std::clamp(round_to_whole(length / spacing), std::min(curve.least_intervals, most), most);
}

// Where even places, so many as there are spacings, are joined by straight lines; counted by the
// inverse sizing.
double length_of_chords(const FineMesh& mesh, const FeatureCurve& curve, double spacing) {
  const std::size_t count = intervals_of(curve, curve.length(), spacing);
  const auto place = [&](double i) { return curve.length() * i / static_cast<double>(count); };
  double sum = 0;
  Vec3 last = mesh.positions[curve.vertices.front()];
  for (std::size_t i = 1; i <= count; ++i) {
    const auto end = static_cast<double>(i);
    const Vec3 next = point_at(mesh, curve, place(end));
    sum += sized_length(mesh, curve, place(end - 0.5), next - last);
    last = next;
  }
  return sum;
}

// Cuts a path into curves, at its corners.
class ChainCutter {
 public:
  ChainCutter(const SurfaceInput& input, double spacing, FeatureCurves& curves)
      : features_(input.feature_edges), mesh_(input.fine), spacing_(spacing), curves_(curves) {}

  // A loop that is to have few sites keeps three corners or none: curves between one or two would
  // be too short for even spacing.
  void add_loop(const std::vector<VertexId>& vertices) {
    constexpr double few = 6;  // spacings
    const Path loop(mesh_, vertices, true);
    const std::vector<std::size_t> corners = loop.corners(spacing_);
    if (corners.empty() || (corners.size() < 3 && loop.sized_length() < few * spacing_)) {
      const std::size_t start = corners.empty() ? 0 : corners.front();
      curves_.curves.push_back(loop.curve(start, start + loop.size()));
      curves_.curves.back().is_loop = true;
      return;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool is_last = i + 1 == corners.size();
      const std::size_t to = is_last ? corners.front() + loop.size() : corners[i + 1];
      curves_.curves.push_back(loop.curve(corners[i], to));
      curves_.corners.push_back(vertices[corners[i]]);
    }
  }

  // Its ends are corners already.
  void add_path(const std::vector<VertexId>& vertices) {
    const Path path(mesh_, vertices, false);
    std::size_t from = 0;
    for (const std::size_t corner : path.corners(spacing_)) {
      curves_.curves.push_back(path.curve(from, corner));
      curves_.corners.push_back(vertices[corner]);
      from = corner;
    }
    curves_.curves.push_back(path.curve(from, vertices.size() - 1));
  }

  // No two edges of a remesh join the same vertices.
  void count_intervals() {
    widen_acute_corners();
    std::vector<Edge> ends;
    for (const FeatureCurve& curve : curves_.curves) ends.push_back(ends_of(curve));
    std::sort(ends.begin(), ends.end());
    for (FeatureCurve& curve : curves_.curves) {
      const auto same = std::equal_range(ends.begin(), ends.end(), ends_of(curve));
      const bool is_alone = same.second - same.first == 1;
      curve.least_intervals = ends_of(curve)[0] == ends_of(curve)[1] ? 3 : is_alone ? 1 : 2;
      curve.of_chords = length_of_chords(mesh_, curve, spacing_);
      if (is_feature(curve)) follow_curve(curve);
    }
  }

 private:
  // An end of a curve, as its corner sees it.
  struct End {
    VertexId corner;
    Vec3 direction;
    double* step;
  };

  // Of an angle t, two curves with even sites would span triangles whose smallest angle is less
  // than t: those that the first sites, at a distance of 1, make with the second at a distance
  // of r, if r > 2 cos t.
  void widen_acute_corners() {
    std::vector<End> ends;
    for (FeatureCurve& curve : curves_.curves) {
      if (curve.is_loop) continue;
      const std::size_t last = curve.vertices.size() - 1;
      ends.push_back({curve.vertices[0], direction(curve, 0, 1), &curve.first_step});
      ends.push_back({curve.vertices[last], direction(curve, last, last - 1), &curve.last_step});
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const End& a, const End& b) { return a.corner < b.corner; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size() && ends[j].corner == ends[i].corner; ++j) {
        constexpr double acute_cosine = 0.8;  // of 37 degrees
        const double cosine = dot(ends[i].direction, ends[j].direction);
        if (cosine < acute_cosine) continue;
        for (double* step : {ends[i].step, ends[j].step}) {
          *step = std::max(*step, 1 / (2 * cosine - 1));
        }
      }
    }
  }
  [[nodiscard]] bool is_feature(const FeatureCurve& curve) const {
    return std::binary_search(features_.begin(), features_.end(),
                              ascending(curve.vertices[0], curve.vertices[1]));
  }

  // Up to half as many intervals again where chords would leave the curve by much.
  void follow_curve(FeatureCurve& curve) const {
    constexpr double most_sag = 0.09;  // of a chord's length
    const std::size_t ordinary = curve.intervals(spacing_);
    const std::size_t most = std::min(ordinary + ordinary / 2, curve.vertices.size() - 1);
    std::size_t count = ordinary;
    while (count < most && largest_sag(curve, count) > most_sag) ++count;
    if (count > ordinary) curve.of_chords = static_cast<double>(count) * spacing_;
  }
  [[nodiscard]] double largest_sag(const FeatureCurve& curve, std::size_t intervals) const {
    double largest = 0;
    for (std::size_t i = 0; i < intervals; ++i) {
      const double from = curve.place(i, intervals);
      const double to = curve.place(i + 1, intervals);
      const Vec3 a = point_at(mesh_, curve, from);
      const Vec3 b = point_at(mesh_, curve, to);
      const Vec3 middle = point_at(mesh_, curve, (from + to) / 2);
      const double sag = sized_length(mesh_, curve, (from + to) / 2, middle - (a + b) / 2);
      largest = std::max(largest, sag / (to - from));
    }
    return largest;
  }
  [[nodiscard]] Vec3 direction(const FeatureCurve& curve, std::size_t from, std::size_t to) const {
    return normalized(mesh_.positions[curve.vertices[to]] - mesh_.positions[curve.vertices[from]]);
  }

  static Edge ends_of(const FeatureCurve& curve) {
    return ascending(curve.vertices.front(), curve.vertices.back());
  }

  const std::vector<Edge>& features_;
  const FineMesh& mesh_;
  double spacing_;
  FeatureCurves& curves_;
};

std::size_t index_of(const std::vector<VertexId>& ascending_ids, VertexId v) {
  return static_cast<std::size_t>(std::lower_bound(ascending_ids.begin(), ascending_ids.end(), v) -
                                  ascending_ids.begin());
}

class ChainSitePlacer {
 public:
  ChainSitePlacer(const SurfaceInput& input, const FeatureCurves& curves)
      : input_(input), curves_(curves) {}

  CurveSites run(double spacing) {
    result_.label.assign(curves_.vertices.size(), no_id);
    for (const VertexId v : curves_.corners) {
      result_.sites.push_back(input_.fine.positions[v]);
      label_of(v) = static_cast<RegionId>(result_.sites.size() - 1);
    }
    for (const FeatureCurve& curve : curves_.curves) add_curve(curve, curve.intervals(spacing));
    return std::move(result_);
  }

 private:
  RegionId& label_of(VertexId v) { return result_.label[index_of(curves_.vertices, v)]; }

  [[nodiscard]] RegionId corner_site(VertexId v) const {
    return static_cast<RegionId>(index_of(curves_.corners, v));
  }

  void add_curve(const FeatureCurve& curve, std::size_t intervals) {
    std::vector<std::size_t> place = even_places(curve, intervals);
    const bool is_even = has_all_places(place, intervals);
    if (!is_even) place = places_at_vertices(curve, intervals);
    std::vector<RegionId> site(intervals + 1);
    for (std::size_t i = 0; i <= intervals; ++i) {
      if ((i == 0 || i == intervals) && !curve.is_loop) {
        site[i] = corner_site(i == 0 ? curve.vertices.front() : curve.vertices.back());
      } else if (i == intervals) {
        site[i] = site[0];
      } else {
        site[i] = static_cast<RegionId>(result_.sites.size());
        const auto at = std::find(place.begin(), place.end(), i) - place.begin();
        const double even = curve.place(i, intervals);
        result_.sites.push_back(
            is_even ? point_at(input_.fine, curve, even)
                    : input_.fine.positions[curve.vertices[static_cast<std::size_t>(at)]]);
      }
    }
    const std::size_t last = curve.vertices.size() - 1;
    for (std::size_t i = curve.is_loop ? 0 : 1; i < last; ++i) {
      label_of(curve.vertices[i]) = site[place[i]];
    }
  }

  // Per vertex of a curve: the nearest of so many even places.
  static std::vector<std::size_t> even_places(const FeatureCurve& curve, std::size_t intervals) {
    std::vector<std::size_t> place;
    std::size_t nearest = 0;
    for (const double arc : curve.arc) {
      while (nearest < intervals && curve.length() > 0 &&
             2 * arc >= curve.place(nearest, intervals) + curve.place(nearest + 1, intervals)) {
        ++nearest;
      }
      place.push_back(nearest);
    }
    return place;
  }

  static bool has_all_places(const std::vector<std::size_t>& place, std::size_t intervals) {
    for (std::size_t i = 1; i < intervals; ++i) {
      if (std::find(place.begin(), place.end(), i) == place.end()) return false;
    }
    return true;
  }

  // Where edges are longer than the spacing: sites on vertices, counted instead of measured.
  static std::vector<std::size_t> places_at_vertices(const FeatureCurve& curve,
                                                     std::size_t intervals) {
    std::vector<std::size_t> place;
    const std::size_t edges = curve.vertices.size() - 1;
    for (std::size_t i = 0; i <= edges; ++i) place.push_back(i * intervals / edges);
    return place;
  }

  const SurfaceInput& input_;
  const FeatureCurves& curves_;
  CurveSites result_;
};

// Per part: whether it has room for sites beside a sub-resolution hole.
std::vector<std::uint8_t> find_roomy_parts(const SurfaceInput& input, double spacing) {
  constexpr double room = 8;  // square spacings
  std::vector<double> area(input.parts, 0);
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    area[input.part[input.fine.triangles[t][0]]] += input.fine.sized_area(t);
  }
  std::vector<std::uint8_t> is_roomy;
  is_roomy.reserve(area.size());
  for (const double a : area) is_roomy.push_back(a > room * spacing * spacing ? 1 : 0);
  return is_roomy;
}

}  // namespace

double FeatureCurve::place(std::size_t i, std::size_t intervals) const {
  if (i == 0) return 0;
  if (i >= intervals) return length();
  const double steps = static_cast<double>(intervals) - 2 + first_step + last_step;
  return length() * (first_step + static_cast<double>(i - 1)) / steps;
}

std::size_t FeatureCurve::intervals(double spacing) const {
  return intervals_of(*this, of_chords, spacing);
}

FeatureCurves find_feature_curves(const SurfaceInput& input, double spacing,
                                  bool may_have_subresolution_holes) {
  FeatureCurves curves;
  std::vector<Edge> edges = input.feature_edges;
  edges.insert(edges.end(), input.boundary_edges.begin(), input.boundary_edges.end());
  const Network whole(edges, input.fixed_vertices);
  edges = input.feature_edges;
  const std::vector<std::uint8_t> is_roomy = find_roomy_parts(input, spacing);
  for (std::vector<VertexId>& loop : Network(input.boundary_edges, {}).take_loops()) {
    curves.loops.push_back(loop.front());
    const bool has_node =
        std::any_of(loop.begin(), loop.end(), [&](VertexId v) { return whole.is_node(v); });
    if (may_have_subresolution_holes && !has_node && is_roomy[input.part[loop.front()]] != 0 &&
        Path(input.fine, loop, true).is_subresolution_hole(spacing)) {
      curves.subresolution_holes.push_back(std::move(loop));
    } else {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        edges.push_back(ascending(loop[i], loop[(i + 1) % loop.size()]));
      }
    }
  }
  for (const Edge& e : edges) curves.vertices.insert(curves.vertices.end(), e.begin(), e.end());
  Network network(std::move(edges), input.fixed_vertices);
  curves.corners = network.nodes();
  curves.vertices.insert(curves.vertices.end(), curves.corners.begin(), curves.corners.end());
  ChainCutter cutter(input, spacing, curves);
  for (const auto& path : network.take_paths()) cutter.add_path(path);
  for (const auto& loop : network.take_loops()) cutter.add_loop(loop);
  cutter.count_intervals();
  sort_and_deduplicate(curves.corners);
  sort_and_deduplicate(curves.vertices);
  return curves;
}

CurveSites place_curve_sites(const SurfaceInput& input, const FeatureCurves& curves,
                             double spacing) {
  return ChainSitePlacer(input, curves).run(spacing);
}

std::vector<std::array<RegionId, 2>> neighbours_on_curves(const FeatureCurves& curves,
                                                          std::span<const RegionId> label) {
  std::vector<std::array<RegionId, 2>> pairs;
  for (const FeatureCurve& curve : curves.curves) {
    RegionId before = no_id;
    for (const VertexId v : curve.vertices) {
      const RegionId r = label[index_of(curves.vertices, v)];
      if (before != no_id && r != before) pairs.push_back(ascending(before, r));
      before = r;
    }
  }
  sort_and_deduplicate(pairs);
  return pairs;
}

}  // namespace geolloyd

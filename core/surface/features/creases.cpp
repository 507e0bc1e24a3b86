#include "core/surface/features/creases.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/packing.h"
#include "core/base/sorting.h"
#include "core/surface/features/degrees.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

using EdgeId = std::uint32_t;

// What is asked of creases. Angles are those between normals, by their cosines.
struct CreaseRule {
  double strong_cosine;  // every piece has an edge as sharp
  double weak_cosine;    // every edge is as sharp
  double least_length;   // of a piece, and of a curve with a loose end
  std::size_t least_edges;
  double least_share;  // of all sharp edges: else they are noise, and folds of a scan
};

class CreaseFinder {
 public:
  CreaseFinder(const Mesh& mesh, const MeshEdges& edges, const CreaseRule& rule, Executor& executor)
      : mesh_(mesh), edges_(edges), rule_(rule), executor_(executor) {}

  /// Ascending.
  std::vector<EdgeId> run(bool must_stand_out) {
    find_normals();
    creases_ = pack_indices(executor_, edges_.size(), [&](std::size_t e) {
      return is_as_sharp(static_cast<EdgeId>(e), rule_.weak_cosine);
    });
    if (std::none_of(creases_.begin(), creases_.end(),
                     [&](EdgeId e) { return is_as_sharp(e, rule_.strong_cosine); })) {
      return {};
    }
    const double sharp = whole_length();
    judge_components(must_stand_out);
    if (whole_length() < rule_.least_share * sharp) return {};
    cut_loose_ends();
    judge_components(false);
    return std::move(creases_);
  }

 private:
  void find_normals() {
    normal_.resize(mesh_.triangle_count());
    parallel_for(executor_, normal_.size(), small_items, [&](std::size_t t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const std::vector<Vec3>& p = mesh_.positions;
      normal_[t] = normalized(cross(p[b] - p[a], p[c] - p[a]));
    });
  }

  // Of the angle between the normals on the two sides; 2 where there are not two. Triangles of
  // opposite orientation are taken as if one were turned round.
  [[nodiscard]] double cosine(EdgeId e) const {
    const std::span<const CornerId> corners = edges_.corners(e);
    if (corners.size() != 2) return 2;
    const double cosine = dot(normal_[triangle_of(corners[0])], normal_[triangle_of(corners[1])]);
    return edge_start(mesh_, corners[0]) == edge_end(mesh_, corners[1]) ? cosine : -cosine;
  }
  [[nodiscard]] bool has_area(TriangleId t) const { return dot(normal_[t], normal_[t]) > 0.5; }
  [[nodiscard]] bool is_as_sharp(EdgeId e, double limit) const {
    constexpr double rounding = 1e-9;
    return cosine(e) <= limit + rounding && has_area(triangle_of(edges_.corners(e)[0])) &&
           has_area(triangle_of(edges_.corners(e)[1]));
  }
  [[nodiscard]] double length(EdgeId e) const {
    const auto& [a, b] = edges_.ends[e];
    return norm(mesh_.positions[a] - mesh_.positions[b]);
  }

  [[nodiscard]] double whole_length() const {
    double sum = 0;
    for (const EdgeId e : creases_) sum += length(e);
    return sum;
  }

  // A connected set of creases.
  struct Component {
    double length = 0;
    std::size_t edges = 0;
    double strong = 0;  // length of those that are sharp enough to begin one
    double flat = 0;    // length of other edges at its vertices
    double bent = 0;
  };

  // Drops those that are too short or have no sharp edge; also, where they must stand out from what
  // is around, those that go on in less sharp ones everywhere, as noise does.
  void judge_components(bool must_stand_out) {
    DisjointSets sets(mesh_.vertex_count());
    std::vector<std::uint8_t> is_on_crease(mesh_.vertex_count(), 0);
    for (const EdgeId e : creases_) {
      sets.unite(edges_.ends[e][0], edges_.ends[e][1]);
      for (const VertexId v : edges_.ends[e]) is_on_crease[v] = 1;
    }
    std::vector<Component> component(mesh_.vertex_count());  // at its root
    for (const EdgeId e : creases_) {
      Component& of = component[sets.find(edges_.ends[e][0])];
      of.length += length(e);
      ++of.edges;
      if (is_as_sharp(e, rule_.strong_cosine)) of.strong += length(e);
    }
    if (must_stand_out) {
      constexpr double bent_cosine = 0.9396926207859084;  // of 20 degrees
      for (EdgeId e = 0; e < edges_.size(); ++e) {
        for (const VertexId v : edges_.ends[e]) {
          if (is_on_crease[v] == 0 || is_as_sharp(e, rule_.weak_cosine)) continue;
          Component& of = component[sets.find(v)];
          (cosine(e) <= bent_cosine ? of.bent : of.flat) += length(e);
        }
      }
    }
    std::erase_if(creases_, [&](EdgeId e) {
      const Component& of = component[sets.find(edges_.ends[e][0])];
      constexpr double sharp_share = 0.75;
      constexpr double bent_share = 0.25;
      return !(of.strong > 0) || of.length < rule_.least_length || of.edges < rule_.least_edges ||
             (must_stand_out &&
              (of.strong < sharp_share * of.length || of.bent > bent_share * (of.bent + of.flat)));
    });
  }

  void cut_loose_ends();

  const Mesh& mesh_;
  const MeshEdges& edges_;
  CreaseRule rule_;
  Executor& executor_;
  std::vector<Vec3> normal_;  // per triangle
  std::vector<EdgeId> creases_;
};

// Cuts off curves that end where nothing else is, and are too short. What that leaves may end there
// in turn.
class LooseEnds {
 public:
  LooseEnds(const Mesh& mesh, const MeshEdges& edges, const std::vector<EdgeId>& creases)
      : edges_(edges), is_boundary_(mesh.vertex_count(), 0), is_cut_(creases.size(), 0) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.corners(e).size() == 2) continue;
      for (const VertexId v : edges.ends[e]) is_boundary_[v] = 1;
    }
    for (std::uint32_t i = 0; i < creases.size(); ++i) {
      for (const VertexId v : edges.ends[creases[i]]) at_.emplace_back(v, i);
    }
    std::sort(at_.begin(), at_.end());
  }

  template <class Length>
  void cut(const std::vector<EdgeId>& creases, const CreaseRule& rule, Length&& length) {
    std::vector<VertexId> ends;
    for (const auto& [v, i] : at_) {
      if (is_loose(v)) ends.push_back(v);
    }
    while (!ends.empty()) {
      VertexId v = ends.back();
      ends.pop_back();
      if (!is_loose(v)) continue;
      std::vector<std::uint32_t> curve;
      double sum = 0;
      do {
        const std::uint32_t i = next_edge(v, curve.empty() ? no_id : curve.back());
        curve.push_back(i);
        sum += length(creases[i]);
        const auto& [a, b] = edges_.ends[creases[i]];
        v = v == a ? b : a;
      } while (degree(v) == 2 && is_short(sum, curve.size(), rule));
      if (!is_short(sum, curve.size(), rule)) continue;
      for (const std::uint32_t i : curve) is_cut_[i] = 1;
      ends.push_back(v);
    }
  }

  [[nodiscard]] bool is_cut(std::size_t i) const { return is_cut_[i] != 0; }

 private:
  static bool is_short(double length, std::size_t edges, const CreaseRule& rule) {
    return length < rule.least_length || edges < rule.least_edges;
  }

  template <class Visit>
  void for_each_at(VertexId v, Visit&& visit) const {
    auto at = std::lower_bound(at_.begin(), at_.end(), std::pair<VertexId, std::uint32_t>{v, 0});
    for (; at != at_.end() && at->first == v; ++at) {
      if (is_cut_[at->second] == 0) visit(at->second);
    }
  }
  [[nodiscard]] std::size_t degree(VertexId v) const {
    std::size_t count = 0;
    for_each_at(v, [&](std::uint32_t) { ++count; });
    return count;
  }
  [[nodiscard]] bool is_loose(VertexId v) const { return is_boundary_[v] == 0 && degree(v) == 1; }
  [[nodiscard]] std::uint32_t next_edge(VertexId v, std::uint32_t before) const {
    std::uint32_t next = no_id;
    for_each_at(v, [&](std::uint32_t i) {
      if (i != before && next == no_id) next = i;
    });
    return next;
  }

  const MeshEdges& edges_;
  std::vector<std::uint8_t> is_boundary_;               // per vertex
  std::vector<std::uint8_t> is_cut_;                    // per crease
  std::vector<std::pair<VertexId, std::uint32_t>> at_;  // a vertex, and a crease there; ascending
};

void CreaseFinder::cut_loose_ends() {
  LooseEnds ends(mesh_, edges_, creases_);
  ends.cut(creases_, rule_, [&](EdgeId e) { return length(e); });
  std::vector<EdgeId> left;
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    if (!ends.is_cut(i)) left.push_back(creases_[i]);
  }
  creases_ = std::move(left);
}

std::vector<EdgeId> find_creases(const Mesh& mesh, const MeshEdges& edges,
                                 const FeatureOptions& options, double spacing,
                                 Executor& executor) {
  if (options.creases == Creases::none) return {};
  if (options.creases == Creases::automatic) {
    const CreaseRule rule = {cosine_of_degrees(60), cosine_of_degrees(40), 6 * spacing, 6, 0.5};
    return CreaseFinder(mesh, edges, rule, executor).run(true);
  }
  if (!(options.crease_angle > 0 && options.crease_angle <= 180)) {
    throw InvalidInput("crease_angle: " + std::to_string(options.crease_angle) +
                       ": an angle is above 0 and up to 180 degrees");
  }
  const double cosine = cosine_of_degrees(options.crease_angle);
  return CreaseFinder(mesh, edges, {cosine, cosine, 2 * spacing, 1, 0}, executor).run(false);
}

void add_given_edges(const MeshEdges& edges, const FeatureOptions& options,
                     std::vector<EdgeId>& features) {
  for (const auto& [a, b] : options.edges) {
    const auto found = std::lower_bound(edges.ends.begin(), edges.ends.end(), ascending(a, b));
    if (found == edges.ends.end() || *found != ascending(a, b)) {
      throw InvalidInput("feature edge " + std::to_string(a) + " " + std::to_string(b) +
                         ": the mesh has no such edge");
    }
    features.push_back(static_cast<EdgeId>(found - edges.ends.begin()));
  }
}

void add_borders(const Mesh& mesh, const MeshEdges& edges, const FeatureOptions& options,
                 std::vector<EdgeId>& features) {
  if (options.groups.empty()) return;
  if (options.groups.size() != mesh.triangle_count()) {
    throw InvalidInput("groups: " + std::to_string(options.groups.size()) + " for " +
                       std::to_string(mesh.triangle_count()) + " triangles");
  }
  for (EdgeId e = 0; e < edges.size(); ++e) {
    const std::span<const CornerId> corners = edges.corners(e);
    if (corners.size() == 2 &&
        options.groups[triangle_of(corners[0])] != options.groups[triangle_of(corners[1])]) {
      features.push_back(e);
    }
  }
}

}  // namespace

std::vector<TrianglePair> find_features(const Mesh& mesh, const MeshEdges& edges,
                                        const FeatureOptions& options, double spacing,
                                        Executor& executor) {
  std::vector<EdgeId> features = find_creases(mesh, edges, options, spacing, executor);
  add_given_edges(edges, options, features);
  add_borders(mesh, edges, options, features);
  std::vector<TrianglePair> pairs;
  for (const EdgeId e : features) {
    const std::span<const CornerId> corners = edges.corners(e);
    if (corners.size() != 2) continue;
    pairs.push_back(ascending(triangle_of(corners[0]), triangle_of(corners[1])));
  }
  sort_and_deduplicate(pairs);
  return pairs;
}

}  // namespace geolloyd

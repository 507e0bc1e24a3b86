#include "core/surface/flips/glide_paths.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace geolloyd {
namespace {

// Of these vertices, and opposite to them; ascending.
std::vector<std::array<VertexId, 2>> edges_near(const GlidePatch& patch,
                                                const std::vector<VertexId>& vertices) {
  std::vector<std::array<VertexId, 2>> edges;
  for (const VertexId v : vertices) {
    patch.triangles().visit_around(v, [&](TriangleId t) {
      const auto& [a, b, c] = patch.triangles()[t];
      for (const auto& edge : {ascending(a, b), ascending(b, c), ascending(c, a)}) {
        edges.push_back(edge);
      }
    });
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// Of the square of excess; a vertex of the boundary has none.
int change_of(const GlidePatch& patch, VertexId v, int more) {
  const int excess = patch.excess(v);
  return patch.is_inside(v) ? more * (2 * excess + more) : 0;
}

struct PathLimits {
  std::size_t longest;     // flips
  std::size_t most_found;  // paths
};

class PathSearch {
 public:
  PathSearch(GlidePatch patch, const PathLimits& limits)
      : patch_(std::move(patch)), limits_(limits) {}

  /// Next to these vertices, from a sum of squares that is higher by `sum`.
  std::vector<FlipPath> run(const std::vector<VertexId>& moving, int sum) {
    go_on(moving, sum, limits_.longest);
    return std::move(paths_);
  }

 private:
  static constexpr std::size_t most_flips = 4000;

  // Depth first, with flips next to these vertices.
  void go_on(const std::vector<VertexId>& moving, int sum, std::size_t left) {
    for (const auto& [b, c] : edges_near(patch_, moving)) {
      if (paths_.size() >= limits_.most_found || flips_ >= most_flips) return;
      const FlippableTriangles::Side side = patch_.triangles().side_of(b, c);
      if (!patch_.can_flip(side)) continue;
      const FlippableTriangles::Quad quad = patch_.triangles().quad_of(side);
      const VertexId a = quad.a;
      const VertexId d = quad.d;
      const int change = change_of(patch_, a, 1) + change_of(patch_, d, 1) +
                         change_of(patch_, b, -1) + change_of(patch_, c, -1);
      if (change > 0 || (sum + change >= 0 && left <= 1)) continue;
      if (!diagonals_.empty() && diagonals_.back() == ascending(b, c)) continue;
      ++flips_;
      patch_.flip(side);
      path_.push_back(ascending(b, c));
      diagonals_.push_back(ascending(a, d));
      if (sum + change < 0) {
        paths_.push_back(path_);
      } else {
        go_on(irregular_of({a, d, b, c}), sum + change, left - 1);
      }
      patch_.flip(patch_.triangles().side_of(a, d));
      path_.pop_back();
      diagonals_.pop_back();
    }
  }

  [[nodiscard]] std::vector<VertexId> irregular_of(std::array<VertexId, 4> vertices) const {
    std::vector<VertexId> irregular;
    for (const VertexId v : vertices) {
      if (patch_.excess(v) != 0) irregular.push_back(v);
    }
    return irregular;
  }

  GlidePatch patch_;
  PathLimits limits_;
  FlipPath path_;
  FlipPath diagonals_;
  std::vector<FlipPath> paths_;
  std::size_t flips_ = 0;
};

std::vector<PatchChange> shortest(std::vector<PatchChange> changes, std::size_t most) {
  std::stable_sort(changes.begin(), changes.end(), [](const PatchChange& a, const PatchChange& b) {
    return a.flips.size() < b.flips.size();
  });
  if (changes.size() > most) changes.resize(most);
  return changes;
}

// Adds the change alone where that is enough, else with each path that is.
void add_with_paths(GlidePatch after, int sum, const std::vector<VertexId>& about,
                    const PatchChange& change, std::vector<PatchChange>& changes) {
  constexpr PathLimits limits = {.longest = 3, .most_found = 4};
  if (sum < 0) {
    changes.push_back(change);
    return;
  }
  PathSearch search(std::move(after), limits);
  for (FlipPath& path : search.run(about, sum)) {
    changes.push_back(change);
    changes.back().flips = std::move(path);
  }
}

// What is near several irregular vertices is changed at one of them.
bool is_turn_of_centre(const GlidePatch& patch, std::initializer_list<VertexId> vertices) {
  VertexId first = no_id;
  for (const VertexId v : vertices) {
    if (patch.excess(v) != 0) first = std::min(first, patch.vertex(v));
  }
  return first == patch.vertex(0);
}

int square(int x) {
  return x * x;
}

// Of the sum of squares.
int change_by_collapse(const GlidePatch& patch, const FlippableTriangles::Quad& quad) {
  const auto& [a, b, c, d] = quad;
  return square(patch.excess(b) + patch.excess(c) + 2) - square(patch.excess(b)) -
         square(patch.excess(c)) + change_of(patch, a, -1) + change_of(patch, d, -1);
}

int change_by_split(const GlidePatch& patch, const GlidePatch::Split& split) {
  const auto [one, other] = patch.neighbours_split(split);
  return square(one - 6) + square(other - 6) - square(patch.excess(split.vertex)) +
         change_of(patch, split.a, 1) + change_of(patch, split.d, 1);
}

// The centre and its neighbours.
std::vector<VertexId> nearest_vertices(const GlidePatch& patch) {
  std::vector<VertexId> near = {0};
  patch.triangles().visit_around(0, [&](TriangleId t) {
    for (const VertexId v : patch.triangles()[t]) near.push_back(v);
  });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

constexpr std::size_t most_changes = 8;

}  // namespace

std::vector<PatchChange> find_glide_paths(GlidePatch patch) {
  constexpr PathLimits limits = {.longest = 6, .most_found = 24};
  constexpr std::size_t most_kept = 4;
  PathSearch search(std::move(patch), limits);
  std::vector<PatchChange> changes;
  for (FlipPath& path : search.run({0}, 0)) changes.emplace_back().flips = std::move(path);
  return shortest(std::move(changes), most_kept);
}

std::vector<PatchChange> find_collapses(const GlidePatch& patch) {
  std::vector<PatchChange> changes;
  for (const auto& [b, c] : edges_near(patch, {0})) {
    const FlippableTriangles::Side side = patch.triangles().side_of(b, c);
    if (!patch.can_collapse(side)) continue;
    const FlippableTriangles::Quad quad = patch.triangles().quad_of(side);
    const int sum = change_by_collapse(patch, quad);
    if (sum > 0 || !is_turn_of_centre(patch, {quad.a, b, c, quad.d})) continue;
    GlidePatch after = patch;
    after.collapse(side);
    PatchChange change;
    change.collapse = {b, c};
    add_with_paths(std::move(after), sum, {quad.a, quad.b, quad.d}, change, changes);
  }
  return shortest(std::move(changes), most_changes);
}

std::vector<PatchChange> find_splits(const GlidePatch& patch) {
  std::vector<PatchChange> changes;
  const auto added = static_cast<VertexId>(patch.vertices().size());
  for (const VertexId v : nearest_vertices(patch)) {
    for (const GlidePatch::Split& split : patch.splits_of(v)) {
      const int sum = change_by_split(patch, split);
      if (sum > 0 || !is_turn_of_centre(patch, {v, split.a, split.d})) continue;
      GlidePatch after = patch;
      after.split(split);
      PatchChange change;
      change.split = split;
      add_with_paths(std::move(after), sum, {v, added, split.a, split.d}, change, changes);
    }
  }
  return shortest(std::move(changes), most_changes);
}

}  // namespace geolloyd

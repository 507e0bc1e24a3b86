#include "core/surface/flips/vertex_moves.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/loops.h"
#include "core/base/sorting.h"

namespace geolloyd {
namespace {

class VertexMover {
 public:
  VertexMover(GlidingRemesh& remesh, Executor& executor)
      : remesh_(remesh),
        executor_(executor),
        collapses_(remesh.positions.size()),
        splits_(remesh.positions.size()),
        is_changed_(remesh.positions.size(), 1) {}

  VertexMoves run() {
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round) {
      try_all();
      if (!pair_best()) break;
    }
    sort_and_deduplicate(moves_.moved);
    sort_and_deduplicate(moves_.changed);
    return std::move(moves_);
  }

 private:
  void try_all() {
    parallel_for(executor_, is_changed_.size(), 1,
                 [&](std::size_t v) { try_at(static_cast<VertexId>(v)); });
    is_changed_.assign(is_changed_.size(), 0);
  }

  // Anew where the patch has changed.
  void try_at(VertexId v) {
    constexpr std::size_t rings = 6;  // of a path, and what is fitted about it
    if (!remesh_.is_irregular(v)) {
      collapses_[v].reset();
      splits_[v].reset();
      return;
    }
    const GlidePatch patch(remesh_, v, rings);
    if (std::none_of(patch.vertices().begin(), patch.vertices().end(),
                     [&](VertexId w) { return is_changed_[w] != 0; })) {
      return;
    }
    collapses_[v] = best_of(patch, find_collapses(patch));
    splits_[v] = best_of(patch, find_splits(patch));
  }

  [[nodiscard]] std::optional<Glide> best_of(const GlidePatch& patch,
                                             const std::vector<PatchChange>& changes) const {
    constexpr double most = 3;  // strains of a triangle: what the other one of a pair can pay for
    std::optional<Glide> best;
    for (const PatchChange& change : changes) {
      std::optional<Glide> glide = try_glide(remesh_, patch, change, most);
      if (glide && (!best || glide->change < best->change)) best = std::move(glide);
    }
    return best;
  }

  // The best first.
  [[nodiscard]] static std::vector<const Glide*> sorted(
      const std::vector<std::optional<Glide>>& glides) {
    std::vector<const Glide*> best;
    for (const std::optional<Glide>& glide : glides) {
      if (glide) best.push_back(&*glide);
    }
    std::stable_sort(best.begin(), best.end(),
                     [](const Glide* a, const Glide* b) { return a->change < b->change; });
    return best;
  }

  // Whether there was a pair.
  bool pair_best() {
    is_taken_.assign(remesh_.triangles.size(), 0);
    const std::vector<const Glide*> splits = sorted(splits_);
    const std::size_t before = moves_.count;
    for (const Glide* collapse : sorted(collapses_)) {
      if (!is_free(*collapse)) continue;
      take(*collapse, 1);
      if (const Glide* split = find_split(*collapse, splits)) {
        take(*split, 1);
        commit(*collapse, *split);
      } else {
        take(*collapse, 0);
      }
    }
    return moves_.count > before;
  }

  [[nodiscard]] const Glide* find_split(const Glide& collapse,
                                        const std::vector<const Glide*>& splits) const {
    constexpr double least_gain = 1e-3;
    for (const Glide* split : splits) {
      if (collapse.change + split->change > -least_gain) return nullptr;
      if (collapse.fewer + split->fewer > 0 && is_free(*split)) return split;
    }
    return nullptr;
  }

  [[nodiscard]] bool is_free(const Glide& glide) const {
    return std::none_of(glide.triangles.begin(), glide.triangles.end(), [&](const auto& t) {
      return t.triangle < is_taken_.size() && is_taken_[t.triangle] != 0;
    });
  }
  void take(const Glide& glide, std::uint8_t value) {
    for (const auto& [t, corners] : glide.triangles) {
      if (t < is_taken_.size()) is_taken_[t] = value;
    }
  }

  void commit(const Glide& collapse, const Glide& split) {
    take_glide(collapse, remesh_);
    take_glide(with_ids_of(collapse, split), remesh_);
    remesh_.fit.area[collapse.gone] = split.area_at_new;
    moves_.moved.push_back(collapse.gone);
    ++moves_.count;
    mark_changed(collapse.gone);
    for (const auto& [v, position] : collapse.positions) mark_changed(v);
    for (const auto& [v, position] : split.positions) {
      if (v < is_changed_.size()) mark_changed(v);
    }
  }
  void mark_changed(VertexId v) {
    is_changed_[v] = 1;
    moves_.changed.push_back(v);
  }

  // What is new in a split gets the numbers of what is gone.
  [[nodiscard]] Glide with_ids_of(const Glide& collapse, Glide split) const {
    std::vector<TriangleId> gone;
    for (const auto& [t, corners] : collapse.triangles) {
      if (corners == FlippableTriangles::none) gone.push_back(t);
    }
    const std::size_t triangles = remesh_.triangles.size();
    const auto triangle = [&](TriangleId& t) {
      if (t >= triangles) t = gone[t - triangles];
    };
    const auto vertex = [&](VertexId& v) {
      if (v >= remesh_.positions.size()) v = collapse.gone;
    };
    for (auto& [t, corners] : split.triangles) {
      triangle(t);
      for (VertexId& v : corners) vertex(v);
    }
    for (auto& [v, position] : split.positions) vertex(v);
    for (auto& [t, sample] : split.samples) triangle(t);
    return split;
  }

  GlidingRemesh& remesh_;
  Executor& executor_;
  std::vector<std::optional<Glide>> collapses_;  // per vertex: the best near it
  std::vector<std::optional<Glide>> splits_;
  std::vector<std::uint8_t> is_changed_;  // per vertex: by the last round
  std::vector<std::uint8_t> is_taken_;    // per triangle: in this round
  VertexMoves moves_;
};

}  // namespace

VertexMoves move_vertices(GlidingRemesh& remesh, Executor& executor) {
  return VertexMover(remesh, executor).run();
}

}  // namespace geolloyd

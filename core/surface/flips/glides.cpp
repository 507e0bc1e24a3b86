#include "core/surface/flips/glides.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/loops.h"
#include "core/surface/flips/glide_trial.h"
#include "core/surface/flips/moved_labels.h"
#include "core/surface/flips/vertex_moves.h"

namespace geolloyd {
namespace {

constexpr std::size_t reach = 9;  // rings: of a path, and what is fitted about it

class Glider {
 public:
  Glider(GlidingRemesh& remesh, Executor& executor)
      : remesh_(remesh),
        executor_(executor),
        changed_(remesh_.positions.size(), 0),
        may_glide_(remesh_.positions.size(), 1) {}

  // Vertices near which nothing has changed since they were tried are not tried again.
  // A batch is tried at once; it is small where patches would overlap.
  std::size_t sweep() {
    constexpr std::size_t vertices_per_trial = 2048;
    const std::size_t batch = std::max<std::size_t>(1, changed_.size() / vertices_per_trial);
    const std::vector<VertexId> irregular = irregular_vertices();
    std::size_t glides = 0;
    for (std::size_t begin = 0; begin < irregular.size(); begin += batch) {
      const std::size_t count = std::min(batch, irregular.size() - begin);
      std::vector<Attempt> attempts(count);
      parallel_for(executor_, count, 1,
                   [&](std::size_t i) { attempts[i] = attempt(irregular[begin + i]); });
      for (std::size_t i = 0; i < count; ++i) {
        if (is_outdated(attempts[i])) attempts[i] = attempt(irregular[begin + i]);
        may_glide_[irregular[begin + i]] = 0;
        if (!attempts[i].glide) continue;
        commit(attempts[i]);
        ++glides;
      }
      for (const VertexId v : touched_) changed_[v] = 0;
      touched_.clear();
    }
    return glides;
  }

  void look_again_at(std::span<const VertexId> vertices) {
    for (const VertexId v : vertices) may_glide_[v] = 1;
  }

 private:
  struct Attempt {
    std::optional<Glide> glide;
    std::vector<VertexId> seen;
  };

  [[nodiscard]] std::vector<VertexId> irregular_vertices() const {
    std::vector<VertexId> irregular;
    for (VertexId v = 0; v < remesh_.positions.size(); ++v) {
      if (may_glide_[v] != 0 && remesh_.is_irregular(v)) irregular.push_back(v);
    }
    return irregular;
  }

  [[nodiscard]] Attempt attempt(VertexId v) const {
    Attempt attempt;
    attempt.seen = {v};
    if (!remesh_.is_irregular(v)) return attempt;
    const GlidePatch patch(remesh_, v, reach);
    attempt.seen.assign(patch.vertices().begin(), patch.vertices().end());
    for (const PatchChange& path : find_glide_paths(patch)) {
      attempt.glide = try_glide(remesh_, patch, path);
      if (attempt.glide) break;
    }
    return attempt;
  }

  [[nodiscard]] bool is_outdated(const Attempt& attempt) const {
    return std::any_of(attempt.seen.begin(), attempt.seen.end(),
                       [&](VertexId v) { return changed_[v] != 0; });
  }

  void commit(const Attempt& attempt) {
    take_glide(*attempt.glide, remesh_);
    for (const auto& [v, position] : attempt.glide->positions) {
      changed_[v] = 1;
      touched_.push_back(v);
    }
    look_again_at(attempt.seen);
  }

  GlidingRemesh& remesh_;
  Executor& executor_;
  std::vector<std::uint8_t> changed_;    // per vertex: in this batch
  std::vector<std::uint8_t> may_glide_;  // per vertex
  std::vector<VertexId> touched_;
};

}  // namespace

std::size_t glide_irregular(const SurfaceInput& input, std::vector<RegionId>& labels,
                            std::size_t held, std::span<const std::array<VertexId, 2>> kept,
                            std::span<const std::uint8_t> barred, Mesh& remesh,
                            Executor& executor) {
  if (remesh.triangles.empty()) return 0;
  GlidingRemesh gliding(input, labels, held, kept, barred, remesh, executor);
  Glider glider(gliding, executor);
  std::size_t glides = glider.sweep();
  const VertexMoves moves = move_vertices(gliding, executor);
  relabel_moved(input.fine, gliding, moves.moved, labels);
  glider.look_again_at(moves.changed);
  glides += moves.count + glider.sweep();
  if (glides == 0) return 0;
  remesh.triangles = gliding.triangles.triangles();
  for (std::size_t v = held; v < remesh.vertex_count(); ++v) {
    const Vec3& position = gliding.positions[v];
    if (position != input.frame.to_unit(remesh.positions[v])) {
      remesh.positions[v] = input.frame.to_mesh(position);
    }
  }
  return glides;
}

}  // namespace geolloyd

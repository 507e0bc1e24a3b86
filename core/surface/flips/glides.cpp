#include "core/surface/flips/glides.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/loops.h"
#include "core/surface/flips/glide_trial.h"

namespace geolloyd {
namespace {

constexpr std::size_t reach = 9;  // rings: of a path, and what is fitted about it

class Glider {
 public:
  Glider(GlidingRemesh remesh, Executor& executor, const std::function<bool()>& keep_going)
      : remesh_(std::move(remesh)),
        executor_(executor),
        keep_going_(keep_going),
        changed_(remesh_.positions.size(), 0) {}

  // A batch is tried at once; it is small where patches would overlap.
  std::size_t run() {
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
        if (!attempts[i].glide) continue;
        commit(*attempts[i].glide);
        ++glides;
      }
      for (const VertexId v : touched_) changed_[v] = 0;
      touched_.clear();
      if (keep_going_ && !keep_going_()) break;
    }
    return glides;
  }

  [[nodiscard]] const GlidingRemesh& remesh() const { return remesh_; }

 private:
  struct Attempt {
    std::optional<Glide> glide;
    std::vector<VertexId> seen;
  };

  [[nodiscard]] std::vector<VertexId> irregular_vertices() const {
    std::vector<VertexId> irregular;
    for (VertexId v = 0; v < remesh_.positions.size(); ++v) {
      if (is_irregular(v)) irregular.push_back(v);
    }
    return irregular;
  }
  [[nodiscard]] bool is_irregular(VertexId v) const {
    return remesh_.triangles.is_inside(v) && remesh_.triangles.count_around(v) != 6;
  }

  [[nodiscard]] Attempt attempt(VertexId v) const {
    Attempt attempt;
    attempt.seen = {v};
    if (!is_irregular(v)) return attempt;
    const GlidePatch patch(remesh_, v, reach);
    attempt.seen.assign(patch.vertices().begin(), patch.vertices().end());
    for (const FlipPath& path : find_glide_paths(patch)) {
      attempt.glide = try_glide(remesh_, patch, path);
      if (attempt.glide) break;
    }
    return attempt;
  }

  [[nodiscard]] bool is_outdated(const Attempt& attempt) const {
    return std::any_of(attempt.seen.begin(), attempt.seen.end(),
                       [&](VertexId v) { return changed_[v] != 0; });
  }

  void commit(const Glide& glide) {
    for (const FlippableTriangles::Side& side : glide.flips) remesh_.triangles.flip(side);
    for (const auto& [v, position] : glide.positions) {
      remesh_.positions[v] = position;
      changed_[v] = 1;
      touched_.push_back(v);
    }
    for (const TriangleId t : glide.triangles) remesh_.on_triangle[t].clear();
    for (const auto& [t, sample] : glide.samples) remesh_.on_triangle[t].push_back(sample);
  }

  GlidingRemesh remesh_;
  Executor& executor_;
  const std::function<bool()>& keep_going_;
  std::vector<std::uint8_t> changed_;  // per vertex: in this batch
  std::vector<VertexId> touched_;
};

}  // namespace

std::size_t glide_irregular(const SurfaceInput& input, std::span<const RegionId> labels,
                            std::size_t held, std::span<const std::array<VertexId, 2>> kept,
                            std::span<const std::uint8_t> barred, Mesh& remesh, Executor& executor,
                            const std::function<bool()>& keep_going) {
  if (remesh.triangles.empty()) return 0;
  Glider glider(GlidingRemesh(input, labels, held, kept, barred, remesh, executor), executor,
                keep_going);
  const std::size_t glides = glider.run();
  if (glides == 0) return 0;
  remesh.triangles = glider.remesh().triangles.triangles();
  for (std::size_t v = held; v < remesh.vertex_count(); ++v) {
    const Vec3& position = glider.remesh().positions[v];
    if (position != input.frame.to_unit(remesh.positions[v])) {
      remesh.positions[v] = input.frame.to_mesh(position);
    }
  }
  return glides;
}

}  // namespace geolloyd

#include "core/surface/flips/moved_labels.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/sorting.h"

namespace geolloyd {
namespace {

class Relabeller {
 public:
  Relabeller(const FineMesh& fine, const GlidingRemesh& remesh, std::vector<RegionId>& labels)
      : fine_(fine), remesh_(remesh), labels_(labels), cells_(remesh.positions.size()) {}

  void run(std::span<const VertexId> moved) {
    spread_over(moved);
    for (VertexId p = 0; p < labels_.size(); ++p) {
      if (labels_[p] != no_id) cells_[labels_[p]].push_back(p);
    }
    for (const VertexId v : moved) take_nearest(v);
  }

 private:
  // From all sides, a ring at a time.
  void spread_over(std::span<const VertexId> moved) {
    std::vector<VertexId> open;
    for (VertexId p = 0; p < labels_.size(); ++p) {
      if (std::binary_search(moved.begin(), moved.end(), labels_[p])) open.push_back(p);
    }
    for (const VertexId p : open) labels_[p] = no_id;
    for (std::size_t left = open.size() + 1; open.size() < left;) {
      left = open.size();
      std::vector<std::pair<VertexId, RegionId>> found;
      found.reserve(open.size());
      for (const VertexId p : open) found.emplace_back(p, label_next_to(p));
      for (const auto& [p, label] : found) labels_[p] = label;
      std::erase_if(open, [&](VertexId p) { return labels_[p] != no_id; });
    }
  }

  [[nodiscard]] RegionId label_next_to(VertexId p) const {
    for (const VertexId near : fine_.neighbours(p)) {
      if (labels_[near] != no_id) return labels_[near];
    }
    return no_id;
  }

  void take_nearest(VertexId v) {
    VertexId nearest = no_id;
    for (const VertexId near : neighbours_of(v)) {
      for (const VertexId p : std::vector<VertexId>(cells_[near])) {
        if (cells_[near].size() < 2) break;
        if (nearest == no_id || square_distance(p, v) < square_distance(nearest, v)) nearest = p;
        const bool is_of_curve = near < remesh_.fit.on_curves;
        if (!is_of_curve && square_distance(p, v) < square_distance(p, near)) give(p, v);
      }
    }
    if (cells_[v].empty() && nearest != no_id) give(nearest, v);
  }

  [[nodiscard]] std::vector<VertexId> neighbours_of(VertexId v) const {
    std::vector<VertexId> near;
    remesh_.triangles.visit_around(v, [&](TriangleId t) {
      const Triangle& corners = remesh_.triangles[t];
      std::copy_if(corners.begin(), corners.end(), std::back_inserter(near),
                   [&](VertexId corner) { return corner != v; });
    });
    sort_and_deduplicate(near);
    return near;
  }

  void give(VertexId p, VertexId v) {
    std::erase(cells_[labels_[p]], p);
    cells_[v].push_back(p);
    labels_[p] = v;
  }

  [[nodiscard]] double square_distance(VertexId p, VertexId v) const {
    const Vec3 away = fine_.positions[p] - remesh_.positions[v];
    return dot(away, away);
  }

  const FineMesh& fine_;
  const GlidingRemesh& remesh_;
  std::vector<RegionId>& labels_;
  std::vector<std::vector<VertexId>> cells_;  // per vertex of the remesh
};

}  // namespace

void relabel_moved(const FineMesh& fine, const GlidingRemesh& remesh,
                   std::span<const VertexId> moved, std::vector<RegionId>& labels) {
  if (!moved.empty()) Relabeller(fine, remesh, labels).run(moved);
}

}  // namespace geolloyd

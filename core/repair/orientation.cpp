#include "core/repair/orientation.h"

#include <array>
#include <utility>

#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

class Orienter {
 public:
  explicit Orienter(Mesh& mesh)
      : mesh_(mesh), edges_(find_edges(mesh)), is_turned_(mesh.triangle_count(), unseen) {}

  void run(Repairs& repairs) {
    if (!has_disagreement()) return;
    find_edges_of_triangles();
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      if (is_turned_[t] != unseen) continue;
      flood(t);
      if (!disagrees_) continue;
      if (is_twisted_) {
        ++repairs.unorientable_components;
        continue;
      }
      const std::uint8_t turned = is_better_turned() ? 0 : 1;  // by these marks
      for (const TriangleId u : part_) {
        if (is_turned_[u] != turned) continue;
        std::swap(mesh_.triangles[u][1], mesh_.triangles[u][2]);
        ++repairs.triangles_turned;
      }
    }
  }

 private:
  static constexpr std::uint8_t unseen = 2;

  [[nodiscard]] bool disagree(std::size_t edge) const {
    const auto corners = edges_.corners(edge);
    return corners.size() == 2 && edge_start(mesh_, corners[0]) == edge_start(mesh_, corners[1]);
  }
  [[nodiscard]] bool has_disagreement() const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (disagree(e)) return true;
    }
    return false;
  }
  void find_edges_of_triangles() {
    edge_.resize(3 * mesh_.triangle_count());
    disagrees_at_.resize(edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      for (const CornerId c : edges_.corners(e)) edge_[c] = e;
      disagrees_at_[e] = disagree(e) ? 1 : 0;
    }
  }

  // Which triangles of the component of `first` must be turned to agree with it.
  void flood(TriangleId first) {
    part_ = {first};
    is_turned_[first] = 0;
    disagrees_ = is_twisted_ = false;
    is_closed_ = true;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      const TriangleId t = part_[i];
      for (CornerId c = 3 * t; c < 3 * t + 3; ++c) {
        const auto corners = edges_.corners(edge_[c]);
        if (corners.size() != 2) {
          is_closed_ = false;
          continue;
        }
        const TriangleId u = triangle_of(corners[0] == c ? corners[1] : corners[0]);
        const std::uint8_t differs = disagrees_at_[edge_[c]];
        disagrees_ = disagrees_ || differs != 0;
        const auto wanted = static_cast<std::uint8_t>(is_turned_[t] ^ differs);
        if (is_turned_[u] == unseen) {
          is_turned_[u] = wanted;
          part_.push_back(u);
        } else if (is_turned_[u] != wanted) {
          is_twisted_ = true;
        }
      }
    }
  }

  // Whether the orientation opposite to the first triangle's is better.
  [[nodiscard]] bool is_better_turned() const {
    const Vec3& o = mesh_.positions[mesh_.triangles[part_.front()][0]];
    double volume = 0;
    double area = 0;  // of those that agree, less that of the others
    double whole = 0;
    for (const TriangleId t : part_) {
      const double sign = is_turned_[t] != 0 ? -1 : 1;
      const auto& [a, b, c] = mesh_.triangles[t];
      const double six_fold =
          dot(mesh_.positions[a] - o, cross(mesh_.positions[b] - o, mesh_.positions[c] - o));
      volume += sign * six_fold;
      whole += six_fold > 0 ? six_fold : -six_fold;
      area += sign * triangle_area(mesh_, mesh_.triangles[t]);
    }
    constexpr double rounding = 1e-9;
    if (is_closed_ && (volume > rounding * whole || volume < -rounding * whole)) return volume < 0;
    return area < 0;
  }

  Mesh& mesh_;
  MeshEdges edges_;
  std::vector<std::uint32_t> edge_;         // opposite to a corner
  std::vector<std::uint8_t> disagrees_at_;  // per edge, before any triangle was turned
  std::vector<std::uint8_t> is_turned_;     // per triangle, relative to the first of its component
  std::vector<TriangleId> part_;
  bool disagrees_ = false;
  bool is_twisted_ = false;
  bool is_closed_ = true;
};

}  // namespace

void orient(Mesh& mesh, Repairs& repairs) {
  Orienter(mesh).run(repairs);
}

}  // namespace geolloyd

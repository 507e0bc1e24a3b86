#include "core/repair/plain_stars.h"

#include <algorithm>
#include <span>

#include "core/base/loops.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/exact_signs.h"

namespace geolloyd {
namespace {

// The edges opposite to a vertex in its triangles, in the order of each.
class Star {
 public:
  Star(const Mesh& mesh, std::span<const CornerId> corners)
      : mesh_(mesh), corners_(corners), at_(mesh.positions[apex(mesh, corners.front())]) {}

  [[nodiscard]] bool is_plain() const {
    const Projection view(axis());
    const int turn = turn_of(corners_.front(), view);
    if (turn == 0) return false;
    std::size_t around = 0;  // how many triangles there are in one direction, so in each
    for (const CornerId c : corners_) {
      if (turn_of(c, view) != turn) return false;
      around += has_first_direction(c, turn, view) ? 1 : 0;
    }
    return around == 1 && is_closed();
  }

 private:
  [[nodiscard]] const Vec3& start(CornerId c) const {
    return mesh_.positions[edge_start(mesh_, c)];
  }
  [[nodiscard]] const Vec3& end(CornerId c) const { return mesh_.positions[edge_end(mesh_, c)]; }

  [[nodiscard]] int axis() const {
    Vec3 normal = Vec3::Zero();
    for (const CornerId c : corners_) normal += cross(start(c) - at_, end(c) - at_);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return axis;
  }
  [[nodiscard]] int turn_of(CornerId c, const Projection& view) const {
    return view.orientation(at_, start(c), end(c));
  }

  // Whether the way along the first axis begins within the triangle or on the one side of it that
  // comes first. Its corner is less than half a turn.
  [[nodiscard]] bool has_first_direction(CornerId c, int turn, const Projection& view) const {
    const auto [x, y] = view(at_);
    const Point2 first = view(turn > 0 ? start(c) : end(c));
    const Point2 last = view(turn > 0 ? end(c) : start(c));
    return (first[1] < y || (first[1] == y && first[0] > x)) && last[1] > y;
  }

  // Whether each edge at the vertex has a triangle on either side of it.
  [[nodiscard]] bool is_closed() const {
    const auto sorted = [&](auto&& vertex_of) {
      std::vector<VertexId> found;
      found.reserve(corners_.size());
      for (const CornerId c : corners_) found.push_back(vertex_of(mesh_, c));
      std::sort(found.begin(), found.end());
      return found;
    };
    const std::vector<VertexId> starts = sorted(edge_start);
    return std::adjacent_find(starts.begin(), starts.end()) == starts.end() &&
           starts == sorted(edge_end);
  }

  const Mesh& mesh_;
  std::span<const CornerId> corners_;
  const Vec3& at_;
};

}  // namespace

std::vector<std::uint8_t> find_plain_stars(const Mesh& mesh, Executor& executor) {
  const Bucketed<CornerId> corners = corners_at_vertices(mesh, executor);
  std::vector<std::uint8_t> is_plain(mesh.vertex_count(), 0);
  parallel_for(executor, is_plain.size(), small_items, [&](std::size_t v) {
    if (!corners[v].empty()) is_plain[v] = Star(mesh, corners[v]).is_plain() ? 1 : 0;
  });
  return is_plain;
}

}  // namespace geolloyd

#include "core/seeds/nearest_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <unordered_set>

namespace geolloyd {
namespace {

// What nanoflann wants to see of the points, and of what it finds; the names are its own.
// NOLINTBEGIN(readability-identifier-naming)
struct Points {
  const std::vector<Vec3>& positions;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return positions.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return positions[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

// The nearest node, of several the one with the smallest input id.
class Nearest {
 public:
  using DistanceType = double;
  using IndexType = NodeId;

  explicit Nearest(const std::vector<InputId>& input_id) : input_id_(input_id) {}

  [[nodiscard]] NodeId node() const { return node_; }
  [[nodiscard]] double squared_distance() const { return squared_distance_; }

  [[nodiscard]] std::size_t size() const { return node_ == no_id ? 0 : 1; }
  [[nodiscard]] bool full() const { return true; }
  // Points nearer than this are added: those as near as the nearest, too.
  [[nodiscard]] double worstDist() const {
    return std::nextafter(squared_distance_, std::numeric_limits<double>::infinity());
  }
  bool addPoint(double squared_distance, NodeId node) {
    if (node_ == no_id || squared_distance < squared_distance_ ||
        (squared_distance == squared_distance_ && input_id_[node] < input_id_[node_])) {
      node_ = node;
      squared_distance_ = squared_distance;
    }
    return true;
  }

 private:
  const std::vector<InputId>& input_id_;
  NodeId node_ = no_id;
  double squared_distance_ = std::numeric_limits<double>::infinity();
};
// NOLINTEND(readability-identifier-naming)

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                 Points, 3, NodeId>;

}  // namespace

NearestNodes nearest_nodes(const MeshGraph& mesh_graph, std::span<const Vec3> positions) {
  const Points points{mesh_graph.position};
  const Tree tree(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  NearestNodes found;
  std::unordered_set<NodeId> taken;
  double farthest = 0;
  for (const Vec3& position : positions) {
    Nearest nearest(mesh_graph.input_id);
    tree.findNeighbors(nearest, position.data(), nanoflann::SearchParams());
    farthest = std::max(farthest, nearest.squared_distance());
    if (taken.insert(nearest.node()).second) {
      found.nodes.push_back(nearest.node());
    } else {
      ++found.fit.left_out;
    }
  }
  found.fit.farthest = std::sqrt(farthest);
  return found;
}

}  // namespace geolloyd

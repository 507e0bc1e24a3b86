#include "core/surface/creases/close_chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/mesh/mesh_measure.h"
#include "core/surface/features/degrees.h"

namespace geolloyd {
namespace {

using ChainId = std::uint32_t;

class CloseChains {
 public:
  CloseChains(const EdgeAngles& angles, double width, const std::vector<CreaseChain>& chains)
      : angles_(angles), width_(width), chains_(chains), is_dropped_(chains.size(), 0) {
    for (ChainId c = 0; c < chains.size(); ++c) {
      for (const EdgeId e : chains[c]) {
        for (const VertexId v : angles.edges().ends[e]) at_.push_back({v, c, e});
      }
    }
    std::sort(at_.begin(), at_.end(), [](const ChainEdge& a, const ChainEdge& b) {
      return std::pair(a.vertex, a.edge) < std::pair(b.vertex, b.edge);
    });
  }

  // Shorter chains go first, so that the longest of a bundle stays.
  void run() {
    std::vector<double> length(chains_.size());
    for (ChainId c = 0; c < chains_.size(); ++c) {
      for (const EdgeId e : chains_[c]) length[c] += angles_.length(e);
    }
    std::vector<ChainId> order(chains_.size());
    std::iota(order.begin(), order.end(), ChainId{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](ChainId a, ChainId b) { return length[a] < length[b]; });
    constexpr double close_share = 0.75;
    for (const ChainId c : order) {
      is_dropped_[c] = close_length(c) >= close_share * length[c] ? 1 : 0;
    }
  }

  [[nodiscard]] bool is_dropped(std::size_t c) const { return is_dropped_[c] != 0; }

 private:
  // An edge of a chain, at one of its ends.
  struct ChainEdge {
    VertexId vertex;
    ChainId chain;
    EdgeId edge;
  };

  // Of the edges that turn little and have a narrow triangle to an edge of another chain at one
  // side.
  [[nodiscard]] double close_length(ChainId c) const {
    constexpr double strong_cosine = cosine_of_degrees(75);
    double sum = 0;
    for (const EdgeId e : chains_[c]) {
      const std::span<const CornerId> corners = angles_.edges().corners(e);
      if (!angles_.is_as_sharp(e, strong_cosine) &&
          std::any_of(corners.begin(), corners.end(),
                      [&](CornerId corner) { return is_narrow(corner, c, e); })) {
        sum += angles_.length(e);
      }
    }
    return sum;
  }

  [[nodiscard]] bool is_narrow(CornerId corner, ChainId c, EdgeId e) const {
    const Mesh& mesh = angles_.mesh();
    const double area = triangle_area(mesh, mesh.triangles[triangle_of(corner)]);
    return 2 * area < width_ * angles_.length(e) && has_parallel(apex(mesh, corner), c, e);
  }

  [[nodiscard]] bool has_parallel(VertexId v, ChainId c, EdgeId e) const {
    constexpr double parallel_cosine = 0.9;
    const auto first = std::lower_bound(
        at_.begin(), at_.end(), v, [](const ChainEdge& a, VertexId b) { return a.vertex < b; });
    for (auto at = first; at != at_.end() && at->vertex == v; ++at) {
      if (at->chain == c || is_dropped_[at->chain] != 0) continue;
      if (std::abs(dot(direction(at->edge), direction(e))) >= parallel_cosine) return true;
    }
    return false;
  }

  [[nodiscard]] Vec3 direction(EdgeId e) const {
    const auto& [a, b] = angles_.edges().ends[e];
    return normalized(angles_.mesh().positions[b] - angles_.mesh().positions[a]);
  }

  const EdgeAngles& angles_;
  double width_;
  const std::vector<CreaseChain>& chains_;
  std::vector<std::uint8_t> is_dropped_;  // per chain
  std::vector<ChainEdge> at_;             // by vertex
};

}  // namespace

void drop_close_chains(const EdgeAngles& angles, double width, std::vector<CreaseChain>& chains) {
  CloseChains close(angles, width, chains);
  close.run();
  std::vector<CreaseChain> left;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (!close.is_dropped(c)) left.push_back(std::move(chains[c]));
  }
  chains = std::move(left);
}

}  // namespace geolloyd

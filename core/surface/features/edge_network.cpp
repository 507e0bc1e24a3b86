#include "core/surface/features/edge_network.h"

#include <algorithm>
#include <utility>

#include "core/base/sorting.h"

namespace geolloyd {

EdgeNetwork::EdgeNetwork(std::vector<Edge> edges, std::vector<VertexId> fixed)
    : ends_(std::move(edges)), fixed_(std::move(fixed)) {
  const std::size_t count = ends_.size();
  for (std::size_t i = 0; i < count; ++i) ends_.push_back({ends_[i][1], ends_[i][0]});
  std::sort(ends_.begin(), ends_.end());
  is_done_.assign(ends_.size(), 0);
}

std::size_t EdgeNetwork::degree(VertexId v) const {
  std::size_t count = 0;
  for (std::size_t i = first_at(v); i < ends_.size() && ends_[i][0] == v; ++i) ++count;
  return count;
}

bool EdgeNetwork::is_node(VertexId v) const {
  return degree(v) != 2 || std::binary_search(fixed_.begin(), fixed_.end(), v);
}

std::vector<VertexId> EdgeNetwork::nodes() const {
  std::vector<VertexId> nodes = fixed_;
  for (const Edge& e : ends_) {
    if (is_node(e[0])) nodes.push_back(e[0]);
  }
  sort_and_deduplicate(nodes);
  return nodes;
}

std::vector<std::vector<VertexId>> EdgeNetwork::take_paths() {
  std::vector<std::vector<VertexId>> paths;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    if (is_done_[i] == 0 && is_node(ends_[i][0])) paths.push_back(walk(i));
  }
  return paths;
}

std::vector<std::vector<VertexId>> EdgeNetwork::take_loops() {
  std::vector<std::vector<VertexId>> loops;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    if (is_done_[i] != 0) continue;
    loops.push_back(walk(i));
    loops.back().pop_back();
  }
  return loops;
}

std::size_t EdgeNetwork::first_at(VertexId v) const {
  return static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), Edge{v, 0}) -
                                  ends_.begin());
}

// To the next node, or around.
std::vector<VertexId> EdgeNetwork::walk(std::size_t at) {
  const VertexId start = ends_[at][0];
  std::vector<VertexId> path = {start};
  while (true) {
    const auto [from, to] = ends_[at];
    take(from, to);
    path.push_back(to);
    if (to == start || is_node(to)) return path;
    const std::size_t first = first_at(to);
    at = ends_[first][1] != from ? first : first + 1;
  }
}

void EdgeNetwork::take(VertexId a, VertexId b) {
  for (const Edge& e : {Edge{a, b}, Edge{b, a}}) {
    is_done_[static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), e) -
                                      ends_.begin())] = 1;
  }
}

}  // namespace geolloyd

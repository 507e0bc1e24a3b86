#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace geolloyd {

/// Edges of boundary and features as a graph, which falls into paths between nodes and loops. A
/// node is a vertex where other than two edges meet, or that is fixed.
class EdgeNetwork {
 public:
  using Edge = std::array<VertexId, 2>;

  /// `fixed` is ascending.
  EdgeNetwork(std::vector<Edge> edges, std::vector<VertexId> fixed);

  [[nodiscard]] bool is_node(VertexId v) const;
  /// Ascending.
  [[nodiscard]] std::vector<VertexId> nodes() const;

  /// From node to node; each once.
  std::vector<std::vector<VertexId>> take_paths();
  /// What is left: each begins at its smallest vertex and goes toward the smaller of its
  /// neighbours.
  std::vector<std::vector<VertexId>> take_loops();

 private:
  [[nodiscard]] std::size_t degree(VertexId v) const;
  [[nodiscard]] std::size_t first_at(VertexId v) const;
  std::vector<VertexId> walk(std::size_t at);
  void take(VertexId a, VertexId b);

  std::vector<Edge> ends_;  // both directions; ascending
  std::vector<VertexId> fixed_;
  std::vector<std::uint8_t> is_done_;
};

}  // namespace geolloyd

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "bench/support/bench_mesh.h"
#include "bench/support/rested_surface.h"
#include "core/graph/components.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/engine.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_check.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// Some seeds and what the sequential functions find for them, certified (check_partition.h).
struct Solved {
  std::vector<NodeId> seeds;
  Partition partition;
  std::vector<NodeId> settled;  ///< all nodes, ascending by key
  std::vector<Score> score;     ///< per region
};

/// How a macrostep ends.
struct Rest {
  std::vector<NodeId> seeds;
  std::vector<Microstep> microsteps;

  friend bool operator==(const Rest&, const Rest&) = default;
};

Rest macrostep(Engine& engine, std::vector<NodeId> seeds);
std::uint64_t count_visits(const std::vector<Microstep>& microsteps);

/// How a relaxation ends.
struct Relaxed {
  std::uint64_t fingerprint;
  std::vector<NodeId> seeds;
  std::size_t steps;
  std::uint64_t node_visits;

  friend bool operator==(const Relaxed&, const Relaxed&) = default;
};

Relaxed summarise(const Relaxation& relaxation);

/// Made when first asked for, and only the last one kept, so that memory stays bounded.
template <class Value, class Key = std::monostate>
class Kept {
 public:
  template <class Make>
  const Value& get(const Key& key, Make&& make) {
    if (!value_ || key_ != key) {
      value_.reset();
      value_.emplace(make());
      key_ = key;
    }
    return *value_;
  }

 private:
  std::optional<Value> value_;
  Key key_{};
};

/// What benchmarks of one mesh start from, and what their results must be: made by core's
/// sequential functions, and verified when made (std::runtime_error where it is wrong). References
/// live until the same is asked for with another argument.
class Inputs {
 public:
  explicit Inputs(BenchMesh mesh) : source_(std::move(mesh)) {}

  [[nodiscard]] const BenchMesh& source() const { return source_; }
  const Mesh& mesh();
  const MeshEdges& edges();
  const MeshFacts& facts();
  const MeshGraph& mesh_graph(GraphKind kind);
  /// The vertex graph, on which everything below is.
  const Graph& graph() { return mesh_graph(GraphKind::vertex).graph; }
  const Components& components();
  /// Of so many seeds, at random by area.
  const Solved& solved(std::size_t seeds);
  /// Of the same seeds, each moved by one arc, to a place from which it can go back.
  const Solved& moved(std::size_t seeds);
  const Rest& rest(std::size_t seeds);
  const Relaxed& relaxed(std::size_t seeds);
  /// For so many sites.
  const RestedSurface& surface(std::size_t sites);
  const Remesh& surface_remesh(std::size_t sites);

 private:
  BenchMesh source_;
  Kept<Mesh> mesh_;
  Kept<MeshEdges> edges_;
  Kept<MeshFacts> facts_;
  Kept<MeshGraph, GraphKind> graph_;
  Kept<Components> components_;
  Kept<Solved, std::size_t> solved_;
  Kept<Solved, std::size_t> moved_;
  Kept<Rest, std::size_t> rest_;
  Kept<Relaxed, std::size_t> relaxed_;
  Kept<RestedSurface, std::size_t> surface_;
  Kept<Remesh, std::size_t> surface_remesh_;
};

/// Those of the mesh last asked for are kept, others are not.
Inputs& inputs_of(const BenchMesh& mesh);

}  // namespace geolloyd

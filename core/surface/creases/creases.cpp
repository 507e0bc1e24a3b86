#include "core/surface/creases/creases.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/packing.h"
#include "core/base/sorting.h"
#include "core/surface/creases/close_chains.h"
#include "core/surface/creases/edge_angles.h"
#include "core/surface/creases/flat_sides.h"
#include "core/surface/creases/loose_ends.h"
#include "core/surface/features/degrees.h"
#include "core/surface/features/edge_network.h"
#include "core/surface/features/small_features.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// What is asked of creases.
struct CreaseRule {
  double cosine;            // of the angle between normals, from which on an edge is sharp
  double least_length;      // of a piece, and of a curve with a loose end; mesh units
  std::size_t least_edges;  // of either
  double least_closed;      // length of a piece without a loose end
  bool needs_flat_side;
};

class CreaseFinder {
 public:
  CreaseFinder(const EdgeAngles& angles, const CreaseRule& rule, double spacing, Executor& executor)
      : angles_(angles), rule_(rule), spacing_(spacing), executor_(executor) {}

  /// Ascending.
  std::vector<EdgeId> run() {
    creases_ = pack_indices(executor_, angles_.edges().size(), [&](std::size_t e) {
      return angles_.is_as_sharp(static_cast<EdgeId>(e), rule_.cosine);
    });
    if (rule_.needs_flat_side) {
      const std::vector<EdgeId> sharp = creases_;
      const FlatSides sides(angles_, sharp, spacing_);
      find_edges_of_planes(sides);
      judge_components();  // of a scan's sharp edges hardly any are left to be looked at
      judge_chains(sides);
    }
    judge_components();
    cut_loose_ends(
        angles_, [&](EdgeId e) { return extent(e); },
        [&](const CurveExtent& curve) { return is_short(curve, rule_.least_length); }, creases_);
    if (rule_.needs_flat_side) cut_bent_tails(angles_, spacing_ / 2, creases_);
    judge_components();
    return std::move(creases_);
  }

 private:
  [[nodiscard]] bool is_short(const CurveExtent& curve, double least_length) const {
    return curve.length < least_length || curve.edges < rule_.least_edges;
  }

  // Long edges between planes, as of a box of few triangles.
  void find_edges_of_planes(const FlatSides& sides) {
    is_of_planes_.assign(angles_.edges().size(), 0);
    parallel_for(executor_, creases_.size(), 64, [&](std::size_t i) {
      is_of_planes_[creases_[i]] = sides.has_planes(creases_[i]) ? 1 : 0;
    });
  }

  // A long edge between planes is as much evidence as many edges, and longer ones.
  [[nodiscard]] CurveExtent extent(EdgeId e) const {
    const double length = angles_.length(e);
    if (is_of_planes_.empty() || is_of_planes_[e] == 0) return {length, 1};
    return {3 * length, few};
  }

  // Keeps chains with a flat side nearly everywhere that stand out from what is around; of those
  // along a narrow strip one.
  void judge_chains(const FlatSides& sides) {
    if (creases_.empty()) return;
    std::vector<CreaseChain> chains = find_chains();
    find_bends();
    std::vector<std::uint8_t> is_flat(chains.size());
    parallel_for(executor_, chains.size(), 8, [&](std::size_t c) {
      is_flat[c] = is_beside_flat(sides, chains[c]) && stands_out(chains[c]);
    });
    std::vector<CreaseChain> flat;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      if (is_flat[c] != 0) {
        flat.push_back(std::move(chains[c]));
      } else {
        rejected_.insert(rejected_.end(), chains[c].begin(), chains[c].end());
      }
    }
    constexpr double narrow = 0.25;
    drop_close_chains(angles_, narrow * spacing_, flat);
    creases_.clear();
    for (const CreaseChain& chain : flat) {
      creases_.insert(creases_.end(), chain.begin(), chain.end());
    }
    std::sort(creases_.begin(), creases_.end());
  }

  // From one junction of sharp edges to the next.
  [[nodiscard]] std::vector<CreaseChain> find_chains() const {
    const auto& ends = angles_.edges().ends;
    std::vector<EdgeNetwork::Edge> edges;
    edges.reserve(creases_.size());
    for (const EdgeId e : creases_) edges.push_back(ends[e]);
    EdgeNetwork network(std::move(edges), {});
    std::vector<CreaseChain> chains;
    const auto add = [&](const std::vector<VertexId>& vertices, std::size_t count) {
      CreaseChain& chain = chains.emplace_back();
      for (std::size_t i = 0; i < count; ++i) {
        const auto edge = ascending(vertices[i], vertices[(i + 1) % vertices.size()]);
        const auto at = std::lower_bound(ends.begin(), ends.end(), edge);
        chain.push_back(static_cast<EdgeId>(at - ends.begin()));
      }
    };
    for (const auto& path : network.take_paths()) add(path, path.size() - 1);
    for (const auto& loop : network.take_loops()) add(loop, loop.size());
    return chains;
  }

  // Edges at a vertex that are not sharp.
  struct Bends {
    std::uint32_t bent = 0;  // by 20 degrees and more
    std::uint32_t flat = 0;
  };

  void find_bends() {
    const auto& ends = angles_.edges().ends;
    bends_.assign(angles_.mesh().vertex_count(), {});
    std::vector<std::uint8_t> is_on_crease(angles_.mesh().vertex_count(), 0);
    for (const EdgeId e : creases_) {
      for (const VertexId v : ends[e]) is_on_crease[v] = 1;
    }
    constexpr double bent_cosine = cosine_of_degrees(20);
    for (EdgeId e = 0; e < ends.size(); ++e) {
      if (is_on_crease[ends[e][0]] == 0 && is_on_crease[ends[e][1]] == 0) continue;
      if (angles_.is_as_sharp(e, rule_.cosine)) continue;
      const bool is_bent = angles_.is_as_sharp(e, bent_cosine);
      for (const VertexId v : ends[e]) {
        ++(is_bent ? bends_[v].bent : bends_[v].flat);
      }
    }
  }

  // In noise many of the other edges are bent as well.
  [[nodiscard]] bool stands_out(const CreaseChain& chain) const {
    std::size_t bent = 0;
    std::size_t flat = 0;
    for (const EdgeId e : chain) {
      for (const VertexId v : angles_.edges().ends[e]) {
        bent += bends_[v].bent;
        flat += bends_[v].flat;
      }
    }
    return 2 * bent <= flat;
  }

  [[nodiscard]] bool is_beside_flat(const FlatSides& sides, const CreaseChain& chain) const {
    constexpr double flat_share = 0.75;
    double length = 0;
    double flat = 0;
    for (const EdgeId e : chain) {
      length += angles_.length(e);
      if (is_of_planes_[e] != 0 || sides.has_enough(e)) flat += angles_.length(e);
    }
    return flat >= flat_share * length;
  }

  // A connected set of creases.
  struct Component {
    CurveExtent extent;
    std::size_t loose_ends = 0;
    std::size_t rejected = 0;  // ends of sharp edges that are no creases, at its vertices
  };

  // Drops those that are too short, and those that chance makes of noise: many sharp edges at them
  // are no creases, or any are at a small one.
  void judge_components() {
    const auto& ends = angles_.edges().ends;
    const std::size_t vertices = angles_.mesh().vertex_count();
    DisjointSets sets(vertices);
    std::vector<std::uint32_t> degree(vertices, 0);
    for (const EdgeId e : creases_) {
      sets.unite(ends[e][0], ends[e][1]);
      for (const VertexId v : ends[e]) ++degree[v];
    }
    std::vector<Component> component(vertices);  // at its root
    for (const EdgeId e : creases_) {
      Component& of = component[sets.find(ends[e][0])];
      of.extent.add(extent(e));
      for (const VertexId v : ends[e]) of.loose_ends += degree[v] == 1 ? 1 : 0;
    }
    for (const EdgeId e : rejected_) {
      for (const VertexId v : ends[e]) {
        if (degree[v] > 0) ++component[sets.find(v)].rejected;
      }
    }
    std::erase_if(creases_, [&](EdgeId e) {
      const Component& of = component[sets.find(ends[e][0])];
      const double least = of.loose_ends > 0 ? rule_.least_length : rule_.least_closed;
      const std::size_t most_rejected = of.extent.edges < few ? 0 : of.extent.edges / 2;
      return is_short(of.extent, least) || of.rejected > most_rejected;
    });
  }

  static constexpr std::size_t few = 16;  // edges

  const EdgeAngles& angles_;
  CreaseRule rule_;
  double spacing_;
  Executor& executor_;
  std::vector<EdgeId> creases_;
  std::vector<EdgeId> rejected_;            // sharp, but no creases
  std::vector<std::uint8_t> is_of_planes_;  // per edge; empty where no side matters
  std::vector<Bends> bends_;                // per vertex, of those on creases
};

std::vector<EdgeId> find_creases(const Mesh& mesh, const MeshEdges& edges,
                                 const FeatureOptions& options, double spacing,
                                 Executor& executor) {
  if (options.creases == Creases::none) return {};
  const bool is_automatic = options.creases == Creases::automatic;
  const double angle = is_automatic ? 40 : options.crease_angle;
  if (!(angle > 0 && angle <= 180)) {
    throw InvalidInput("crease_angle: " + std::to_string(angle) +
                       ": an angle is above 0 and up to 180 degrees");
  }
  const double least = (is_automatic ? 6 : 2) * spacing;
  const bool keeps_loops = is_automatic && options.small;
  const CreaseRule rule = {cosine_of_degrees(angle), least,
                           is_automatic ? std::size_t{6} : std::size_t{1},
                           keeps_loops ? shortest_kept_loop * spacing : least, is_automatic};
  return CreaseFinder(EdgeAngles(mesh, edges, executor), rule, spacing, executor).run();
}

void add_given_edges(const MeshEdges& edges, const FeatureOptions& options,
                     std::vector<EdgeId>& features) {
  for (const auto& [a, b] : options.edges) {
    const auto found = std::lower_bound(edges.ends.begin(), edges.ends.end(), ascending(a, b));
    if (found == edges.ends.end() || *found != ascending(a, b)) {
      throw InvalidInput("feature edge " + std::to_string(a) + " " + std::to_string(b) +
                         ": the mesh has no such edge");
    }
    features.push_back(static_cast<EdgeId>(found - edges.ends.begin()));
  }
}

void add_borders(const Mesh& mesh, const MeshEdges& edges, const FeatureOptions& options,
                 std::vector<EdgeId>& features) {
  if (options.groups.empty()) return;
  if (options.groups.size() != mesh.triangle_count()) {
    throw InvalidInput("groups: " + std::to_string(options.groups.size()) + " for " +
                       std::to_string(mesh.triangle_count()) + " triangles");
  }
  for (EdgeId e = 0; e < edges.size(); ++e) {
    const std::span<const CornerId> corners = edges.corners(e);
    if (corners.size() == 2 &&
        options.groups[triangle_of(corners[0])] != options.groups[triangle_of(corners[1])]) {
      features.push_back(e);
    }
  }
}

}  // namespace

std::vector<TrianglePair> find_features(const Mesh& mesh, const MeshEdges& edges,
                                        const FeatureOptions& options, double spacing,
                                        Executor& executor) {
  std::vector<EdgeId> features = find_creases(mesh, edges, options, spacing, executor);
  add_given_edges(edges, options, features);
  add_borders(mesh, edges, options, features);
  std::vector<TrianglePair> pairs;
  for (const EdgeId e : features) {
    const std::span<const CornerId> corners = edges.corners(e);
    if (corners.size() != 2) continue;
    pairs.push_back(ascending(triangle_of(corners[0]), triangle_of(corners[1])));
  }
  sort_and_deduplicate(pairs);
  return pairs;
}

}  // namespace geolloyd

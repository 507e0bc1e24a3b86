#include "core/graph/mesh_arcs.h"

#include <algorithm>
#include <span>
#include <vector>

#include "core/base/huge_pages.h"
#include "core/base/loops.h"
#include "core/base/packing.h"
#include "core/fields/metric_mean.h"
#include "core/fields/tangent_plane.h"
#include "core/graph/geodesic_shortcuts.h"
#include "core/mesh/connectivity.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// An end of an arc that is measured.
struct ArcEnd {
  NodeId node;
  Vec3 position;
  const TangentSpace* space;  // null in the isotropic metric
};

struct Measure {
  Norm norm;
  Averaging averaging;
};

Measure measure_of(const MeshGraphOptions& options) {
  const Averaging averaging = options.averaging.value_or(suggested_averaging(options.norm));
  if (averaging == Averaging::metric && options.norm != Norm::geodesic) {
    throw InvalidInput("only the geodesic norm averages tangent spaces as metrics");
  }
  return {options.norm, averaging};
}

// Length of a way from a to b whose isotropic length is known: its displacement is taken as the
// chord's direction with that length. A way between two places that coincide in space (a closed
// fold) has no direction, and keeps its isotropic length.
double length_in_metric(const ArcEnd& a, const ArcEnd& b, double isotropic, const Measure& by) {
  const bool in_field = a.space != nullptr && b.space != nullptr;
  if (!in_field && by.norm == Norm::geodesic) return isotropic;
  const Vec3 chord = b.position - a.position;
  const double chord_length = norm(chord);
  if (chord_length == 0) return isotropic;
  const Vec3 displacement = chord * (isotropic / chord_length);
  return in_field ? measure(displacement, average(*a.space, *b.space, by.averaging), by.norm)
                  : measure(displacement, by.norm);
}

double straight_length(const ArcEnd& a, const ArcEnd& b, const Measure& by) {
  return length_in_metric(a, b, norm(b.position - a.position), by);
}

// Pairs of `count` things.
std::uint64_t pairs(std::uint64_t count) {
  return count * (count - 1) / 2;
}

// Straight ways cross the edges of two triangles.
std::uint64_t pairs_across(std::span<const CornerId> corners, GraphKind kind) {
  return kind == GraphKind::vertex_far && corners.size() == 2 ? 0 : pairs(corners.size());
}

bool measures_in_triangles(GraphKind kind) {
  return has_triangles(kind) || kind == GraphKind::vertex_far;
}

// A space that leans out of the triangle would measure less than there is.
TangentSpace turned_into_triangle(const Mesh& mesh, TriangleId triangle,
                                  const TangentSpace& space) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vec3& place = mesh.positions[a];
  const Vec3 normal = normalized(cross(mesh.positions[b] - place, mesh.positions[c] - place));
  if (normal == Vec3::Zero() || !has_plane(space)) return space;
  const Vec3 other = normalized(cross(space.tangent, space.bitangent));
  const Vec3 from = dot(other, normal) < 0 ? Vec3(-other) : other;
  return {transported(space.tangent, from, normal), transported(space.bitangent, from, normal),
          space.tangent_magnitude, space.bitangent_magnitude};
}

// How many straight ways there are, from those of some vertices: to find them all takes as long as
// to make the graph.
std::uint64_t estimate_ways(const GeodesicShortcuts& ways, std::size_t vertices,
                            Executor& executor) {
  constexpr std::size_t step = 16;
  constexpr std::size_t grain = 256;
  return step *
         parallel_reduce<std::uint64_t>(executor, (vertices + step - 1) / step, grain,
                                        [&](std::size_t begin, std::size_t end) {
                                          std::uint64_t count = 0;
                                          for (std::size_t i = begin; i < end; ++i) {
                                            ways.visit(static_cast<VertexId>(step * i),
                                                       [&](const GeodesicShortcut&) { ++count; });
                                          }
                                          return count;
                                        });
}

class ArcBuilder {
 public:
  ArcBuilder(Executor& executor, const Mesh& mesh, const MeshEdges& edges,
             const MeshGraphOptions& options, const MeshGraph& target)
      : executor_(executor),
        mesh_(mesh),
        edges_(edges),
        options_(options),
        measure_(measure_of(options)),
        target_(target) {
    if (measures_in_triangles(options.kind) && !options.vertex_space.empty()) {
      triangle_space_.resize(mesh.triangle_count());
      parallel_for(executor, mesh.triangle_count(), small_items, [&](std::size_t t) {
        const TangentSpace space =
            triangle_space(mesh.triangles[t], options.vertex_space, measure_.averaging);
        triangle_space_[t] = options.kind == GraphKind::vertex_far
                                 ? turned_into_triangle(mesh, static_cast<TriangleId>(t), space)
                                 : space;
      });
    }
  }

  // Many triangles at one edge or vertex make arcs by the square of their number: the arcs are
  // counted before any memory is taken.
  Buffer<UndirectedArc> build() {
    const GraphKind kind = options_.kind;
    if (kind == GraphKind::triangle_dense) find_fans();
    if (kind == GraphKind::vertex_far) find_ways();
    const Packing along(executor_, has_vertices(kind) ? edges_.size() : 0,
                        [](std::size_t) { return std::uint64_t{1}; });
    const Packing across(
        executor_, kind != GraphKind::vertex ? edges_.size() : 0,
        [this](std::size_t e) { return pairs_across(edges_.corners(e), options_.kind); });
    const Packing fans(executor_, fan_pairs_.size(),
                       [this](std::size_t v) { return std::uint64_t{fan_pairs_[v]}; });
    const Packing spokes(executor_, kind == GraphKind::mixed ? mesh_.triangle_count() : 0,
                         [this](std::size_t t) {
                           return std::uint64_t{has_three_vertices(mesh_.triangles[t]) ? 3U : 0U};
                         });
    const std::uint64_t count =
        along.total() + across.total() + fans.total() + spokes.total() + ways_count_;
    check_arc_count(count);

    Buffer<UndirectedArc> arcs(count);
    UndirectedArc* first = arcs.data();
    along.for_each(executor_, [&](std::size_t e, std::uint64_t i) { put_along(e, first + i); });
    first += along.total();
    across.for_each(executor_, [&](std::size_t e, std::uint64_t i) { put_across(e, first + i); });
    first += across.total();
    fans.for_each(executor_, [&](std::size_t v, std::uint64_t i) { put_fan(v, first + i); });
    first += fans.total();
    spokes.for_each(executor_, [&](std::size_t t, std::uint64_t i) { put_spokes(t, first + i); });
    first += spokes.total();
    put_ways(first);
    return arcs;
  }

 private:
  // In the graphs of triangles a vertex has a place but no node.
  [[nodiscard]] ArcEnd vertex(VertexId v) const {
    return {has_vertices(options_.kind) ? target_.node_of[v] : no_id, mesh_.positions[v],
            options_.vertex_space.empty() ? nullptr : &options_.vertex_space[v]};
  }

  [[nodiscard]] NodeId triangle_node(TriangleId t) const {
    return target_.node_of[target_.first_triangle_id + t];
  }

  [[nodiscard]] ArcEnd triangle(TriangleId t) const {
    const NodeId node = triangle_node(t);
    return {node, target_.position[node], triangle_space_.empty() ? nullptr : &triangle_space_[t]};
  }

  void put_along(std::size_t edge, UndirectedArc* arc) const {
    const ArcEnd a = vertex(edges_.ends[edge][0]);
    const ArcEnd b = vertex(edges_.ends[edge][1]);
    *arc = {a.node, b.node, straight_length(a, b, measure_)};
  }

  // The other end of a way across the edge opposite to a corner.
  [[nodiscard]] ArcEnd beyond(CornerId corner) const {
    return has_triangles(options_.kind) ? triangle(triangle_of(corner))
                                        : vertex(apex(mesh_, corner));
  }

  void put_across(std::size_t edge, UndirectedArc* arc) const {
    const auto corners = edges_.corners(edge);
    const Vec3& e0 = mesh_.positions[edges_.ends[edge][0]];
    const Vec3& e1 = mesh_.positions[edges_.ends[edge][1]];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ArcEnd a = beyond(corners[i]);
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        const ArcEnd b = beyond(corners[j]);
        const double isotropic = unfolded_distance(a.position, b.position, e0, e1);
        double length = length_in_metric(a, b, isotropic, measure_);
        if (legs_.size() > 0) length = std::min(length, length_by_ends(corners[i], corners[j]));
        *arc++ = {a.node, b.node, length};
      }
    }
  }

  // The shorter way from triangle to triangle by an end of the edge that is opposite to both
  // corners.
  [[nodiscard]] double length_by_ends(CornerId a, CornerId b) const {
    const bool is_turned = edge_start(mesh_, a) == edge_start(mesh_, b);
    const CornerId at_start = is_turned ? corner_at_start(b) : corner_at_end(b);
    const CornerId at_end = is_turned ? corner_at_end(b) : corner_at_start(b);
    return std::min(legs_[corner_at_start(a)] + legs_[at_start],
                    legs_[corner_at_end(a)] + legs_[at_end]);
  }

  [[nodiscard]] double leg(CornerId corner) const {
    return straight_length(triangle(triangle_of(corner)), vertex(apex(mesh_, corner)), measure_);
  }

  void find_fans() {
    fans_ = corners_at_vertices(mesh_, executor_);
    check_arc_count(count_arcs(mesh_, edges_, options_.kind, executor_));
    legs_ = Buffer<double>(3 * mesh_.triangle_count());
    parallel_for(executor_, mesh_.triangle_count(), small_items, [this](std::size_t t) {
      for_each_corner(mesh_, t, [this](CornerId corner) { legs_[corner] = leg(corner); });
    });
    fan_pairs_ = huge_vector<std::uint32_t>(fans_.size());
    parallel_for(executor_, fans_.size(), small_items, [this](std::size_t v) {
      for_pairs(fans_[v], [&](CornerId, CornerId) { ++fan_pairs_[v]; });
    });
  }

  // Calls visit(earlier, corner) for all pairs of a fan, but for those whose triangles have an edge
  // in common: their arc goes across it, or by its ends where that is shorter.
  template <class Visit>
  void for_pairs(std::span<const CornerId> fan, Visit&& visit) const {
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const VertexId start = edge_start(mesh_, fan[i]);
      const VertexId end = edge_end(mesh_, fan[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const VertexId other_start = edge_start(mesh_, fan[j]);
        const VertexId other_end = edge_end(mesh_, fan[j]);
        if (start != other_start && start != other_end && end != other_start && end != other_end) {
          visit(fan[j], fan[i]);
        }
      }
    }
  }

  // All triangles at a vertex to each other, by way of it.
  void put_fan(std::size_t v, UndirectedArc* arc) const {
    for_pairs(fans_[v], [&](CornerId a, CornerId b) {
      *arc++ = {triangle_node(triangle_of(a)), triangle_node(triangle_of(b)), legs_[a] + legs_[b]};
    });
  }

  void put_spokes(std::size_t t, UndirectedArc* arc) const {
    for_each_corner(mesh_, t, [&](CornerId corner) {
      *arc++ = {triangle_node(triangle_of(corner)), target_.node_of[apex(mesh_, corner)],
                leg(corner)};
    });
  }

  // Found once: that takes longer than to copy them.
  void find_ways() {
    constexpr std::size_t grain = 256;
    const GeodesicShortcuts ways(mesh_, edges_, executor_);
    check_arc_count(estimate_ways(ways, mesh_.vertex_count(), executor_));
    ways_.resize((mesh_.vertex_count() + grain - 1) / grain);
    std::vector<std::vector<UndirectedArc>> found(executor_.threads());
    parallel_for_ranges(
        executor_, mesh_.vertex_count(), grain,
        [&](std::size_t begin, std::size_t end, std::size_t worker) {
          found[worker].clear();
          for (std::size_t v = begin; v < end; ++v) {
            ways.visit(static_cast<VertexId>(v), [&](const GeodesicShortcut& way) {
              found[worker].push_back(
                  {target_.node_of[way.from], target_.node_of[way.to], length_of_way(ways, way)});
            });
          }
          ways_[begin / grain] = found[worker];
        });
    for (const std::vector<UndirectedArc>& some : ways_) ways_count_ += some.size();
  }

  void put_ways(UndirectedArc* arc) {
    constexpr std::size_t grain = 4;
    std::vector<UndirectedArc*> place;
    place.reserve(ways_.size());
    for (const std::vector<UndirectedArc>& some : ways_) {
      place.push_back(arc);
      arc += some.size();
    }
    parallel_for(executor_, ways_.size(), grain, [&](std::size_t i) {
      std::copy(ways_[i].begin(), ways_[i].end(), place[i]);
      ways_[i] = {};
    });
  }

  // The sum over the triangles on the way, each in its own space.
  [[nodiscard]] double length_of_way(const GeodesicShortcuts& ways,
                                     const GeodesicShortcut& way) const {
    if (triangle_space_.empty() && measure_.norm == Norm::geodesic) return way.length;
    double sum = 0;
    ways.visit_pieces(way, [&](const StraightPiece& piece) {
      sum += triangle_space_.empty()
                 ? measure(piece.displacement, measure_.norm)
                 : measure(piece.displacement, triangle_space_[piece.triangle], measure_.norm);
    });
    return sum;
  }

  Executor& executor_;
  const Mesh& mesh_;
  const MeshEdges& edges_;
  const MeshGraphOptions& options_;
  Measure measure_;
  const MeshGraph& target_;
  std::vector<TangentSpace> triangle_space_;
  // Of triangle_dense:
  Bucketed<CornerId> fans_;                       // corners at each vertex
  std::vector<std::uint32_t> fan_pairs_;          // per vertex: that get an arc there
  Buffer<double> legs_;                           // per corner: from the barycentre to there
  std::vector<std::vector<UndirectedArc>> ways_;  // of vertex_far, by ranges of vertices
  std::uint64_t ways_count_ = 0;
};

}  // namespace

std::uint64_t count_arcs(const Mesh& mesh, const MeshEdges& edges, GraphKind kind,
                         Executor& executor) {
  std::uint64_t arcs = has_vertices(kind) ? edges.size() : 0;
  for (std::size_t e = 0; kind != GraphKind::vertex && e < edges.size(); ++e) {
    arcs += pairs_across(edges.corners(e), kind);
  }
  if (kind == GraphKind::vertex_far) {
    arcs += estimate_ways(GeodesicShortcuts(mesh, edges, executor), mesh.vertex_count(), executor);
  }
  if (kind == GraphKind::mixed) arcs += edges.corner.size();
  if (kind == GraphKind::triangle_dense) {
    std::vector<std::uint32_t> fan(mesh.vertex_count(), 0);
    for (const CornerId corner : edges.corner) ++fan[apex(mesh, corner)];
    for (const std::uint32_t triangles : fan) arcs += pairs(triangles);
  }
  return arcs;
}

Buffer<UndirectedArc> find_arcs(const Mesh& mesh, const MeshEdges& edges,
                                const MeshGraphOptions& options, const MeshGraph& numbered,
                                Executor& executor) {
  return ArcBuilder(executor, mesh, edges, options, numbered).build();
}

}  // namespace geolloyd

#include "core/course/remesh_warnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/base/loops.h"
#include "core/base/packing.h"
#include "core/mesh/mesh_measure.h"
#include "core/seams/places.h"
#include "core/seams/stitching.h"
#include "core/surface/creases/edge_angles.h"

namespace geolloyd {
namespace {

// What is bad begins beyond these.
constexpr double most_vertices_share = 1.05;  // of those asked for
constexpr double most_volume_error = 0.02;
constexpr double most_way_off = 0.03;        // of the diagonal
constexpr double most_distance_left = 0.9;   // after the fit, of that before
constexpr double least_distance = 0.02;      // before the fit, of the spacing: else all is well
constexpr double least_sharp_share = 2.5;    // length of sharp edges, of the root of the area
constexpr double least_sharp_spacings = 20;  // and of the spacing

std::string whole(double number) {
  return std::to_string(static_cast<long long>(std::floor(number + 0.5)));
}

std::string percent(double share) {
  const auto tenths = static_cast<long long>(std::floor(1000 * std::abs(share) + 0.5));
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

std::string counted_as(std::size_t count, const char* singular, const char* plural) {
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

// Those at the boundary alone can be split.
std::size_t count_split_vertices(const Mesh& mesh, const MeshEdges& edges) {
  Mesh boundary;
  std::vector<std::uint8_t> is_on_boundary(mesh.vertex_count(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.corners(e).size() != 1) continue;
    for (const VertexId v : edges.ends[e]) {
      if (is_on_boundary[v] == 0) boundary.positions.push_back(mesh.positions[v]);
      is_on_boundary[v] = 1;
    }
  }
  const std::vector<VertexId> place = places_of(boundary);
  const auto moved = [](const std::vector<VertexId>& name) {
    std::size_t count = 0;
    for (VertexId v = 0; v < name.size(); ++v) count += name[v] != v ? 1 : 0;
    return count;
  };
  return moved(place) == 0 ? 0 : moved(find_split_vertices(mesh));
}

bool is_closed_and_oriented(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  if (!edges.duplicates.empty()) return false;
  const auto open = parallel_reduce<std::size_t>(
      executor, edges.size(), small_items, [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t e = begin; e < end; ++e) {
          const auto corners = edges.corners(e);
          const bool is_whole =
              corners.size() == 2 && edge_start(mesh, corners[0]) != edge_start(mesh, corners[1]);
          count += is_whole ? 0 : 1;
        }
        return count;
      });
  return open == 0;
}

// Of those between two triangles that lie in one plane with another neighbour: so it is along the
// edges of solids, and seldom in folds and noise of scans.
double length_of_sharp_edges(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  constexpr double sharp_cosine = 0.5;              // of 60 degrees
  constexpr double flat_cosine = 0.99619469809174;  // of 5 degrees
  const EdgeAngles angles(mesh, edges, executor);
  std::vector<std::uint8_t> is_flat(mesh.triangle_count(), 0);
  const auto sharp = pack_indices(executor, edges.size(), [&](std::size_t e) {
    const std::optional<double> cosine = angles.cosine(static_cast<EdgeId>(e));
    if (cosine && *cosine >= flat_cosine) {
      for (const CornerId c : edges.corners(e)) {
        relaxed_store(is_flat[triangle_of(c)], std::uint8_t{1});
      }
    }
    return cosine && *cosine <= sharp_cosine;
  });
  double length = 0;
  for (const EdgeId e : sharp) {
    const std::span<const CornerId> corners = edges.corners(e);
    const bool is_between_flat = std::all_of(
        corners.begin(), corners.end(), [&](CornerId c) { return is_flat[triangle_of(c)] != 0; });
    if (is_between_flat) length += angles.length(e);
  }
  return length;
}

class Judge {
 public:
  Judge(const Mesh& mesh, const InputSigns& signs, const RemeshOptions& options,
        const Remesh& remesh)
      : mesh_(mesh), signs_(signs), options_(options), remesh_(remesh) {}

  std::vector<RemeshWarning> run() {
    judge_vertices();
    judge_topology();
    judge_volume();
    judge_fit();
    judge_features();
    judge_split_vertices();
    judge_small_parts();
    judge_limit();
    judge_self_intersections();
    return std::move(found_);
  }

 private:
  void warn(RemeshFlaw flaw, std::string text) { found_.push_back({flaw, std::move(text)}); }

  // Of a triangle of the remesh, on average.
  [[nodiscard]] double triangle_area() const {
    return signs_.area /
           static_cast<double>(std::max<std::size_t>(1, remesh_.mesh.triangle_count()));
  }
  // The side of such a triangle.
  [[nodiscard]] double spacing() const { return std::sqrt(4 / std::sqrt(3.0) * triangle_area()); }

  void judge_vertices() {
    const auto count = static_cast<double>(remesh_.mesh.vertex_count());
    const auto asked = static_cast<double>(remesh_.vertices_asked_for);
    if (!(count > most_vertices_share * asked)) return;
    warn(RemeshFlaw::vertices, whole(count) + " vertices, " + percent(count / asked - 1) +
                                   " more than the " + whole(asked) +
                                   " asked for: the input's topology and corners take them");
  }

  void judge_topology() {
    if (remesh_.has_input_topology()) return;
    warn(RemeshFlaw::topology, remesh_.is_manifold()
                                   ? "the remesh has not the topology of the input"
                                   : "the remesh is no manifold");
  }

  void judge_volume() {
    const std::optional<double> error = volume_error(mesh_, signs_.is_closed, remesh_);
    if (!error || !(std::abs(*error) > most_volume_error)) return;
    warn(RemeshFlaw::volume, "the volume inside is " + percent(*error) +
                                 (*error < 0 ? " less" : " more") +
                                 " than the input's: more vertices would keep it");
  }

  void judge_fit() {
    const double before = remesh_.distance_before_fit;
    const double after = remesh_.distance_after_fit;
    if (!(before > least_distance * spacing()) || !(after > most_distance_left * before)) return;
    const std::string little =
        remesh_.vertices_fitted == 0
            ? "moved nothing"
            : "brought the remesh only " + percent(1 - after / before) + " closer to the input";
    warn(RemeshFlaw::fit, "the fit " + little + ": closer would make bad triangles");
  }

  void judge_features() {
    if (remesh_.creases_left_out) {
      warn(RemeshFlaw::features,
           "sharp edges lie so close that they would take several times the vertices asked for, so "
           "none are kept: more vertices would keep them");
      return;
    }
    const bool is_asked = options_.features.creases == Creases::automatic;
    const double length = signs_.sharp_length / spacing();
    const bool is_long = signs_.sharp_length > least_sharp_share * std::sqrt(signs_.area) &&
                         length > least_sharp_spacings;
    if (!is_asked || !remesh_.feature_edges.empty() || !is_long) return;
    warn(RemeshFlaw::features,
         "no sharp edges are kept, though the input has some as long as " + whole(length) +
             " edges of the remesh: where they are meant to be, --features 40 keeps them");
  }

  void judge_split_vertices() {
    if (signs_.split_vertices == 0) return;
    warn(RemeshFlaw::split_vertices,
         counted_as(signs_.split_vertices, "vertex of the input is", "vertices of the input are") +
             " in the places of others, and the surface is not joined there: weld them");
  }

  void judge_small_parts() {
    const std::size_t small = remesh_.small_parts;
    if (small == 0) return;
    warn(RemeshFlaw::small_parts,
         counted_as(small, "part of the input is", "parts of the input are") +
             " smaller than a triangle of the remesh, so the shape is lost");
  }

  void judge_limit() {
    if (remesh_.small_features_limited) {
      warn(RemeshFlaw::limit,
           "holes and walls smaller than an edge would take more than a third of the vertices, so "
           "some lose their shape: more vertices would keep it");
    }
    if (!remesh_.was_cut_short) return;
    warn(RemeshFlaw::limit,
         "the input was not cut as finely as the remesh needs, for that would have taken too many "
         "vertices: it has needles, which --repair may remove");
  }

  void judge_self_intersections() {
    const std::size_t pairs = remesh_.self_intersections.size();
    if (pairs == 0 || signs_.has_self_intersections) return;
    warn(
        RemeshFlaw::self_intersections,
        counted_as(pairs, "pair of triangles crosses", "pairs of triangles cross") +
            ", and none of the input's do: more vertices would part them, and --issues names them");
  }

  const Mesh& mesh_;
  const InputSigns& signs_;
  const RemeshOptions& options_;
  const Remesh& remesh_;
  std::vector<RemeshWarning> found_;
};

}  // namespace

std::string_view name_of(RemeshFlaw flaw) {
  static constexpr std::array<std::string_view, 10> names = {
      "vertices", "topology",       "volume",      "distance", "fit",
      "features", "split_vertices", "small_parts", "limit",    "self_intersections"};
  return names[static_cast<std::size_t>(flaw)];
}

std::optional<double> volume_error(const Mesh& mesh, bool is_closed, const Remesh& remesh) {
  if (!is_closed || !remesh.is_manifold() || remesh.topology.total().boundary_loops > 0) {
    return std::nullopt;
  }
  const double volume = enclosed_volume(mesh);
  if (volume == 0) return std::nullopt;
  return enclosed_volume(remesh.mesh) / volume - 1;
}

InputSigns find_signs(const Mesh& mesh, const MeshEdges& edges, Executor& executor) {
  InputSigns signs;
  for (const double a : triangle_areas(mesh, edges.duplicates, executor)) signs.area += a;
  signs.is_closed = is_closed_and_oriented(mesh, edges, executor);
  if (!signs.is_closed) signs.split_vertices = count_split_vertices(mesh, edges);
  signs.sharp_length = length_of_sharp_edges(mesh, edges, executor);
  return signs;
}

std::vector<RemeshWarning> find_warnings(const Mesh& mesh, const InputSigns& signs,
                                         const RemeshOptions& options, const Remesh& remesh) {
  return Judge(mesh, signs, options, remesh).run();
}

void warn_of_distance(double largest, double diagonal, Remesh& remesh) {
  if (!(largest > most_way_off * diagonal)) return;
  remesh.warnings.push_back(
      {RemeshFlaw::distance, "the input is up to " + percent(largest / diagonal) +
                                 " of its diagonal away from the remesh: more vertices would keep "
                                 "what is lost there"});
}

}  // namespace geolloyd

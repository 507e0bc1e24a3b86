#include "tools/render/painters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/base/random.h"
#include "core/voronoi/subtree.h"
#include "tools/render/shown_regions.h"

namespace geolloyd {
namespace {

constexpr Colour clay = {214, 210, 202};
constexpr Colour black = {20, 20, 24};
constexpr Colour white = {255, 255, 255};
constexpr Colour blue = {31, 90, 170};
constexpr Colour orange = {220, 105, 15};

constexpr double edge_half_width = 0.45;
constexpr double border_half_width = 0.6;
constexpr double least_branch_area = 20;  // square pixels of surface reached by an arc
constexpr double field_half_width = 1;

Stroke disc(const Vec3& centre, double radius) {
  return {centre, centre, radius};
}

// Coverage of the edges of the scene's mesh at a sample; no wider than a share of the triangle, so
// that fine meshes are not painted over.
double edge_coverage(const Scene& scene, std::size_t sample,
                     std::span<const std::uint8_t> is_hidden) {
  const RayHit& hit = scene.hit[sample];
  const Triangle& t = scene.mesh.triangles[hit.triangle];
  const std::array<double, 3> weight = {1.0 - hit.u - hit.v, hit.u, hit.v};
  const auto flat = [&](std::size_t c) -> Eigen::Vector2d {
    return scene.mesh.positions[t[c]].head<2>();
  };
  const Eigen::Vector2d ab = flat(1) - flat(0);
  const Eigen::Vector2d ac = flat(2) - flat(0);
  const double twice_area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  const std::array<double, 3> opposite = {(ac - ab).norm(), ac.norm(), ab.norm()};
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!is_hidden.empty() && is_hidden[std::size_t{3} * hit.triangle + c] != 0) continue;
    const double height = twice_area / std::max(opposite[c], 1e-12);
    const double half_width = std::min(edge_half_width, 0.08 * height);
    const double room = (half_width - weight[c] * height) * SampleGrid::per_side + 0.5;
    const double thinned = half_width / edge_half_width;
    most = std::max(most, std::clamp(room, 0.0, 1.0) * std::max(thinned, 0.25));
  }
  return most;
}

// Dots on the lines between samples of different regions; together they make lines.
std::vector<Stroke> borders(const Scene& scene, std::span<const RegionId> shown) {
  std::vector<Stroke> strokes;
  const SampleGrid& grid = scene.grid;
  const auto add = [&](int column, int row, int dx, int dy) {
    const std::size_t here = grid.index(column, row);
    const std::size_t there = grid.index(column + dx, row + dy);
    if (shown[here] == shown[there]) return;
    if (scene.hit[here].triangle == no_id || scene.hit[there].triangle == no_id) return;
    strokes.push_back(disc({SampleGrid::place(column) + dx * 0.5 / SampleGrid::per_side,
                            SampleGrid::place(row) + dy * 0.5 / SampleGrid::per_side,
                            std::min(scene.hit[here].z, scene.hit[there].z)},
                           border_half_width));
  };
  for (int row = 0; row + 1 < grid.rows(); ++row) {
    for (int column = 0; column + 1 < grid.columns(); ++column) {
      add(column, row, 1, 0);
      add(column, row, 0, 1);
    }
  }
  return strokes;
}

// For the dots of seeds: a share of the mean radius of the regions that are seen, within limits.
double dot_radius(std::span<const RegionId> shown, std::size_t region_count) {
  std::vector<bool> is_seen(region_count, false);
  std::size_t samples = 0;
  for (const RegionId region : shown) {
    if (region == no_id) continue;
    ++samples;
    is_seen[region] = true;
  }
  const auto seen =
      std::max<double>(1, static_cast<double>(std::count(is_seen.begin(), is_seen.end(), true)));
  const double radius = std::sqrt(static_cast<double>(samples) / seen / std::numbers::pi);
  return std::clamp(0.13 * radius / SampleGrid::per_side, 1.0, 6.0);
}

Canvas paint_shown(const Scene& scene, std::span<const RegionId> shown,
                   std::span<const Colour> colour, double paleness, Executor& executor) {
  Canvas canvas = paint(scene, executor, [&](std::size_t i) {
    const Colour& own = shown[i] == no_id ? no_colour : colour[shown[i]];
    return blend(own, white, paleness);
  });
  draw(borders(scene, shown), {black, 0.75}, scene, canvas, executor);
  return canvas;
}

bool is_visible(const Scene& scene, const Vec3& p) {
  const int column = static_cast<int>(std::floor(p.x() * SampleGrid::per_side));
  const int row = static_cast<int>(std::floor(p.y() * SampleGrid::per_side));
  if (column < 0 || row < 0 || column >= scene.grid.columns() || row >= scene.grid.rows()) {
    return false;
  }
  const RayHit& hit = scene.hit[scene.grid.index(column, row)];
  constexpr double tolerance = 2;  // pixels
  return hit.triangle != no_id && p.z() <= hit.z + tolerance;
}

// At places in mesh units; whole or, where the centre is hidden, not at all. A rim keeps them
// visible on any colour.
void draw_dots(std::span<const Vec3> places, double radius, const Colour& colour, const Colour& rim,
               const Scene& scene, Canvas& canvas, Executor& executor) {
  std::vector<Stroke> inner;
  std::vector<Stroke> outer;
  for (const Vec3& place : places) {
    const Vec3 centre = scene.camera(place);
    if (!is_visible(scene, centre)) continue;
    inner.push_back(disc(centre, radius));
    outer.push_back(disc(centre, radius + std::min(1.0, 0.4 * radius)));
  }
  draw(outer, {rim, 0.9}, scene, canvas, executor);
  draw(inner, {colour, 1}, scene, canvas, executor);
}

void draw_seeds(const PartitionView& view, std::span<const RegionId> shown, const Scene& scene,
                Canvas& canvas, Executor& executor) {
  draw_dots(positions_of(view.mesh_graph, view.seeds), dot_radius(shown, view.seeds.size()), black,
            white, scene, canvas, executor);
}

SubtreeSums subtrees(const Graph& graph, const Partition& partition) {
  std::vector<NodeId> nodes(graph.node_count());
  std::iota(nodes.begin(), nodes.end(), NodeId{0});
  std::sort(nodes.begin(), nodes.end(),
            [&](NodeId a, NodeId b) { return partition.key[a] < partition.key[b]; });
  SubtreeSums sums;
  sums.cost.resize(nodes.size());
  sums.mass.resize(nodes.size());
  sum_subtrees(graph, partition, nodes, sums);
  return sums;
}

std::vector<Stroke> branches(const PartitionView& view, const Scene& scene) {
  const MeshGraph& mesh_graph = view.mesh_graph;
  const SubtreeSums sums = subtrees(mesh_graph.graph, view.partition);
  const double pixels_per_tick =
      mesh_graph.graph.tick_mass / (scene.camera.pixel * scene.camera.pixel);
  std::vector<Stroke> strokes;
  for (NodeId v = 0; v < mesh_graph.graph.node_count(); ++v) {
    const NodeId parent = view.partition.parent[v];
    const double area = static_cast<double>(sums.mass[v]) * pixels_per_tick;
    if (parent == no_id || area < least_branch_area) continue;
    strokes.push_back({scene.camera(mesh_graph.position[v]),
                       scene.camera(mesh_graph.position[parent]),
                       std::min(0.3 + 0.012 * std::sqrt(area), 1.4)});
  }
  return strokes;
}

// Of the vertices that are seen, in random order, each that is far enough from all before it.
std::vector<VertexId> evenly_spread_vertices(const Scene& scene, double spacing) {
  const std::vector<Vec3>& position = scene.mesh.positions;
  std::vector<VertexId> order;
  for (VertexId v = 0; v < position.size(); ++v) {
    if (is_visible(scene, position[v])) order.push_back(v);
  }
  std::sort(order.begin(), order.end(),
            [](VertexId a, VertexId b) { return random_bits(0, a) < random_bits(0, b); });
  const auto cell = [&](double pixels) { return static_cast<int>(pixels / spacing); };
  std::map<std::pair<int, int>, std::vector<VertexId>> chosen_in;
  std::vector<VertexId> chosen;
  for (const VertexId v : order) {
    const Vec3& p = position[v];
    bool is_free = true;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto found = chosen_in.find({cell(p.x()) + dx, cell(p.y()) + dy});
        if (found == chosen_in.end()) continue;
        for (const VertexId u : found->second) {
          is_free = is_free && (position[u] - p).head<2>().norm() >= spacing;
        }
      }
    }
    if (!is_free) continue;
    chosen.push_back(v);
    chosen_in[{cell(p.x()), cell(p.y())}].push_back(v);
  }
  return chosen;
}

double largest_magnitude(std::span<const TangentSpace> vertex_space) {
  double largest = 0;
  for (const TangentSpace& space : vertex_space) {
    largest = std::max({largest, space.tangent_magnitude, space.bitangent_magnitude});
  }
  return largest > 0 ? largest : 1;
}

}  // namespace

Canvas paint_surface(const Scene& scene, Executor& executor, const SurfaceColours& colours) {
  return paint(scene, executor,
               [&](std::size_t sample) { return colours.at(scene, sample, clay); });
}

Canvas paint_mesh(const Scene& scene, Executor& executor, const SurfaceColours& colours,
                  std::span<const std::uint8_t> is_hidden) {
  return paint(scene, executor, [&](std::size_t sample) {
    return blend(colours.at(scene, sample, clay), black,
                 0.85 * edge_coverage(scene, sample, is_hidden));
  });
}

Canvas paint_regions(const PartitionView& view, const Scene& scene, Executor& executor) {
  const std::vector<RegionId> shown =
      show_partition(scene, view.mesh_graph, view.partition, executor);
  Canvas canvas = paint_shown(scene, shown, view.region_colour, 0, executor);
  draw_seeds(view, shown, scene, canvas, executor);
  return canvas;
}

Canvas paint_trees(const PartitionView& view, const Scene& scene, Executor& executor) {
  const std::vector<RegionId> shown =
      show_partition(scene, view.mesh_graph, view.partition, executor);
  Canvas canvas = paint_shown(scene, shown, view.region_colour, 0.6, executor);
  draw(branches(view, scene), {black, 0.85}, scene, canvas, executor);
  draw_seeds(view, shown, scene, canvas, executor);
  return canvas;
}

Canvas paint_field(std::span<const TangentSpace> vertex_space, const Scene& scene,
                   Executor& executor) {
  const double spacing = std::clamp(scene.grid.size.width / 34.0, 12.0, 36.0);
  const double scale = 0.5 * spacing / largest_magnitude(vertex_space);
  std::vector<Stroke> larger;
  std::vector<Stroke> smaller;
  for (const VertexId v : evenly_spread_vertices(scene, spacing)) {
    const TangentSpace& space = vertex_space[v];
    const auto stroke = [&](const Vec3& direction, double magnitude) -> Stroke {
      const Vec3 half = scene.camera.axes(direction) * (scale * magnitude);
      return {scene.mesh.positions[v] - half, scene.mesh.positions[v] + half, field_half_width};
    };
    const bool in_order = space.tangent_magnitude >= space.bitangent_magnitude;
    (in_order ? larger : smaller).push_back(stroke(space.tangent, space.tangent_magnitude));
    (in_order ? smaller : larger).push_back(stroke(space.bitangent, space.bitangent_magnitude));
  }
  Canvas canvas = paint_surface(scene, executor);
  draw(smaller, {orange, 1}, scene, canvas, executor);
  draw(larger, {blue, 1}, scene, canvas, executor);
  return canvas;
}

Canvas paint_ground_truth(const PartitionView& view, std::span<const RegionId> region_of_node,
                          std::span<const Vec3> centroid, const Scene& scene, Executor& executor) {
  const std::vector<Vec3> seeds = positions_of(view.mesh_graph, view.seeds);
  const std::vector<RegionId> shown =
      show_nearest(scene, view.mesh_graph, region_of_node, seeds, executor);
  Canvas canvas = paint_shown(scene, shown, view.region_colour, 0, executor);
  const double radius = dot_radius(shown, seeds.size());
  draw_dots(seeds, radius, white, black, scene, canvas, executor);
  draw_dots(centroid, radius, black, white, scene, canvas, executor);
  return canvas;
}

}  // namespace geolloyd

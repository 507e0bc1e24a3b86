// What is seen of a mesh, and how it becomes a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/lloyd/reference_engine.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "tests/support/odd_surfaces.h"
#include "tools/render/painters.h"
#include "tools/render/panel.h"
#include "tools/render/picture.h"
#include "tools/render/shown_regions.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

constexpr Colour red = {255, 0, 0};
constexpr Colour blue = {0, 0, 255};

Scene scene_of(const Mesh& mesh, const std::string& view, Size size, Scheduler& scheduler) {
  const Outline outline = outline_of(mesh.positions, parse_view(view));
  return make_scene(mesh, fit_camera(outline, size), Shading::smooth, scheduler);
}

std::size_t sample_at(const Scene& scene, const Vec3& p) {
  return scene.grid.index(static_cast<int>(p.x() * SampleGrid::per_side),
                          static_cast<int>(p.y() * SampleGrid::per_side));
}

TEST(View, HasUnitVectorsAtRightAnglesAndTheMiddleSideUpright) {
  const std::vector<Vec3> box = {{0, 0, 0}, {2, 9, 5}};  // shortest x, then z, then y
  for (const char* name : {"front", "back", "left", "right", "top", "bottom", "25,15", "-70,-89"}) {
    const Axes axes = outline_of(box, parse_view(name)).axes;
    EXPECT_NEAR(norm(axes.right), 1, 1e-12) << name;
    EXPECT_NEAR(norm(axes.down), 1, 1e-12) << name;
    EXPECT_NEAR(dot(axes.right, axes.down), 0, 1e-12) << name;
    EXPECT_NEAR(norm(cross(axes.right, axes.down) - axes.away), 0, 1e-12) << name;
  }
  const auto axes = [&](const char* view) { return outline_of(box, parse_view(view)).axes; };
  EXPECT_NEAR(norm(axes("front").away + Vec3::UnitX()), 0, 1e-12);
  EXPECT_NEAR(norm(axes("front").down + Vec3::UnitZ()), 0, 1e-12);
  EXPECT_NEAR(norm(axes("top").away + Vec3::UnitZ()), 0, 1e-12);
  EXPECT_NEAR(norm(axes("right").away + axes("front").right), 0, 1e-12);
  EXPECT_NEAR(norm(axes("back").right + axes("front").right), 0, 1e-12);
}

// A remesh is a little smaller or larger than its mesh, in each direction.
TEST(View, IsTheSameForBoxesThatAreNearlyEqual) {
  const auto axes = [](const Vec3& extent) {
    const std::vector<Vec3> box = {{0, 0, 0}, extent};
    return outline_of(box, parse_view("25,15")).axes;
  };
  const std::vector<std::array<Vec3, 2>> pairs = {{{{1, 1, 1}, {1.005, 0.998, 0.996}}},
                                                  {{{2, 1, 1}, {2, 1.002, 0.999}}},
                                                  {{{1, 2, 2}, {1, 2.01, 1.99}}}};
  for (const auto& [mesh, remesh] : pairs) {
    EXPECT_EQ(axes(mesh).away, axes(remesh).away);
    EXPECT_EQ(axes(mesh).down, axes(remesh).down);
  }
  EXPECT_NE(axes({1, 1, 1}).away, axes({1, 1, 0.9}).away);
}

TEST(View, IsRefusedWhereItMakesNoSense) {
  for (const char* text : {"", "above", "1", "1,", "1,2,3", "1,2x", "0,91", "361,0", "nan,0",
                           "0,inf", " 1,2", "1e9,0"}) {
    EXPECT_THROW(parse_view(text), InvalidInput) << text;
  }
  for (const char* text : {"", "0x0", "1e9x1e9", "63", "8193x100", "100x", "x100", "-100x100",
                           "100x100x100", "100 x 100", "99999999999x1"}) {
    EXPECT_THROW(parse_size(text), InvalidInput) << text;
  }
  EXPECT_EQ(parse_size("1920x1080").height, 1080);
  EXPECT_EQ(parse_size("640").height, 0);
}

TEST(Camera, FitsEveryVertexIntoThePicture) {
  const Mesh mesh = creature(2000, 1);
  for (const char* view : {"25,15", "top", "back"}) {
    for (const Size size : {Size{300, 100}, Size{100, 300}}) {
      const Camera camera = fit_camera(outline_of(mesh.positions, parse_view(view)), size);
      GrowingBox box;
      for (const Vec3& p : mesh.positions) box.add(camera(p));
      EXPECT_GT(box.low.minCoeff(), 0) << view;
      EXPECT_LT(box.high.x(), size.width) << view;
      EXPECT_LT(box.high.y(), size.height) << view;
      const Vec3 extent = box.high - box.low;
      EXPECT_GT(std::max(extent.x() / size.width, extent.y() / size.height), 0.95) << view;
    }
  }
}

TEST(Scene, HitsASphereWhereItIs) {
  Scheduler scheduler(2);
  const Scene scene = scene_of(icosphere(5000), "front", {120, 120}, scheduler);
  const double radius = 1 / scene.camera.pixel;
  for (int row = 0; row < scene.grid.rows(); ++row) {
    for (int column = 0; column < scene.grid.columns(); ++column) {
      const double x = SampleGrid::place(column) - 60;
      const double y = SampleGrid::place(row) - 60;
      const double off = std::hypot(x, y);
      const RayHit& hit = scene.hit[scene.grid.index(column, row)];
      if (std::abs(off - radius) < 0.5) continue;
      ASSERT_EQ(hit.triangle != no_id, off < radius) << column << " " << row;
      if (off > 0.9 * radius) continue;
      EXPECT_NEAR(hit.z, 1 + radius - std::sqrt(radius * radius - off * off), 0.5);
    }
  }
}

// Each face of a box has one light, up to its edges, however long its triangles are.
TEST(Scene, KeepsSharpEdgesAndRoundsSoftOnes) {
  Scheduler scheduler(2);
  const auto lights = [&](const Mesh& mesh, Shading shading) {
    const Outline outline = outline_of(mesh.positions, parse_view("25,15"));
    return make_scene(mesh, fit_camera(outline, {60, 60}), shading, scheduler).light;
  };
  const auto largest_difference = [&](const Mesh& mesh) {
    const std::vector<float> smooth = lights(mesh, Shading::smooth);
    const std::vector<float> flat = lights(mesh, Shading::flat);
    float largest = 0;
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      largest = std::max(largest, std::abs(smooth[i] - flat[i]));
    }
    return largest;
  };
  EXPECT_LT(largest_difference(flat_box(0.1)), 1e-6);
  EXPECT_GT(largest_difference(icosphere(80)), 0.05);
}

TEST(Draw, HidesWhatIsBehindTheSurface) {
  Scheduler scheduler(2);
  const Scene scene = scene_of(icosphere(5000), "front", {120, 120}, scheduler);
  const Canvas before = paint_surface(scene, scheduler);
  const auto drawn_at = [&](double z) {
    Canvas canvas = before;
    const std::vector<Stroke> strokes = {{{50, 60, z}, {70, 60, z}, 1}};
    draw(strokes, {red, 1}, scene, canvas, scheduler);
    EXPECT_EQ(canvas[scene.grid.index(60 * SampleGrid::per_side, 70 * SampleGrid::per_side)],
              before[scene.grid.index(60 * SampleGrid::per_side, 70 * SampleGrid::per_side)]);
    return canvas[scene.grid.index(60 * SampleGrid::per_side, 60 * SampleGrid::per_side)];
  };
  EXPECT_EQ(drawn_at(1), red);
  EXPECT_NE(drawn_at(100), red);
}

class ShownRegions : public testing::TestWithParam<GraphKind> {};

MeshGraph graph_of(const Mesh& mesh, GraphKind kind) {
  return make_mesh_graph(mesh, find_edges(mesh), {kind, Norm::geodesic, {}});
}

// In a scene whose samples are the corners and the middle of each triangle.
TEST_P(ShownRegions, ANodeShowsItsOwn) {
  Scheduler scheduler(2);
  const Mesh mesh = creature(600, 3);
  Scene scene = scene_of(mesh, "25,15", {64, 64}, scheduler);
  const MeshGraph mesh_graph = graph_of(mesh, GetParam());
  std::vector<NodeId> node;
  scene.hit.clear();
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    const auto add = [&](std::size_t input_id, float u, float v) {
      node.push_back(mesh_graph.node_of[input_id]);
      scene.hit.push_back({t, u, v, 0});
    };
    if (has_vertices(GetParam())) {
      add(mesh.triangles[t][0], 0, 0);
      add(mesh.triangles[t][1], 1, 0);
      add(mesh.triangles[t][2], 0, 1);
    }
    if (has_triangles(GetParam())) add(mesh_graph.first_triangle_id + t, 1.0F / 3, 1.0F / 3);
  }
  std::vector<NodeId> seeds;
  for (NodeId v = 0; v < mesh_graph.graph.node_count(); v += 11) seeds.push_back(v);
  const auto engine = make_reference_engine(mesh_graph.graph);
  engine->partition(seeds);
  const Partition& partition = engine->current();
  const std::vector<RegionId> shown = show_partition(scene, mesh_graph, partition, scheduler);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    ASSERT_EQ(shown[i], region_of(partition.key[node[i]])) << node[i];
  }
}

TEST_P(ShownRegions, OfTheNearestSeedsAreThoseOfBruteForce) {
  Scheduler scheduler(2);
  const Mesh mesh = icosphere(2000);
  const Scene scene = scene_of(mesh, "10,20", {150, 150}, scheduler);
  const MeshGraph mesh_graph = graph_of(mesh, GetParam());
  std::vector<Vec3> seeds;
  for (NodeId node = 0; node < mesh_graph.graph.node_count(); node += 97) {
    seeds.push_back(mesh_graph.position[node]);
  }
  const auto nearest = [&](const Vec3& p) {
    RegionId best = 0;
    for (RegionId r = 1; r < seeds.size(); ++r) {
      if (norm(p - seeds[r]) < norm(p - seeds[best])) best = r;
    }
    return best;
  };
  std::vector<RegionId> region;
  for (const Vec3& p : mesh_graph.position) region.push_back(nearest(p));
  const std::vector<RegionId> shown = show_nearest(scene, mesh_graph, region, seeds, scheduler);
  std::size_t hits = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const RayHit& hit = scene.hit[i];
    if (hit.triangle == no_id) continue;
    const Triangle& t = mesh.triangles[hit.triangle];
    const Vec3 p = (1.0 - hit.u - hit.v) * mesh.positions[t[0]] + hit.u * mesh.positions[t[1]] +
                   hit.v * mesh.positions[t[2]];
    ++hits;
    if (shown[i] != nearest(p)) ++wrong;  // a corner of a region that holds no node
  }
  EXPECT_LT(wrong, hits / 200);
}

INSTANTIATE_TEST_SUITE_P(AllGraphs, ShownRegions,
                         testing::Values(GraphKind::vertex, GraphKind::vertex_dense,
                                         GraphKind::triangle, GraphKind::triangle_dense,
                                         GraphKind::mixed));

TEST(Painters, ShowTwoHalvesOfASphereAndTheirSeedsAsDots) {
  Scheduler scheduler(2);
  const Mesh mesh = icosphere(5000);
  const Scene scene = scene_of(mesh, "front", {240, 240}, scheduler);
  const MeshGraph mesh_graph = graph_of(mesh, GraphKind::vertex);
  // Above and below, towards the viewer, who looks along x with y upright.
  std::vector<NodeId> seeds;
  for (const Vec3& place : {Vec3(0.8, 0.6, 0), Vec3(0.8, -0.6, 0)}) {
    NodeId best = 0;
    for (NodeId v = 0; v < mesh_graph.position.size(); ++v) {
      if (norm(mesh_graph.position[v] - place) < norm(mesh_graph.position[best] - place)) best = v;
    }
    seeds.push_back(best);
  }
  const auto engine = make_reference_engine(mesh_graph.graph);
  engine->partition(seeds);
  const std::vector<Colour> colours = {red, blue};
  const PartitionView view{mesh_graph, engine->current(), seeds, colours};
  const Canvas canvas = paint_regions(view, scene, scheduler);
  for (const double y : {60.0, 105.0, 135.0, 180.0}) {
    for (const double x : {90.0, 150.0}) {
      const Colour& c = canvas[sample_at(scene, {x, y, 0})];
      EXPECT_GT(c[y < 120 ? 0 : 2], 100) << x << " " << y;
      EXPECT_EQ(c[y < 120 ? 2 : 0], 0) << x << " " << y;
    }
  }
  for (const NodeId seed : seeds) {
    const Colour& c = canvas[sample_at(scene, scene.camera(mesh_graph.position[seed]))];
    EXPECT_LT(c[0] + c[1] + c[2], 100);
  }
}

TEST(Painters, GiveTheSameForAnyNumberOfThreads) {
  const Mesh mesh = creature(3000, 1);
  const MeshGraph mesh_graph = graph_of(mesh, GraphKind::mixed);
  const std::vector<NodeId> seeds = {1, 400, 900, 2000};
  const std::vector<Colour> colours = {red, blue, {0, 255, 0}, {9, 9, 9}};
  const auto engine = make_reference_engine(mesh_graph.graph);
  engine->partition(seeds);
  std::vector<Canvas> first;
  for (const std::size_t threads : {1U, 2U, 5U}) {
    Scheduler scheduler(threads);
    const Scene scene = scene_of(mesh, "25,15", {200, 160}, scheduler);
    const PartitionView view{mesh_graph, engine->current(), seeds, colours};
    const std::vector<TangentSpace> spaces(mesh.vertex_count(), {{1, 0, 0}, {0, 1, 0}, 3, 1});
    const std::vector<Canvas> painted = {
        paint_mesh(scene, scheduler), paint_regions(view, scene, scheduler),
        paint_trees(view, scene, scheduler), paint_field(spaces, scene, scheduler)};
    if (first.empty()) first = painted;
    EXPECT_EQ(painted, first) << threads;
  }
}

TEST(Panel, IsANameAndMaybeACaption) {
  EXPECT_EQ(parse_panel("trees").kind, PanelKind::trees);
  EXPECT_EQ(caption_of(parse_panel("trees"), 1), "");
  EXPECT_EQ(caption_of(parse_panel("trees"), 2), "trees");
  EXPECT_EQ(caption_of(parse_panel("trees=a = b"), 1), "a = b");
  EXPECT_EQ(caption_of(parse_panel("trees="), 2), "");
  for (const char* text : {"", "=", "tree", "Trees", "trees ", "=trees"}) {
    EXPECT_THROW(parse_panel(text), InvalidInput) << text;
  }
}

TEST(Layout, ShowsPanelsAsLargeAsItCan) {
  EXPECT_EQ(arrange(3, true, {900, 300}, 1).columns, 3);
  EXPECT_EQ(arrange(3, true, {300, 900}, 1).columns, 1);
  EXPECT_EQ(arrange(4, true, {800, 800}, 1).columns, 2);
  const Layout open = arrange(2, false, {808, 0}, 0.5);
  EXPECT_EQ(open.columns, 2);
  EXPECT_EQ(open.panel.width, 400);
  EXPECT_EQ(open.picture.height, 200);
  EXPECT_THROW(arrange(100, true, {64, 64}, 1), InvalidInput);
}

}  // namespace
}  // namespace geolloyd

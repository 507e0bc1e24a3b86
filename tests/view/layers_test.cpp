// What the viewer is told of a partition, against the partition itself.
#include "tools/view/layers.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/lloyd/reference_engine.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "tests/view/bundle_reader.h"

namespace geolloyd {
namespace {

class Layers : public testing::TestWithParam<GraphKind> {
 protected:
  void SetUp() override {
    mesh_.positions.emplace_back(9, 9, 9);  // of no triangle
    mesh_graph_ = make_mesh_graph(mesh_, find_edges(mesh_), {GetParam(), Norm::geodesic, {}});
    for (NodeId v = 5; v < mesh_graph_.graph.node_count(); v += 60) seeds_.push_back(v);
    engine_ = make_reference_engine(mesh_graph_.graph);
    engine_->partition(seeds_);
    bundle_.placement = placement_of(mesh_);
    add_mesh(bundle_, mesh_);
  }

  // Where the viewer finds what an input id stands for.
  [[nodiscard]] Vec3 place_of(std::size_t input_id) const {
    if (input_id < mesh_graph_.first_triangle_id) return mesh_.positions[input_id];
    const Triangle& t = mesh_.triangles[input_id - mesh_graph_.first_triangle_id];
    return (mesh_.positions[t[0]] + mesh_.positions[t[1]] + mesh_.positions[t[2]]) / 3;
  }

  Mesh mesh_ = creature(800, 1);
  MeshGraph mesh_graph_;
  std::vector<NodeId> seeds_;
  std::unique_ptr<Engine> engine_;
  Bundle bundle_;
};

TEST_P(Layers, GiveEachInputIdItsRegion) {
  add_regions(bundle_, mesh_graph_, engine_->current(), seeds_);
  const BundleReader read(encode(bundle_));
  const std::vector<double> region = read.array("region");
  ASSERT_EQ(region.size(), (has_vertices(GetParam()) ? mesh_.vertex_count() : 0) +
                               (has_triangles(GetParam()) ? mesh_.triangle_count() : 0));
  const std::string per = has_triangles(GetParam()) ? "triangle" : "vertex";
  EXPECT_EQ(read.entry("region")["per"], GetParam() == GraphKind::mixed ? "both" : per);
  for (std::size_t id = 0; id < region.size(); ++id) {
    const NodeId node = mesh_graph_.node_of[id];
    const double wanted = node == no_id ? 65535 : region_of(engine_->current().key[node]);
    ASSERT_EQ(region[id], wanted) << id;
  }
  const std::vector<double> seed_id = read.array("seed_id");
  const std::vector<double> places = read.array("seeds");
  for (std::size_t r = 0; r < seeds_.size(); ++r) {
    EXPECT_EQ(region[static_cast<std::size_t>(seed_id[r])], static_cast<double>(r));
    const Vec3 place = bundle_.placement(place_of(static_cast<std::size_t>(seed_id[r])));
    EXPECT_NEAR(norm(place - Vec3(places[3 * r], places[3 * r + 1], places[3 * r + 2])), 0, 1e-6);
  }
}

TEST_P(Layers, GiveAdjacentRegionsDifferentColours) {
  add_regions(bundle_, mesh_graph_, engine_->current(), seeds_);
  const std::vector<double> palette = BundleReader(encode(bundle_)).array("palette");
  for (const auto& [a, b] : adjacent_regions(mesh_graph_.graph, engine_->current())) {
    const auto colour = [&, &p = palette](RegionId r) {
      return std::vector<double>(p.begin() + 3 * r, p.begin() + 3 * r + 3);
    };
    EXPECT_NE(colour(a), colour(b));
  }
}

TEST_P(Layers, LeadFromEachNodeToItsSeed) {
  add_regions(bundle_, mesh_graph_, engine_->current(), seeds_);
  add_trees(bundle_, mesh_graph_, engine_->current());
  const BundleReader read(encode(bundle_));
  const std::vector<double> parent = read.array("parent");
  const std::vector<double> region = read.array("region");
  const std::vector<double> seed_id = read.array("seed_id");
  for (std::size_t id = 0; id < parent.size(); ++id) {
    if (region[id] == 65535) continue;
    std::size_t at = id;
    for (std::size_t steps = 0; parent[at] != 65535; ++steps) {
      ASSERT_LT(steps, parent.size());
      at = static_cast<std::size_t>(parent[at]);
    }
    ASSERT_EQ(static_cast<double>(at), seed_id[static_cast<std::size_t>(region[id])]);
  }
}

INSTANTIATE_TEST_SUITE_P(AllGraphs, Layers,
                         testing::Values(GraphKind::vertex, GraphKind::vertex_dense,
                                         GraphKind::triangle, GraphKind::triangle_dense,
                                         GraphKind::mixed, GraphKind::vertex_far));

TEST(FieldLayer, HasTheLargestMagnitudeAsItsUnit) {
  Bundle bundle;
  add_field(bundle, std::vector<TangentSpace>{{{2, 0, 0}, {0, 1, 0}, 4, 1},
                                              {Vec3::Zero(), {0, 0, 1}, 3, 8}});
  const BundleReader read(encode(bundle));
  EXPECT_EQ(read.array("field"), (std::vector<double>{0.5, 0, 0, 0, 0.125, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(Frames, NameTheirArrays) {
  const Mesh mesh = icosphere(300);
  const MeshGraph mesh_graph =
      make_mesh_graph(mesh, find_edges(mesh), {GraphKind::vertex, Norm::geodesic, {}});
  const auto engine = make_reference_engine(mesh_graph.graph);
  Bundle bundle;
  bundle.placement = placement_of(mesh);
  add_mesh(bundle, mesh);
  for (const NodeId first : {NodeId{0}, NodeId{40}}) {
    const std::vector<NodeId> seeds = {first, 90};
    engine->partition(seeds);
    add_frame(bundle, "step", 0.5 * first, mesh_graph, engine->current(), seeds);
  }
  const BundleReader read(encode(bundle));
  ASSERT_EQ(read.header()["frames"].size(), 2U);
  for (const auto& frame : read.header()["frames"]) {
    EXPECT_EQ(read.array(frame["region"]).size(), mesh.vertex_count());
    EXPECT_EQ(read.array(frame["seeds"]).size(), 6U);
  }
  EXPECT_EQ(read.header()["frames"][1]["energy"], 20.0);
}

}  // namespace
}  // namespace geolloyd

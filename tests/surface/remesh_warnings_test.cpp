// What is bad is said, and nothing else: each warning on both sides of its limit.
#include "core/course/remesh_warnings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/course/remesh_course.h"
#include "core/repair/crossings.h"
#include "core/shapes/shapes.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

InputSigns signs_of(const Mesh& mesh) {
  return find_signs(mesh, find_edges(mesh), sequential());
}

// A sphere remeshed by itself, of which nothing is bad.
class RemeshWarnings : public testing::Test {
 protected:
  RemeshWarnings() : mesh_(icosphere(1'280)), signs_(signs_of(mesh_)) {
    remesh_.mesh = mesh_;
    remesh_.topology = topology_of(mesh_);
    remesh_.surface_parts = remesh_.topology.parts;
    remesh_.vertices_asked_for = mesh_.vertex_count();
  }

  [[nodiscard]] std::vector<RemeshFlaw> flaws() const {
    std::vector<RemeshFlaw> found;
    for (const RemeshWarning& w : find_warnings(mesh_, signs_, options_, remesh_)) {
      EXPECT_FALSE(w.text.empty());
      EXPECT_EQ(w.text.find('\n'), std::string::npos);
      found.push_back(w.flaw);
    }
    return found;
  }

  void expect(const std::vector<RemeshFlaw>& expected) const { EXPECT_EQ(flaws(), expected); }

  [[nodiscard]] double spacing() const {
    return norm(mesh_.positions[mesh_.triangles[0][0]] - mesh_.positions[mesh_.triangles[0][1]]);
  }

  Mesh mesh_;
  InputSigns signs_;
  RemeshOptions options_;
  Remesh remesh_;
};

TEST_F(RemeshWarnings, AreNoneOfAGoodRemesh) {
  expect({});
}

TEST_F(RemeshWarnings, TellOfManyVertices) {
  remesh_.vertices_asked_for = mesh_.vertex_count() * 100 / 104;
  expect({});
  remesh_.vertices_asked_for = mesh_.vertex_count() * 100 / 106;
  expect({RemeshFlaw::vertices});
}

TEST_F(RemeshWarnings, TellOfAnotherTopology) {
  remesh_.surface_parts.push_back({2, 0});
  expect({RemeshFlaw::topology});
}

TEST_F(RemeshWarnings, TellOfALostVolume) {
  for (Vec3& p : remesh_.mesh.positions) p *= 0.995;
  expect({});
  for (Vec3& p : remesh_.mesh.positions) p *= 0.995;
  expect({RemeshFlaw::volume});
  signs_.is_closed = false;
  expect({});
}

TEST_F(RemeshWarnings, TellOfADistance) {
  warn_of_distance(0.29, 10, remesh_);
  EXPECT_TRUE(remesh_.warnings.empty());
  warn_of_distance(0.31, 10, remesh_);
  ASSERT_EQ(remesh_.warnings.size(), 1U);
  EXPECT_EQ(remesh_.warnings[0].flaw, RemeshFlaw::distance);
  EXPECT_NE(remesh_.warnings[0].text.find("3.1 %"), std::string::npos);
}

TEST_F(RemeshWarnings, TellOfAFitThatDidLittle) {
  remesh_.distance_before_fit = remesh_.distance_after_fit = 0.01 * spacing();
  expect({});
  remesh_.distance_before_fit = remesh_.distance_after_fit = 0.1 * spacing();
  expect({RemeshFlaw::fit});
  remesh_.distance_after_fit = 0.05 * spacing();
  expect({});
}

TEST_F(RemeshWarnings, TellOfSharpEdgesThatAreNotKept) {
  signs_.sharp_length = 2.4 * std::sqrt(signs_.area);
  expect({});
  signs_.sharp_length = 2.6 * std::sqrt(signs_.area);
  expect({RemeshFlaw::features});
  options_.features.creases = Creases::none;
  expect({});
  options_.features.creases = Creases::automatic;
  remesh_.feature_edges = {{0, 1}};
  expect({});
}

TEST_F(RemeshWarnings, TellOfSharpEdgesThatLieTooClose) {
  remesh_.creases_left_out = true;
  expect({RemeshFlaw::features});
}

TEST_F(RemeshWarnings, TellOfSmallParts) {
  remesh_.small_parts = 1;
  expect({RemeshFlaw::small_parts});
}

TEST_F(RemeshWarnings, TellOfSplitVerticesAndLimits) {
  signs_.split_vertices = 2;
  expect({RemeshFlaw::split_vertices});
  remesh_.was_cut_short = true;
  expect({RemeshFlaw::split_vertices, RemeshFlaw::limit});
}

TEST_F(RemeshWarnings, TellOfSelfIntersectionsThatTheInputHasNot) {
  remesh_.self_intersections = {{0, 7}};
  expect({RemeshFlaw::self_intersections});
  signs_.has_self_intersections = true;
  expect({});
}

// A wall too thin for its remesh, of two sheets: they pass through each other. Then the input does.
TEST(Remeshes, TellOfTheirSelfIntersections) {
  RemeshOptions options;
  options.vertex_count = 40;
  options.fit = false;
  Mesh shell = icosphere(1'280);
  Mesh inner = shell;
  for (Vec3& p : inner.positions) p *= 0.99;
  append(shell, inner);
  const auto warns = [&](const Mesh& mesh) {
    const MeshEdges edges = find_edges(mesh);
    const Remesh remesh = run(RemeshCourse{mesh, edges, options, reference_runtime()}).remesh;
    EXPECT_EQ(remesh.self_intersections, find_crossings(remesh.mesh));
    EXPECT_FALSE(remesh.self_intersections.empty());
    return std::any_of(remesh.warnings.begin(), remesh.warnings.end(), [](const RemeshWarning& w) {
      return w.flaw == RemeshFlaw::self_intersections;
    });
  };
  EXPECT_TRUE(warns(shell));
  append(shell, moved(shell, {0.5, 0, 0}));
  EXPECT_FALSE(warns(shell));
}

TEST(InputSigns, AreThoseOfTheMesh) {
  const InputSigns box = signs_of(flat_box(1));
  EXPECT_TRUE(box.is_closed);
  EXPECT_NEAR(box.sharp_length, 12, 1e-12);
  EXPECT_NEAR(box.area, 6, 1e-12);
  EXPECT_EQ(box.split_vertices, 0U);
  Mesh two = flat_box(1);
  append(two, moved(one_triangle(), {9, 0, 0}));
  append(two, moved(one_triangle(), {9, 0, 0}));
  const InputSigns parts = signs_of(two);
  EXPECT_FALSE(parts.is_closed);
  EXPECT_EQ(parts.split_vertices, 0U);
  Mesh square = one_triangle();
  append(square, {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(signs_of(square).split_vertices, 2U);
  EXPECT_EQ(signs_of(icosphere(1'280)).sharp_length, 0);
}

TEST(RemeshWarningsOfTheLibrary, CountPartsSmallerThanATriangle) {
  Mesh mesh = icosphere(1'280);
  append(mesh, moved(scaled(icosphere(80), Vec3::Constant(0.04)), {3, 0, 0}));
  append(mesh, moved(scaled(icosphere(80), Vec3::Constant(0.5)), {6, 0, 0}));
  RemeshOptions options;
  options.vertex_count = 300;
  EXPECT_EQ(remesh(mesh, options, reference_runtime()).small_parts, 1U);
  options.vertex_count = 2'000;
  options.fit = false;
  EXPECT_EQ(remesh(mesh, options, reference_runtime()).small_parts, 0U);
}

// The values reach those who call the library.
TEST(RemeshWarningsOfTheLibrary, ComeWithTheRemesh) {
  RemeshOptions options;
  options.vertex_count = 4;
  options.fit = false;
  const Remesh coarse = remesh(icosphere(1'280), options, reference_runtime());
  ASSERT_FALSE(coarse.warnings.empty());
  EXPECT_EQ(std::string(name_of(coarse.warnings[0].flaw)), "volume");
}

}  // namespace
}  // namespace geolloyd

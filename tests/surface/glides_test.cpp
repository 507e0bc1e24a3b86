#include "core/surface/flips/glides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "core/shapes/shapes.h"
#include "core/surface/fit/surface_fit.h"
#include "core/surface/flips/edge_flips.h"
#include "core/surface/flips/flippable_triangles.h"
#include "core/surface/flips/glide_paths.h"
#include "core/surface/flips/moved_labels.h"
#include "core/surface/flips/vertex_moves.h"
#include "geolloyd/remesh.h"
#include "tests/support/random_graph.h"
#include "tests/support/sharp_solids.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

using Side = FlippableTriangles::Side;

// Of each vertex; 0 on the boundary.
std::vector<int> excess_of(const Mesh& mesh) {
  std::vector<int> excess(mesh.vertex_count(), -6);
  std::vector<bool> is_inside(mesh.vertex_count(), true);
  const MeshEdges edges = find_edges(mesh);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const VertexId v : edges.ends[e]) {
      ++excess[v];
      if (edges.corners(e).size() != 2) is_inside[v] = false;
    }
  }
  for (std::size_t v = 0; v < excess.size(); ++v) {
    if (!is_inside[v]) excess[v] = 0;
  }
  return excess;
}

int irregular_of(const Mesh& mesh) {
  const std::vector<int> excess = excess_of(mesh);
  return static_cast<int>(excess.size()) -
         static_cast<int>(std::count(excess.begin(), excess.end(), 0));
}

// Rows of equilateral triangles in the plane.
Mesh lattice(VertexId side) {
  Mesh mesh;
  for (VertexId row = 0; row < side; ++row) {
    for (VertexId column = 0; column < side; ++column) {
      mesh.positions.emplace_back(column - 0.5 * row, 0.8660254037844386 * row, 0);
    }
  }
  for (VertexId row = 0; row + 1 < side; ++row) {
    for (VertexId v = row * side; v + 1 < (row + 1) * side; ++v) {
      mesh.triangles.push_back({v, v + 1, v + side + 1});
      mesh.triangles.push_back({v, v + side + 1, v + side});
    }
  }
  return mesh;
}

Mesh with_triangles(Mesh mesh, const FlippableTriangles& triangles) {
  mesh.triangles = triangles.triangles();
  return mesh;
}

// Flips an edge that can be flipped, far from the boundary.
Mesh with_flip(const Mesh& mesh, VertexId b, VertexId c) {
  FlippableTriangles triangles(mesh.vertex_count(), mesh.triangles);
  triangles.flip(triangles.side_of(b, c));
  return with_triangles(mesh, triangles);
}

// A surface, and a remesh of it as it may be before irregular vertices glide.
struct Prepared {
  SurfaceInput input;
  std::vector<RegionId> labels;
  Mesh remesh;
};

Prepared prepare(const Mesh& surface, const Mesh& remesh) {
  Prepared prepared{surface_input_of(surface, 0.2), {}, remesh};
  for (const Vec3& p : prepared.input.fine.positions) {
    RegionId nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (RegionId r = 0; r < remesh.vertex_count(); ++r) {
      const Vec3 away = prepared.input.frame.to_unit(remesh.positions[r]) - p;
      if (dot(away, away) >= least) continue;
      least = dot(away, away);
      nearest = r;
    }
    prepared.labels.push_back(nearest);
  }
  return prepared;
}

TEST(FlippableTriangles, KnowWhatIsAroundAVertex) {
  for (const Mesh& mesh : {icosphere(42), torus(300, 1), cylinder(100, 1), lattice(5)}) {
    const FlippableTriangles triangles(mesh.vertex_count(), mesh.triangles);
    std::vector<std::multiset<TriangleId>> around(mesh.vertex_count());
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      for (const VertexId v : mesh.triangles[t]) around[v].insert(t);
    }
    std::set<std::array<VertexId, 2>> edges;
    const MeshEdges found = find_edges(mesh);
    edges.insert(found.ends.begin(), found.ends.end());
    for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
      std::multiset<TriangleId> visited;
      triangles.visit_around(v, [&](TriangleId t) { visited.insert(t); });
      EXPECT_EQ(visited, around[v]);
      EXPECT_EQ(triangles.count_around(v), around[v].size());
      for (VertexId w = 0; w < mesh.vertex_count(); ++w) {
        EXPECT_EQ(triangles.is_edge(v, w), edges.count(ascending(v, w)) == 1) << v << " " << w;
      }
    }
  }
}

// After any flips they are what a new one of the same triangles is; flipped back, they are as
// before.
TEST(FlippableTriangles, StayConnectedAfterFlips) {
  const Mesh sphere = icosphere(162);
  FlippableTriangles triangles(sphere.vertex_count(), sphere.triangles);
  for (std::uint64_t n = 0; n < 500; ++n) {
    const auto t = static_cast<TriangleId>(random_number(1, 2 * n, triangles.size()));
    const auto k = static_cast<std::uint32_t>(random_number(1, 2 * n + 1, 3));
    const auto [a, b, c, d] = triangles.quad_of({t, k});
    if (triangles.is_edge(a, d)) continue;
    triangles.flip({t, k});
    EXPECT_TRUE(triangles.is_edge(a, d));
    EXPECT_FALSE(triangles.is_edge(b, c));
    if (n % 2 == 0) triangles.flip(triangles.side_of(a, d));
  }
  const Mesh flipped = with_triangles(sphere, triangles);
  EXPECT_EQ(find_topology(flipped, find_edges(flipped)).parts,
            find_topology(sphere, find_edges(sphere)).parts);
  const FlippableTriangles anew(flipped.vertex_count(), flipped.triangles);
  for (TriangleId t = 0; t < anew.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      EXPECT_EQ(triangles.across({t, k}), anew.across({t, k}));
    }
  }
  for (VertexId v = 0; v < sphere.vertex_count(); ++v) {
    EXPECT_EQ(triangles.count_around(v), anew.count_around(v));
    EXPECT_TRUE(triangles.is_inside(v));
  }
}

// What is around a vertex may be replaced in any way that fills its place.
TEST(FlippableTriangles, CanBeReplaced) {
  const Mesh sphere = icosphere(162);
  FlippableTriangles triangles(sphere.vertex_count(), sphere.triangles);
  std::vector<FlippableTriangles::Replacement> fan;
  const auto added = static_cast<VertexId>(sphere.vertex_count());
  const auto next = static_cast<TriangleId>(sphere.triangle_count());
  const auto [a, b, c] = sphere.triangles[7];
  fan = {{7, {a, b, added}}, {next, {b, c, added}}, {next + 1, {c, a, added}}};
  triangles.replace(fan);
  EXPECT_EQ(triangles.count_around(added), 3U);
  EXPECT_TRUE(triangles.is_inside(added));
  fan = {{next, {a, b, c}}, {7, FlippableTriangles::none}, {next + 1, FlippableTriangles::none}};
  triangles.replace(fan);
  EXPECT_EQ(triangles.count_around(added), 0U);
  EXPECT_FALSE(triangles.is_inside(added));
  EXPECT_FALSE(triangles.exists(7));
  const FlippableTriangles anew(sphere.vertex_count(), sphere.triangles);
  for (VertexId v = 0; v < sphere.vertex_count(); ++v) {
    EXPECT_EQ(triangles.count_around(v), anew.count_around(v));
    EXPECT_TRUE(triangles.is_inside(v));
  }
}

// The triangles of a patch that are still there, with numbers of its vertices.
Mesh mesh_of(const GlidePatch& patch) {
  Mesh mesh;
  for (VertexId v = 0; v < patch.vertices().size(); ++v) {
    mesh.positions.push_back(patch.position(v));
  }
  for (TriangleId t = 0; t < patch.triangles().size(); ++t) {
    if (patch.triangles().exists(t)) mesh.triangles.push_back(patch.triangles()[t]);
  }
  return mesh;
}

void expect_connected(const GlidePatch& patch) {
  const Mesh mesh = mesh_of(patch);
  const FlippableTriangles anew(mesh.vertex_count(), mesh.triangles);
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const auto count = static_cast<int>(anew.count_around(v));
    EXPECT_EQ(patch.triangles().count_around(v), anew.count_around(v));
    if (!patch.is_free(v) || count == 0) continue;
    EXPECT_EQ(patch.excess(v), count - 6);
  }
}

// A split, and the collapse of the new edge, in all ways: the topology stays, and in the end all is
// as it was.
TEST(GlidePatch, CollapsesWhatItSplits) {
  const Mesh sphere = icosphere(642);
  const Prepared prepared = prepare(sphere, sphere);
  const std::vector<std::uint8_t> barred(sphere.vertex_count(), 0);
  const GlidingRemesh gliding(prepared.input, prepared.labels, 0, {}, barred, sphere, sequential());
  for (const VertexId centre : {0U, 100U}) {
    const GlidePatch patch(gliding, centre, 4);
    const auto added = static_cast<VertexId>(patch.vertices().size());
    const std::vector<GlidePatch::Split> splits = patch.splits_of(0);
    const std::size_t count = patch.triangles().count_around(0);
    EXPECT_EQ(splits.size(), count * (count - 3) / 2);
    for (const GlidePatch::Split& split : splits) {
      GlidePatch changed = patch;
      changed.split(split);
      expect_connected(changed);
      const auto [of_old, of_new] = patch.neighbours_split(split);
      EXPECT_EQ(changed.triangles().count_around(0), static_cast<std::size_t>(of_old));
      EXPECT_EQ(changed.triangles().count_around(added), static_cast<std::size_t>(of_new));
      const Mesh split_mesh = mesh_of(changed);
      EXPECT_EQ(split_mesh.triangle_count(), patch.triangles().size() + 2);
      const Side side = changed.triangles().side_of(0, added);
      ASSERT_TRUE(changed.can_collapse(side));
      changed.collapse(side);
      expect_connected(changed);
      EXPECT_EQ(mesh_of(changed).triangle_count(), patch.triangles().size());
      EXPECT_EQ(changed.triangles().count_around(0) + changed.triangles().count_around(added),
                count);
    }
  }
}

// Held vertices do not become one with others, nor is one split.
TEST(GlidePatch, LeavesHeldVertices) {
  const Mesh sphere = icosphere(162);
  const Prepared prepared = prepare(sphere, sphere);
  const std::vector<std::uint8_t> barred(sphere.vertex_count(), 0);
  const GlidingRemesh gliding(prepared.input, prepared.labels, sphere.vertex_count(), {}, barred,
                              sphere, sequential());
  const GlidePatch patch(gliding, 20, 3);
  EXPECT_TRUE(patch.splits_of(0).empty());
  EXPECT_TRUE(find_collapses(patch).empty());
}

TEST(GlidePaths, OfARegularVertexAreNone) {
  const Mesh mesh = lattice(16);
  const Prepared prepared = prepare(mesh, mesh);
  const std::vector<std::uint8_t> barred(mesh.vertex_count(), 0);
  const GlidingRemesh gliding(prepared.input, prepared.labels, 0, {}, barred, mesh, sequential());
  EXPECT_TRUE(find_glide_paths(GlidePatch(gliding, 8 * 16 + 8, 6)).empty());
}

// One flip makes four irregular vertices, and one flip back is the shortest way out.
TEST(GlidePaths, FindTheWayBack) {
  const Mesh mesh = with_flip(lattice(16), 8 * 16 + 8, 8 * 16 + 9);
  EXPECT_EQ(irregular_of(mesh), 4);
  const Prepared prepared = prepare(mesh, mesh);
  const std::vector<std::uint8_t> barred(mesh.vertex_count(), 0);
  const GlidingRemesh gliding(prepared.input, prepared.labels, 0, {}, barred, mesh, sequential());
  const std::vector<PatchChange> paths = find_glide_paths(GlidePatch(gliding, 8 * 16 + 8, 6));
  ASSERT_FALSE(paths.empty());
  EXPECT_EQ(paths.front().flips.size(), 1U);
}

// No flip of a path raises the sum of squares of excess, the last one lowers it, and each is one
// that the path before it leaves possible.
TEST(GlidePaths, LowerTheSumOfSquares) {
  Mesh mesh = lattice(24);
  for (VertexId v = 5 * 24 + 6; v < 18 * 24; v += 91) {
    if (v % 24 > 4 && v % 24 < 20) mesh = with_flip(mesh, v, v + 1);
  }
  const Prepared prepared = prepare(mesh, mesh);
  const std::vector<std::uint8_t> barred(mesh.vertex_count(), 0);
  const GlidingRemesh gliding(prepared.input, prepared.labels, 0, {}, barred, mesh, sequential());
  const std::vector<int> excess = excess_of(mesh);
  std::size_t paths = 0;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    if (excess[v] == 0) continue;
    const GlidePatch patch(gliding, v, 9);
    for (const PatchChange& found : find_glide_paths(patch)) {
      const FlipPath& path = found.flips;
      ++paths;
      GlidePatch walked = patch;
      int sum = 0;
      for (const auto& [b, c] : path) {
        const Side side = walked.triangles().side_of(b, c);
        ASSERT_TRUE(walked.can_flip(side));
        const auto [a, from, to, d] = walked.triangles().quad_of(side);
        const auto squares = [&walked](const std::array<VertexId, 4>& at) {
          int total = 0;
          for (const VertexId w : at) total += walked.excess(w) * walked.excess(w);
          return total;
        };
        const std::array<VertexId, 4> at = {a, from, to, d};
        const int before = squares(at);
        walked.flip(side);
        const int change = squares(at) - before;
        EXPECT_EQ(change < 0, path.back() == ascending(b, c) && &path.back()[0] == &b);
        EXPECT_LE(change, 0);
        sum += change;
      }
      EXPECT_LT(sum, 0);
    }
  }
  EXPECT_GT(paths, 4U);
}

std::size_t glide(Prepared& prepared, std::size_t held = 0,
                  std::span<const std::array<VertexId, 2>> kept = {},
                  std::vector<std::uint8_t> barred = {}) {
  barred.resize(prepared.remesh.vertex_count(), 0);
  return glide_irregular(prepared.input, prepared.labels, held, kept, barred, prepared.remesh);
}

// Flips at random places of a lattice: all are gone again, and nothing else is.
TEST(Glides, MakeALatticeRegularAgain) {
  Mesh mesh = lattice(20);
  for (const VertexId v : {5 * 20 + 5U, 5 * 20 + 14U, 13 * 20 + 6U, 14 * 20 + 13U}) {
    mesh = with_flip(mesh, v, v + 1);
  }
  Prepared prepared = prepare(mesh, mesh);
  EXPECT_EQ(irregular_of(prepared.remesh), 16);
  EXPECT_EQ(glide(prepared), 4U);
  EXPECT_EQ(irregular_of(prepared.remesh), 0);
  EXPECT_EQ(find_topology(prepared.remesh, find_edges(prepared.remesh)).parts,
            find_topology(mesh, find_edges(mesh)).parts);
}

// The flip beside the barred vertex stays; the other one is gone.
TEST(Glides, KeepClearOfWhatIsBarred) {
  constexpr VertexId barred = 5 * 20 + 5;
  const Mesh mesh =
      with_flip(with_flip(lattice(20), barred, barred + 1), 14 * 20 + 13, 14 * 20 + 14);
  Prepared prepared = prepare(mesh, mesh);
  std::vector<std::uint8_t> is_barred(mesh.vertex_count(), 0);
  is_barred[barred] = 1;
  EXPECT_EQ(glide(prepared, 0, {}, is_barred), 1U);
  EXPECT_EQ(irregular_of(prepared.remesh), 4);
}

// The 12 irregular vertices of an icosphere are those that a sphere needs.
TEST(Glides, LeaveAnIcosphere) {
  const Mesh sphere = icosphere(642);
  Prepared prepared = prepare(sphere, sphere);
  EXPECT_EQ(glide(prepared), 0U);
  EXPECT_EQ(prepared.remesh.triangles, sphere.triangles);
  EXPECT_EQ(prepared.remesh.positions, sphere.positions);
}

// As many vertices as before, fewer of them irregular, each with a part of the surface near it.
TEST(VertexMoves, LeaveFewerIrregularOnes) {
  const Mesh surface = creature(20'000, 1);
  RemeshOptions options;
  options.vertex_count = 800;
  options.fit = false;
  Mesh before = remesh(surface, options, reference_runtime()).mesh;
  Prepared prepared = prepare(surface, before);
  fit_to_surface(prepared.input, prepared.labels, 0, {}, before);
  const std::vector<std::uint8_t> barred(before.vertex_count(), 0);
  GlidingRemesh gliding(prepared.input, prepared.labels, 0, {}, barred, before, sequential());
  const VertexMoves moves = move_vertices(gliding);
  EXPECT_GT(moves.count, 0U);
  const Mesh after = with_triangles(before, gliding.triangles);
  EXPECT_LT(irregular_of(after), irregular_of(before));
  EXPECT_EQ(find_topology(after, find_edges(after)).parts,
            find_topology(before, find_edges(before)).parts);
  relabel_moved(prepared.input.fine, gliding, moves.moved, prepared.labels);
  const std::set<RegionId> labels(prepared.labels.begin(), prepared.labels.end());
  EXPECT_EQ(labels.size(), before.vertex_count());
  for (const VertexId v : moves.moved) {
    for (VertexId p = 0; p < prepared.labels.size(); ++p) {
      if (prepared.labels[p] != v) continue;
      EXPECT_LT(norm(prepared.input.fine.positions[p] - gliding.positions[v]), gliding.fit.side);
    }
  }
  GlidingRemesh held(prepared.input, prepared.labels, before.vertex_count(), {}, barred, before,
                     sequential());
  EXPECT_EQ(move_vertices(held).count, 0U);
}

// What is kept is not flipped back, where else that would make the lattice regular.
TEST(Glides, FlipNoEdgeThatIsKept) {
  const Mesh mesh = with_flip(lattice(16), 7 * 16 + 7, 7 * 16 + 8);
  const MeshEdges edges = find_edges(mesh);
  Prepared prepared = prepare(mesh, mesh);
  const std::size_t all = mesh.vertex_count();
  EXPECT_EQ(glide(prepared, all, edges.ends), 0U);
  EXPECT_EQ(prepared.remesh.triangles, mesh.triangles);
  EXPECT_EQ(glide(prepared, all), 1U);
  EXPECT_EQ(irregular_of(prepared.remesh), 0);
  EXPECT_EQ(prepared.remesh.positions, mesh.positions);
}

Remesh remesh_of_600(const Mesh& mesh, bool fit) {
  RemeshOptions options;
  options.vertex_count = 600;
  options.fit = fit;
  return remesh(mesh, options, reference_runtime());
}

TEST(Glides, MakeRemeshesMoreRegular) {
  for (const Mesh& mesh : {creature(20'000, 1), pierced_plate(0.5, 0.3, 64)}) {
    const Remesh without = remesh_of_600(mesh, false);
    const Remesh with = remesh_of_600(mesh, true);
    EXPECT_EQ(without.glides, 0U);
    EXPECT_GT(with.glides, 0U);
    EXPECT_LT(irregular_of(with.mesh), irregular_of(without.mesh));
    EXPECT_EQ(with.topology.parts, without.topology.parts);
    EXPECT_TRUE(with.has_input_topology());
    EXPECT_LE(with.distance_after_fit, with.distance_before_fit);
    const MeshEdges edges = find_edges(with.mesh);
    for (const auto& edge : with.feature_edges) {
      EXPECT_TRUE(std::binary_search(edges.ends.begin(), edges.ends.end(), edge));
    }
  }
}

}  // namespace
}  // namespace geolloyd

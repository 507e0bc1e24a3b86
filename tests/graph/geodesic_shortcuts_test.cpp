#include "core/graph/geodesic_shortcuts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "core/base/vec3.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

struct FoundWay {
  VertexId from;
  VertexId to;
  double length;
  std::vector<StraightPiece> pieces;
};

std::vector<FoundWay> all_ways(const Mesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  const GeodesicShortcuts ways(mesh, edges, sequential());
  std::vector<FoundWay> found;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    ways.visit(v, [&](const GeodesicShortcut& way) {
      FoundWay& last = found.emplace_back(FoundWay{way.from, way.to, way.length, {}});
      ways.visit_pieces(way, [&](const StraightPiece& piece) { last.pieces.push_back(piece); });
    });
  }
  return found;
}

// A plane folded at each column of its vertices, by a right angle there and back.
Mesh folded(Mesh plane, std::uint32_t cells) {
  for (std::size_t v = 0; v < plane.vertex_count(); ++v) {
    const auto column = static_cast<double>(v % (cells + 1));
    plane.positions[v].x() = column / cells * std::sqrt(0.5);
    plane.positions[v].z() = std::fmod(column, 2) / cells * std::sqrt(0.5);
  }
  return plane;
}

TEST(GeodesicShortcuts, AreStraightOnAPlane) {
  const Mesh mesh = irregular_plane(800, 1);
  const std::vector<FoundWay> ways = all_ways(mesh);
  EXPECT_GT(ways.size(), 10 * mesh.vertex_count());
  for (const FoundWay& way : ways) {
    const Vec3 chord = mesh.positions[way.to] - mesh.positions[way.from];
    EXPECT_NEAR(way.length, norm(chord), 1e-12);
    EXPECT_LT(way.from, way.to);
    EXPECT_GE(way.pieces.size(), 2U);
    EXPECT_LE(way.pieces.size(), std::size_t{most_crossings} + 1);
    Vec3 sum = Vec3::Zero();
    for (const StraightPiece& piece : way.pieces) {
      EXPECT_GT(dot(piece.displacement, chord), 0);
      EXPECT_LT(norm(cross(piece.displacement, chord)), 1e-12);
      sum += piece.displacement;
    }
    EXPECT_LT(norm(sum - chord), 1e-14);
  }
}

TEST(GeodesicShortcuts, AreFoundOnce) {
  std::set<std::array<VertexId, 2>> seen;
  for (const FoundWay& way : all_ways(irregular_plane(800, 1))) {
    EXPECT_TRUE(seen.insert({way.from, way.to}).second) << way.from << ' ' << way.to;
  }
}

// By brute force: pairs of vertices between which the straight line has no other vertex within a
// detour, and crosses at most so many edges.
TEST(GeodesicShortcuts, AreAllThereAreOnAPlane) {
  const Mesh mesh = irregular_plane(128, 3);
  const MeshEdges edges = find_edges(mesh);
  const auto side = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return cross(b - a, c - a).z() > 0;
  };
  std::set<std::array<VertexId, 2>> expected;
  for (VertexId a = 0; a < mesh.vertex_count(); ++a) {
    for (VertexId b = a + 1; b < mesh.vertex_count(); ++b) {
      const Vec3& from = mesh.positions[a];
      const Vec3& to = mesh.positions[b];
      int crossings = 0;
      bool has_detour = false;
      for (const auto& [c, d] : edges.ends) {
        if (c == a || d == a || c == b || d == b) continue;
        const Vec3& right = mesh.positions[c];
        const Vec3& left = mesh.positions[d];
        if (side(from, to, right) == side(from, to, left) ||
            side(right, left, from) == side(right, left, to)) {
          continue;
        }
        ++crossings;
        for (const Vec3& by : {right, left}) {
          has_detour |= norm(by - from) + norm(to - by) < (1 + least_detour) * norm(to - from);
        }
      }
      if (crossings > 0 && crossings <= most_crossings && !has_detour) expected.insert({a, b});
    }
  }
  std::set<std::array<VertexId, 2>> found;
  for (const FoundWay& way : all_ways(mesh)) found.insert({way.from, way.to});
  // On the boundary a straight line may leave the surface between two vertices, but not here: the
  // square is convex.
  EXPECT_EQ(found, expected);
}

TEST(GeodesicShortcuts, AreAsLongOnFoldsAsOnThePlane) {
  constexpr std::uint32_t cells = 12;
  const Mesh plane = irregular_plane(2 * cells * cells, 1);
  Mesh flat = folded(plane, cells);
  for (std::size_t v = 0; v < flat.vertex_count(); ++v) {
    flat.positions[v].x() *= std::sqrt(2.0);
    flat.positions[v].z() = 0;
  }
  const std::vector<FoundWay> on_folds = all_ways(folded(plane, cells));
  const std::vector<FoundWay> on_plane = all_ways(flat);
  ASSERT_EQ(on_folds.size(), on_plane.size());
  for (std::size_t i = 0; i < on_folds.size(); ++i) {
    EXPECT_EQ(on_folds[i].to, on_plane[i].to);
    EXPECT_NEAR(on_folds[i].length, on_plane[i].length, 1e-12);
    double sum = 0;
    for (const StraightPiece& piece : on_folds[i].pieces) sum += norm(piece.displacement);
    EXPECT_NEAR(sum, on_folds[i].length, 1e-12);
  }
}

// Three triangles at one edge, in three directions.
TEST(GeodesicShortcuts, DoNotCrossEdgesOfThreeTriangles) {
  const Mesh book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 1, 0.5}, {-1, -1, 0.5}},
                  {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  EXPECT_TRUE(all_ways(book).empty());
}

TEST(GeodesicShortcuts, CrossTrianglesOfEitherOrientation) {
  Mesh mesh = irregular_plane(200, 1);
  const std::size_t count = all_ways(mesh).size();
  for (std::size_t t = 0; t < mesh.triangle_count(); t += 3) {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  EXPECT_EQ(all_ways(mesh).size(), count);
}

// Triangles without area, edges without length, all vertices in one place.
TEST(GeodesicShortcuts, HaveLengthsThatAreNumbersOnDegenerateMeshes) {
  for (Mesh mesh : {irregular_plane(200, 1), icosphere(80)}) {
    for (const double scale : {0.0, 1e-75, 1e75}) {
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        mesh.positions[v] = Vec3(v % 3 == 0 ? 0 : scale, v % 5 == 0 ? scale : 0, 0);
      }
      for (const FoundWay& way : all_ways(mesh)) {
        EXPECT_TRUE(std::isfinite(way.length));
        for (const StraightPiece& piece : way.pieces) {
          EXPECT_TRUE(std::isfinite(norm(piece.displacement)));
        }
      }
    }
  }
}

}  // namespace
}  // namespace geolloyd

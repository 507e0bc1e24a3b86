#include "core/mesh/subdivide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"
#include "tests/support/doubled_area.h"

namespace geolloyd {
namespace {

// 2---3      Edge 1-3 has a third triangle, 3 1 5, behind the picture: it is not manifold.
// |\  |\     .
// | \ | 4
// |  \|/
// 0---1
Mesh fin() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {6, 6, 0}, {9, 3, 3}, {6, 3, -6}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}, {1, 4, 3}, {3, 1, 5}};
  return mesh;
}

// Every triangle of `mesh` lies in `pieces` consecutive ones of `fine`, equal in size, that look
// the same way.
void expect_cut_evenly(const Mesh& mesh, const Mesh& fine, std::size_t pieces) {
  ASSERT_EQ(fine.triangle_count(), mesh.triangle_count() * pieces);
  for (std::size_t t = 0; t < fine.triangle_count(); ++t) {
    const Vec3 whole = doubled_area(mesh, mesh.triangles[t / pieces]);
    const Vec3 piece = doubled_area(fine, fine.triangles[t]) * static_cast<double>(pieces);
    ASSERT_LE(norm(piece - whole), 1e-9 * norm(whole)) << "triangle " << t;
  }
}

std::int64_t euler_characteristic(const Mesh& mesh) {
  return static_cast<std::int64_t>(mesh.vertex_count() + mesh.triangle_count()) -
         static_cast<std::int64_t>(find_edges(mesh).size());
}

std::size_t count_boundary_edges(const Mesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) count += edges.corners(e).size() == 1 ? 1 : 0;
  return count;
}

TEST(Refine, CutsATriangleInRows) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Mesh fine = refine(mesh, 3);
  const std::vector<Vec3> positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 0, 0}, {2, 0, 0},
                                       {0, 1, 0}, {0, 2, 0}, {2, 1, 0}, {1, 2, 0}, {1, 1, 0}};
  EXPECT_EQ(fine.positions, positions);
  const std::vector<Triangle> triangles = {{0, 3, 5}, {3, 4, 9}, {3, 9, 5}, {5, 9, 6}, {4, 1, 7},
                                           {4, 7, 9}, {9, 7, 8}, {9, 8, 6}, {6, 8, 2}};
  EXPECT_EQ(fine.triangles, triangles);
}

TEST(Refine, NumbersEdgePointsFromTheSmallerEndInOrderOfEdge) {
  const Mesh mesh = fin();
  const MeshEdges edges = find_edges(mesh);
  const std::uint32_t frequency = 6;
  const Mesh fine = refine(mesh, frequency);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Vec3& low = mesh.positions[edges.ends[e][0]];
    const Vec3& high = mesh.positions[edges.ends[e][1]];
    for (std::uint32_t k = 1; k < frequency; ++k) {
      const Vec3& point = fine.positions[mesh.vertex_count() + e * (frequency - 1) + k - 1];
      EXPECT_EQ(point, low + (high - low) * k / frequency);
    }
  }
}

TEST(Refine, KeepsSurfaceOrientationAndTopology) {
  const std::vector<Mesh> meshes = {fin(), torus(1, 1), icosphere(1), irregular_plane(40, 2)};
  for (const Mesh& mesh : meshes) {
    for (const std::uint32_t f : {1U, 2U, 3U, 4U, 7U}) {
      const Mesh fine = refine(mesh, f);
      expect_cut_evenly(mesh, fine, std::size_t{f} * f);
      const std::size_t edges = find_edges(mesh).size();
      const std::size_t inner = (f - 1) * (f - 2) / 2;
      EXPECT_EQ(fine.vertex_count(),
                mesh.vertex_count() + edges * (f - 1) + mesh.triangle_count() * inner);
      EXPECT_EQ(euler_characteristic(fine), euler_characteristic(mesh));
      EXPECT_EQ(count_boundary_edges(fine), f * count_boundary_edges(mesh));
      EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), fine.positions.begin()));
    }
  }
}

TEST(Refine, ByOneChangesNothing) {
  const Mesh mesh = fin();
  const Mesh same = refine(mesh, 1);
  EXPECT_EQ(same.positions, mesh.positions);
  EXPECT_EQ(same.triangles, mesh.triangles);
}

TEST(Refine, ComposesByMultiplication) {
  const Mesh mesh = icosphere(1);
  const Mesh twice = refine(refine(mesh, 2), 3);
  const Mesh once = refine(mesh, 6);
  EXPECT_EQ(twice.triangle_count(), once.triangle_count());
  EXPECT_EQ(twice.vertex_count(), once.vertex_count());
}

TEST(SubdivideMidpoint, CutsInFour) {
  const Mesh mesh = fin();
  const Mesh fine = subdivide_midpoint(mesh);
  expect_cut_evenly(mesh, fine, 4);
  EXPECT_EQ(fine.vertex_count(), mesh.vertex_count() + find_edges(mesh).size());
}

TEST(SubdivideBarycentric, CutsInSix) {
  for (const Mesh& mesh : {fin(), icosphere(1), irregular_plane(40, 2)}) {
    const Mesh fine = subdivide_barycentric(mesh);
    expect_cut_evenly(mesh, fine, 6);
    const std::size_t edge_count = find_edges(mesh).size();
    EXPECT_EQ(fine.vertex_count(), mesh.vertex_count() + edge_count + mesh.triangle_count());
    EXPECT_EQ(euler_characteristic(fine), euler_characteristic(mesh));
    EXPECT_EQ(count_boundary_edges(fine), 2 * count_boundary_edges(mesh));
  }
}

TEST(SubdivideBarycentric, PutsBarycentresLast) {
  const Mesh mesh = fin();
  const Mesh fine = subdivide_barycentric(mesh);
  const std::size_t first = fine.vertex_count() - mesh.triangle_count();
  EXPECT_EQ(fine.positions[first], Vec3(2, 2, 0));
  EXPECT_EQ(fine.positions[first + 1], Vec3(4, 4, 0));
  EXPECT_EQ(fine.positions[first + 2], Vec3(7, 3, 1));
}

TEST(Subdivide, DropsTrianglesNamingAVertexTwice) {
  Mesh mesh = fin();
  const Mesh clean = refine(mesh, 3);
  const Mesh clean_barycentric = subdivide_barycentric(mesh);
  mesh.triangles.insert(mesh.triangles.begin() + 1, {4, 0, 4});
  EXPECT_EQ(refine(mesh, 3).positions, clean.positions);
  EXPECT_EQ(refine(mesh, 3).triangles, clean.triangles);
  EXPECT_EQ(subdivide_barycentric(mesh).positions, clean_barycentric.positions);
  EXPECT_EQ(subdivide_barycentric(mesh).triangles, clean_barycentric.triangles);
}

TEST(Subdivide, KeepsAnEmptyMeshEmpty) {
  EXPECT_EQ(refine({}, 5).vertex_count(), 0U);
  EXPECT_EQ(subdivide_barycentric({}).triangle_count(), 0U);
}

TEST(Refine, RefusesImpossibleFrequencies) {
  const Mesh mesh = icosphere(1);
  EXPECT_THROW(refine(mesh, 0), InvalidInput);
  EXPECT_THROW(refine(mesh, 8'461), InvalidInput);  // 3 * 20 * 8461^2 just exceeds 2^32
  EXPECT_THROW(refine(mesh, 65'536), InvalidInput);
  EXPECT_THROW(refine(mesh, no_id), InvalidInput);
}

// The mesh folder may not be redistributed, so it is not everywhere.
TEST(Subdivide, GivesTheCountsOfTheHighResolutionHippo) {
  const auto path = std::filesystem::path(GEOLLOYD_SHARED_MESHES) / "hippo.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const Mesh hippo = subdivide_barycentric(subdivide_midpoint(read(path).mesh));
  EXPECT_EQ(hippo.vertex_count(), 706'244U);
  EXPECT_EQ(find_edges(hippo).size(), 2'118'692U);
  EXPECT_EQ(hippo.triangle_count(), 1'412'448U);
}

}  // namespace
}  // namespace geolloyd

// Split vertices are welded where that makes surfaces whole, and nowhere else.
#include "core/seams/stitching.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/topology.h"

namespace geolloyd {
namespace {

using Parts = std::vector<PartTopology>;

constexpr PartTopology closed_part{2, 0};
constexpr PartTopology disc_part{1, 1};

// Each triangle with vertices of its own.
Mesh split_soup(const Mesh& mesh) {
  Mesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<VertexId>(soup.vertex_count());
    for (const VertexId v : t) soup.positions.push_back(mesh.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

// A box each of whose sides has four vertices of its own.
Mesh box_of_sides() {
  Mesh box;
  const Mesh whole = flat_box(1);
  for (std::size_t t = 0; t < whole.triangle_count(); t += 2) {
    append(box, {whole.positions, {whole.triangles[t], whole.triangles[t + 1]}});
  }
  return box;
}

Mesh welded(Mesh mesh) {
  const std::vector<VertexId> to = find_split_vertices(mesh);
  if (!to.empty()) rename_vertices(mesh, to);
  return mesh;
}

Parts welded_parts(const Mesh& mesh) {
  const MeshTopology topology = topology_of(welded(mesh));
  EXPECT_TRUE(topology.is_manifold());
  return topology.parts;
}

TEST(FindSplitVertices, FindsNoneWhereAllPlacesDiffer) {
  for (const Mesh& mesh : {icosphere(2'000), bow_tie(), book(), irregular_plane(2'000, 3)}) {
    EXPECT_TRUE(find_split_vertices(mesh).empty());
  }
}

TEST(FindSplitVertices, MakesSurfacesWhole) {
  EXPECT_EQ(welded_parts(split_soup(icosphere(320))), Parts{closed_part});
  EXPECT_EQ(welded_parts(box_of_sides()), Parts{closed_part});
  // A sheet rolled to a tube, with more boundary loops than the sheet.
  const Mesh sheet = grid_surface(12, 3, false, false, false, [](double along, double across) {
    return on_ring(along < 1 ? along : 0, 1, across);
  });
  EXPECT_EQ(welded_parts(sheet), (Parts{{0, 2}}));
}

TEST(FindSplitVertices, LeavesClosedSurfacesApartThatTouch) {
  for (const Vec3& by : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(0, 0, 0)}) {
    Mesh mesh = flat_box(1);
    append(mesh, moved(flat_box(1), by));
    EXPECT_TRUE(find_split_vertices(mesh).empty()) << by.transpose();
  }
}

// Split themselves, they come back as two: the edge where they touch belongs to both.
TEST(FindSplitVertices, MakesTwoBoxesWholeThatShareAnEdge) {
  Mesh mesh = box_of_sides();
  append(mesh, moved(box_of_sides(), {1, 1, 0}));
  EXPECT_EQ(welded_parts(mesh), (Parts{closed_part, closed_part}));
}

// The sides on each other stay apart, as nothing says which belongs to which box.
TEST(FindSplitVertices, MakesNoEdgeOfFourTriangles) {
  Mesh mesh = box_of_sides();
  append(mesh, moved(box_of_sides(), {1, 0, 0}));
  EXPECT_EQ(welded_parts(mesh), (Parts{disc_part, disc_part, disc_part, disc_part}));
}

TEST(FindSplitVertices, LeavesFrontAndBackOfASheetApart) {
  for (const Mesh& front : {irregular_plane(200, 1), one_triangle(), square_of_two_triangles()}) {
    Mesh mesh = front;
    for (Triangle t : front.triangles) {
      for (VertexId& v : t) v += static_cast<VertexId>(front.vertex_count());
      mesh.triangles.push_back({t[0], t[2], t[1]});
    }
    mesh.positions.insert(mesh.positions.end(), front.positions.begin(), front.positions.end());
    EXPECT_TRUE(find_split_vertices(mesh).empty());
  }
}

TEST(FindSplitVertices, LeavesThreeSheetsAtAnEdgeApart) {
  EXPECT_TRUE(find_split_vertices(split_soup(book())).empty());
}

// What is no manifold already stays as it is, and does not keep the rest from being welded.
TEST(FindSplitVertices, WorksBesideWhatIsNoManifold) {
  Mesh mesh = book();
  append(mesh, moved(split_soup(icosphere(80)), {9, 0, 0}));
  const MeshTopology topology = topology_of(welded(mesh));
  EXPECT_EQ(topology.non_manifold_edges, 1U);
  EXPECT_EQ(topology.parts.size(), 2U);
}

}  // namespace
}  // namespace geolloyd

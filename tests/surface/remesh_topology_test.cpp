// Every surface remesh is a manifold like its input, by a test of its own of what that is
// (walked_topology.h): on surfaces that are thin, in many parts, full of holes or no manifolds,
// and, as a long test, on all generated meshes and the thesis's.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_topology.h"
#include "core/mesh/subdivide.h"
#include "core/surface/result/remesh.h"
#include "geolloyd/threads.h"
#include "parallel/threads/scheduler.h"
#include "tests/support/odd_surfaces.h"
#include "tests/support/walked_topology.h"

namespace geolloyd {
namespace {

using Parts = std::vector<std::array<std::int64_t, 2>>;

Parts parts_of(const std::vector<PartTopology>& parts) {
  Parts found;
  for (const PartTopology& part : parts) {
    found.push_back({part.euler_characteristic, static_cast<std::int64_t>(part.boundary_loops)});
  }
  return found;
}

bool is_on_its_triangle(const Mesh& mesh, const SurfacePoint& place, const Vec3& position,
                        double size) {
  if (place.triangle >= mesh.triangle_count()) return false;
  double sum = 0;
  Vec3 p = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(place.barycentric[c] >= 0)) return false;
    sum += place.barycentric[c];
    p += place.barycentric[c] * mesh.positions[mesh.triangles[place.triangle][c]];
  }
  return std::abs(sum - 1) < 1e-12 && (p - position).norm() <= 1e-12 * size;
}

std::size_t count_astray(const Mesh& mesh, const Remesh& remesh) {
  double size = 0;
  for (const Vec3& p : mesh.positions) size = std::max(size, p.norm());
  std::size_t astray = 0;
  for (std::size_t v = 0; v < remesh.places.size(); ++v) {
    if (!is_on_its_triangle(mesh, remesh.places[v], remesh.mesh.positions[v], size)) ++astray;
  }
  return astray;
}

Remesh remesh_of(const Mesh& mesh, std::size_t vertices, Scheduler& scheduler) {
  RemeshOptions options;
  options.fit = false;  // which would leave each vertex near its triangle only
  options.vertex_count = vertices;
  Threads runtime(scheduler);
  return make_remesh(mesh, find_edges(mesh), options, runtime);
}

void check_remesh(const Mesh& mesh, const Parts& parts, const Remesh& remesh,
                  std::size_t vertices) {
  const WalkedTopology found = walk_topology(remesh.mesh);
  EXPECT_EQ(found.flaw, "");
  EXPECT_EQ(found.parts, parts);
  EXPECT_EQ(parts_of(remesh.surface_parts), parts);
  EXPECT_TRUE(remesh.has_input_topology());
  EXPECT_GE(remesh.mesh.vertex_count(), vertices);
  EXPECT_EQ(remesh.places.size(), remesh.mesh.vertex_count());
  EXPECT_EQ(count_astray(mesh, remesh), 0U);
}

// Where the input is no manifold: the parts that it was cut into.
void remesh_and_check(const Mesh& mesh, const std::vector<std::size_t>& counts) {
  const WalkedTopology input = walk_topology(mesh);
  Scheduler scheduler;
  for (const std::size_t vertices : counts) {
    SCOPED_TRACE(std::to_string(vertices) + " vertices");
    const Remesh remesh = remesh_of(mesh, vertices, scheduler);
    const bool is_manifold = input.flaw.empty();
    check_remesh(mesh, is_manifold ? input.parts : parts_of(remesh.surface_parts), remesh,
                 vertices);
    const bool is_oriented = find_topology(mesh, find_edges(mesh)).inconsistent_edges == 0;
    EXPECT_TRUE(!is_oriented || remesh.topology.inconsistent_edges == 0);
  }
}

TEST(WalkedTopology, KnowsManifolds) {
  EXPECT_EQ(walk_topology(tetrahedron()).parts, (Parts{{2, 0}}));
  EXPECT_EQ(walk_topology(flat_box(0.1)).parts, (Parts{{2, 0}}));
  EXPECT_EQ(walk_topology(one_triangle()).parts, (Parts{{1, 1}}));
  EXPECT_EQ(walk_topology(thin_torus(0.1)).parts, (Parts{{0, 0}}));
  EXPECT_EQ(walk_topology(annulus(0.5)).parts, (Parts{{0, 2}}));
  EXPECT_EQ(walk_topology(small_moebius_strip()).parts, (Parts{{0, 1}}));
  EXPECT_EQ(walk_topology(two_sheets(0.1)).parts, (Parts{{1, 1}, {1, 1}}));
  EXPECT_EQ(walk_topology(plane_with_subresolution_holes(250)).parts, (Parts{{-249, 251}}));
  EXPECT_EQ(walk_topology(sphere_with_satellites(50)).parts, Parts(51, {2, 0}));
}

TEST(WalkedTopology, KnowsWhatIsNoManifold) {
  EXPECT_EQ(walk_topology(book()).flaw, "an edge has 3 triangles");
  EXPECT_EQ(walk_topology(bow_tie()).flaw, "the triangles of vertex 0 are no fan");
  Mesh mesh = one_triangle();
  mesh.triangles.push_back({2, 1, 0});
  EXPECT_EQ(walk_topology(mesh).flaw, "two triangles have the same vertices");
  mesh.triangles = {{0, 1, 1}};
  EXPECT_EQ(walk_topology(mesh).flaw, "a triangle names a vertex twice");
  mesh = one_triangle();
  mesh.positions.push_back(Vec3::Zero());
  EXPECT_EQ(walk_topology(mesh).flaw, "vertex 3 has no triangle");
  mesh = tetrahedron();  // two tetrahedra that share a vertex
  append(mesh, tetrahedron());
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = v == 7 ? 0 : v;
  }
  mesh.positions.pop_back();
  EXPECT_EQ(walk_topology(mesh).flaw, "the triangles of vertex 0 are no fan");
}

struct OddSurface {
  std::string name;
  std::function<Mesh()> make;
  std::vector<std::size_t> counts = {4, 10, 64, 300};
};

std::ostream& operator<<(std::ostream& out, const OddSurface& surface) {
  return out << surface.name;
}

std::string name_of_surface(const testing::TestParamInfo<OddSurface>& instance) {
  return instance.param.name;
}

std::vector<OddSurface> odd_surfaces() {
  std::vector<OddSurface> surfaces = {
      {"EllipsoidOfOneHundredth",
       [] {
         return scaled(icosphere(2'000), {1, 1, 0.01});
       }},
      {"ThinTorus", [] { return thin_torus(0.02); }},
      {"FiftySatellites", [] { return sphere_with_satellites(50); }},
      {"TwoSheets", [] { return two_sheets(0.001); }},
      {"Book", book},
      {"BowTie", bow_tie},
      {"MoebiusStrip", small_moebius_strip},
      {"OneTriangle", one_triangle},
      {"TwoTriangles", square_of_two_triangles},
      {"Tetrahedron", tetrahedron},
      {"ThinAnnulus", [] { return annulus(0.99); }},
      {"SubresolutionHoles", [] { return plane_with_subresolution_holes(250); }, {64, 2048}},
      {"Creature", [] { return creature(4'000, 1); }, {64, 2048}},
      {"Torus", [] { return torus(2'000, 1); }, {10, 64, 300}},
      {"Tube", [] { return cylinder(2'000, 1); }, {10, 64, 300}},
  };
  for (const int denominator : {10, 100, 1000}) {
    const double thickness = 1.0 / denominator;
    const std::string name = "BoxOfOne" + std::to_string(denominator) + "th";
    surfaces.push_back({name, [=] { return flat_box(thickness); }});
    surfaces.push_back({"Fine" + name, [=] { return refine(flat_box(thickness), 16); }});
  }
  return surfaces;
}

class RemeshOfAnOddSurface : public testing::TestWithParam<OddSurface> {};

TEST_P(RemeshOfAnOddSurface, IsAManifoldLikeIt) {
  remesh_and_check(GetParam().make(), GetParam().counts);
}

INSTANTIATE_TEST_SUITE_P(All, RemeshOfAnOddSurface, testing::ValuesIn(odd_surfaces()),
                         name_of_surface);

// Each page of the book is a part of its own, and each wing of the tie.
TEST(RemeshOfWhatIsNoManifold, IsThatOfItsPieces) {
  Scheduler scheduler;
  const Remesh of_book = remesh_of(book(), 64, scheduler);
  check_remesh(book(), {{1, 1}, {1, 1}, {1, 1}}, of_book, 64);
  EXPECT_GT(of_book.vertices_cut, 0U);
  const Remesh of_tie = remesh_of(bow_tie(), 64, scheduler);
  check_remesh(bow_tie(), {{1, 1}, {1, 1}}, of_tie, 64);
  EXPECT_EQ(of_tie.vertices_cut, 1U);
}

// Sites of one sheet never own a vertex of the other: each remeshed triangle is in one plane.
TEST(RemeshOfTwoSheets, JoinsThemNowhere) {
  const Mesh mesh = two_sheets(0.001);
  Scheduler scheduler;
  const Remesh remesh = remesh_of(mesh, 300, scheduler);
  for (const Triangle& t : remesh.mesh.triangles) {
    const double z = remesh.mesh.positions[t[0]].z();
    EXPECT_TRUE(z == 0 || std::abs(z - 0.001) < 1e-12);
    for (const VertexId v : t) EXPECT_NEAR(remesh.mesh.positions[v].z(), z, 1e-12);
  }
}

// CAD parts and models with split vertices, needles, thin walls and handles smaller than a
// triangle: sites that are inserted for those make others give way.
TEST(RemeshOfHardMeshes, AreManifoldsLikeThem) {
  const std::filesystem::path folder = std::filesystem::path(GEOLLOYD_SHARED_MESHES) / "hard";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  Scheduler scheduler;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (name == "README.md" || name == "twin_needles.obj") continue;  // that one takes longest
    const Mesh mesh = read(file.path()).mesh;
    for (const std::size_t vertices : {300U, 2000U}) {
      const Remesh remesh = remesh_of(mesh, vertices, scheduler);
      EXPECT_TRUE(remesh.has_input_topology()) << name << " " << vertices;
      EXPECT_EQ(walk_topology(remesh.mesh).flaw, "") << name << " " << vertices;
    }
  }
}

struct LargeSurface {
  std::string name;
  std::function<Mesh()> make;
  std::string file;  // instead, of the thesis
};

std::ostream& operator<<(std::ostream& out, const LargeSurface& surface) {
  return out << surface.name;
}

const std::vector<LargeSurface> large_surfaces = {
    {"Creature", [] { return creature(200'000, 1); }, ""},
    {"Plane", [] { return irregular_plane(100'000, 1); }, ""},
    {"Icosphere", [] { return icosphere(100'000); }, ""},
    {"Torus", [] { return torus(100'000, 1); }, ""},
    {"Cylinder", [] { return cylinder(100'000, 1); }, ""},
    {"Bunny", {}, "bunny.ply"},
    {"Camelhead", {}, "camelhead.off"},
    {"Fandisk", {}, "fandisk.obj"},
    {"Hippo", {}, "hippo.ply"},
    {"HippoHires", {}, "hippo_hires.ply"},
    {"RockerArm", {}, "rocker-arm.obj"},
};

class RemeshOfALargeSurface : public testing::TestWithParam<LargeSurface> {};

TEST_P(RemeshOfALargeSurface, IsAManifoldLikeIt) {
  if (std::getenv("GEOLLOYD_LONG_TESTS") == nullptr) {
    GTEST_SKIP() << "a minute each: set GEOLLOYD_LONG_TESTS";
  }
  const std::filesystem::path file =
      std::filesystem::path(GEOLLOYD_SHARED_MESHES) / GetParam().file;
  const bool is_generated = GetParam().file.empty();
  if (!is_generated && !std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  remesh_and_check(is_generated ? GetParam().make() : read(file).mesh,
                   {64, 300, 2048, 10'000, 100'000});
}

INSTANTIATE_TEST_SUITE_P(All, RemeshOfALargeSurface, testing::ValuesIn(large_surfaces),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace geolloyd

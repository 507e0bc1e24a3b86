#include "core/voronoi/ball_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/vec3.h"
#include "core/graph/arc_length.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"

namespace geolloyd {
namespace {

// Axes along no edges of the mesh.
const TangentSpace oblique{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, 1, 1};

MeshGraph graph_of(const Mesh& mesh, GraphKind kind, Norm norm_kind) {
  return make_mesh_graph(
      mesh, find_edges(mesh),
      {kind, norm_kind, std::vector<TangentSpace>(mesh.vertex_count(), oblique)});
}

BallError error_of(const Mesh& mesh, const MeshGraph& made, Norm norm_kind, double scale = 1) {
  NodeId source = 0;
  for (NodeId v = 0; v < made.position.size(); ++v) {
    const Vec3 middle(0.5, 0.5, 0);
    if (norm(made.position[v] - middle) < norm(made.position[source] - middle)) source = v;
  }
  return measure_ball_error(mesh, made, source, 0.3, [&](const Vec3& a, const Vec3& b) {
    return scale * measure(Vec3(b - a), oblique, norm_kind);
  });
}

TEST(BallError, IsSmallOnTheFarGraphInEachNorm) {
  const Mesh mesh = irregular_plane(10'000, 1);
  for (const Norm norm_kind : {Norm::geodesic, Norm::manhattan, Norm::linf}) {
    const BallError error =
        error_of(mesh, graph_of(mesh, GraphKind::vertex_far, norm_kind), norm_kind);
    EXPECT_LT(std::abs(error.area), 0.02) << static_cast<int>(norm_kind);
    EXPECT_LT(error.symmetric_difference, 0.02) << static_cast<int>(norm_kind);
  }
}

TEST(BallError, IsLargerOnTheVertexGraph) {
  const Mesh mesh = irregular_plane(10'000, 1);
  for (const Norm norm_kind : {Norm::geodesic, Norm::manhattan, Norm::linf}) {
    const BallError error = error_of(mesh, graph_of(mesh, GraphKind::vertex, norm_kind), norm_kind);
    EXPECT_LT(error.area, -0.04) << static_cast<int>(norm_kind);
    EXPECT_GE(error.symmetric_difference, -error.area - 1e-12);
  }
}

// A ball of half the radius lies within: a quarter of its area.
TEST(BallError, KnowsAnotherBall) {
  const Mesh mesh = irregular_plane(10'000, 1);
  const MeshGraph made = graph_of(mesh, GraphKind::vertex_far, Norm::linf);
  const BallError error = error_of(mesh, made, Norm::linf, 2);
  EXPECT_NEAR(error.area, 3, 0.1);
  EXPECT_NEAR(error.symmetric_difference, 3, 0.1);
}

TEST(BallError, OfGraphsWithoutVerticesGoesByTriangles) {
  const Mesh mesh = irregular_plane(10'000, 1);
  const BallError error =
      error_of(mesh, graph_of(mesh, GraphKind::triangle_dense, Norm::linf), Norm::linf);
  EXPECT_LT(error.symmetric_difference, 0.25);
  EXPECT_GT(error.symmetric_difference, 0.01);
}

}  // namespace
}  // namespace geolloyd

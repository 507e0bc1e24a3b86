#include "core/surface/sizing/field_metric.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/shapes/shapes.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/surface/result/remesh.h"
#include "geolloyd/errors.h"
#include "geolloyd/quality.h"
#include "tests/support/surface.h"

namespace geolloyd {
namespace {

const Vec3 first_axis = Vec3(1, 2, 2) / 3;
const Vec3 second_axis = Vec3(2, 1, -2) / 3;

std::vector<Metric> shapes_of_one(const TangentSpace& space) {
  return shapes_of(std::array{space});
}

TEST(FieldMetric, OfEqualMagnitudesIsRound) {
  const Metric shape = shapes_of_one({first_axis, second_axis, 5, 5})[0];
  for (std::uint64_t n = 0; n < 20; ++n) {
    const Vec3 v = random_point(1, n);
    EXPECT_NEAR(shape.length(v), norm(v), 1e-14);
  }
}

TEST(FieldMetric, StretchesByTheRatioOfMagnitudes) {
  const Metric shape = shapes_of_one({first_axis, second_axis, 8, 2})[0];
  EXPECT_NEAR(shape.length(first_axis), 2, 1e-14);
  EXPECT_NEAR(shape.length(second_axis), 0.5, 1e-14);
  EXPECT_NEAR(shape.length(cross(first_axis, second_axis)), 1, 1e-14);
  EXPECT_NEAR(lengths_of(std::array{TangentSpace{first_axis, second_axis, 8, 2}})[0], 0.25, 1e-15);
}

// Neither signs, nor order, nor handedness of the directions matter.
TEST(FieldMetric, KnowsNoSignsAndNoOrder) {
  const Metric shape = shapes_of_one({first_axis, second_axis, 8, 2})[0];
  for (const TangentSpace& same :
       {TangentSpace{-first_axis, second_axis, 8, 2}, TangentSpace{second_axis, first_axis, 2, 8},
        TangentSpace{second_axis, -first_axis, 2, 8}}) {
    const Metric other = shapes_of_one(same)[0];
    for (std::uint64_t n = 0; n < 20; ++n) {
      const Vec3 v = random_point(1, n);
      EXPECT_NEAR(other.length(v), shape.length(v), 1e-14);
    }
  }
}

TEST(FieldMetric, IsRoundWhereDirectionsSpanNoPlane) {
  EXPECT_EQ(shapes_of_one({first_axis, first_axis, 3, 1})[0], Metric{});
  EXPECT_EQ(shapes_of_one({Vec3::Zero(), Vec3::Zero(), 3, 1})[0], Metric{});
}

TEST(FieldMetric, RefusesWhatNoCellCanFollow) {
  for (const auto& [k1, k2] :
       {std::pair{0.0, 1.0}, {1.0, 0.0}, {0.0, 0.0}, {101.0, 1.0}, {1.0, 101.0}}) {
    EXPECT_THROW(shapes_of_one({first_axis, second_axis, k1, k2}), InvalidInput) << k1 << " " << k2;
  }
  EXPECT_NO_THROW(shapes_of_one({first_axis, second_axis, 100, 1}));
  // Directions that are nearly parallel have a principal stretch of their own.
  EXPECT_THROW(shapes_of_one({first_axis, (first_axis + 1e-3 * second_axis).normalized(), 1, 1}),
               InvalidInput);
}

// In a metric that is the same everywhere, cells are those of a surface mapped by its root.
TEST(MetricCells, AreThoseOfAMappedSurface) {
  FineMesh mesh = surface_input_of(irregular_plane(800, 1)).fine;
  const Metric metric = 3 * Metric::square_of(Vec3(0.8, 0.6, 0)) +
                        1.0 / 3 * Metric::square_of(Vec3(-0.6, 0.8, 0)) +
                        Metric::square_of(Vec3::UnitZ());
  FineMesh mapped = mesh;
  const MetricRoot root(metric);
  for (Vec3& p : mapped.positions) p = root(p);
  connect(mapped);
  mesh.metric.assign(mesh.vertex_count(), metric);
  connect(mesh);

  SitedMesh sited = spread_sites(mesh, 30);
  for (std::size_t r = 0; r < sited.sites.size(); ++r) sited.sites[r] += random_point(2, r, 0.02);
  SitedMesh sited_mapped = sited;
  for (Vec3& p : sited_mapped.sites) p = root(p);
  const auto engine = make_reference_surface_engine(mesh);
  const auto engine_mapped = make_reference_surface_engine(mapped);
  engine->assign(sited.labels, sited.is_fixed);
  engine_mapped->assign(sited.labels, sited.is_fixed);
  const CellEnergies cells(mesh, engine->evaluate(sited.sites));
  const CellEnergies expected(mapped, engine_mapped->evaluate(sited_mapped.sites));
  EXPECT_EQ(engine->labels(), engine_mapped->labels());
  for (std::size_t r = 0; r < sited.sites.size(); ++r) {
    const Vec3& site = sited.sites[r];
    EXPECT_NEAR(cells.area(r), expected.area(r), 1e-13);
    EXPECT_NEAR(cells.at(r, site), expected.at(r, root(site)), 1e-13);
    EXPECT_LT(norm(cells.gradient(r, site) - root.transposed(expected.gradient(r, root(site)))),
              1e-12);
  }
}

// Energies are quadratic, so that central differences are exact but for rounding, and one step of
// Newton's method leads to the minimum.
TEST(MetricCells, HaveTheGradientAndTheMinimumOfTheirEnergies) {
  FineMesh mesh = surface_input_of(torus(1500, 1)).fine;
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    mesh.metric.push_back(0.3 * Metric{} + Metric::square_of(mesh.positions[v]));
  }
  connect(mesh);
  const SitedMesh sited = spread_sites(mesh, 20);
  const auto engine = make_reference_surface_engine(mesh);
  engine->assign(sited.labels, sited.is_fixed);
  const CellEnergies cells(mesh, engine->evaluate(sited.sites));
  for (std::size_t r = 0; r < sited.sites.size(); ++r) {
    const Vec3 site = sited.sites[r] + random_point(3, r, 0.1);
    const Vec3 gradient = cells.gradient(r, site);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = 1e-3 * Vec3::Unit(axis);
      EXPECT_NEAR((cells.at(r, site + step) - cells.at(r, site - step)) / 2e-3, gradient[axis],
                  1e-10);
    }
    const Vec3 minimum = site + cells.newton_step(r, gradient);
    EXPECT_LT(norm(cells.gradient(r, minimum)), 1e-12);
    EXPECT_LE(cells.at(r, minimum), cells.at(r, site));
  }
}

// Lengths of edges along the two axes of a plane in which x counts three times.
TEST(FieldRemesh, HasEdgesOfOneLengthInTheMetric) {
  const Mesh mesh = irregular_plane(3000, 1);
  RemeshOptions options;
  options.edge_length = 0.2;
  options.field.assign(mesh.vertex_count(), {Vec3::UnitX(), Vec3::UnitY(), 3, 1});
  const Remesh remesh = make_remesh(mesh, find_edges(mesh), options, reference_runtime());
  EXPECT_TRUE(remesh.has_input_topology());
  Mesh mapped = remesh.mesh;
  for (Vec3& p : mapped.positions) p.x() *= 3;
  const MeshQuality figures = quality(mapped);
  EXPECT_GE(figures.mean_quality, 0.92);
  EXPECT_GE(figures.smallest_angle, 25);
  EXPECT_LT(quality(remesh.mesh).mean_quality, 0.7);
  double sum = 0;
  const MeshEdges edges = find_edges(mapped);
  for (const auto& [a, b] : edges.ends) sum += norm(mapped.positions[a] - mapped.positions[b]);
  EXPECT_NEAR(sum / static_cast<double>(edges.size()), 0.2, 0.02);
  for (const double length : remesh.edge_lengths) EXPECT_NEAR(length, 0.2 / std::sqrt(3), 1e-9);
}

// A field of equal magnitudes asks for what sizes ask for.
TEST(FieldRemesh, OfARoundFieldIsThatOfItsSizes) {
  const Mesh mesh = creature(4000, 1);
  RemeshOptions by_field;
  by_field.vertex_count = 200;
  RemeshOptions by_sizes = by_field;
  for (const Vec3& p : mesh.positions) {
    const double size = 1 + 0.2 * p.x();
    by_field.field.push_back({Vec3::UnitX(), Vec3::UnitX(), 1 / size, 1 / size});
    by_sizes.sizing.edge_lengths.push_back(size);
  }
  const auto remesh = [&](const RemeshOptions& options) {
    return make_remesh(mesh, find_edges(mesh), options, reference_runtime());
  };
  const Remesh a = remesh(by_field);
  const Remesh b = remesh(by_sizes);
  ASSERT_EQ(a.edge_lengths.size(), b.edge_lengths.size());
  EXPECT_NEAR(a.energy, b.energy, 0.02 * b.energy);
}

TEST(FieldRemesh, RefusesAFieldOfAnotherMesh) {
  const Mesh mesh = icosphere(100);
  RemeshOptions options;
  options.vertex_count = 20;
  options.field.resize(mesh.vertex_count() + 1);
  EXPECT_THROW(make_remesh(mesh, find_edges(mesh), options, reference_runtime()), InvalidInput);
}

}  // namespace
}  // namespace geolloyd

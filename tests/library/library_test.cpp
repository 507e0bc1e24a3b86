// The public headers, called rightly and wrongly.
#include <geolloyd/choices.h>
#include <geolloyd/dual.h>
#include <geolloyd/errors.h>
#include <geolloyd/fields.h>
#include <geolloyd/mesh.h>
#include <geolloyd/properties.h>
#include <geolloyd/quality.h>
#include <geolloyd/relax.h>
#include <geolloyd/remesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/shapes/shapes.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

RelaxOptions with_seeds(std::size_t count) {
  RelaxOptions options;
  options.seed_count = count;
  return options;
}

Mesh two_triangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

// Everything in terms of the input: a vertex's parent is a neighbour nearer to the same seed.
TEST(Library, ATessellationSpeaksInputIds) {
  const Mesh mesh = icosphere(500);
  const Tessellation result = relax(mesh, with_seeds(12));
  ASSERT_EQ(result.regions.size(), 12U);
  ASSERT_EQ(result.region.size(), mesh.vertex_count());
  std::size_t nodes = 0;
  double energy = 0;
  for (RegionId r = 0; r < result.regions.size(); ++r) {
    EXPECT_EQ(result.region[result.regions[r].seed], r);
    EXPECT_EQ(result.distance[result.regions[r].seed], 0);
    EXPECT_EQ(result.parent[result.regions[r].seed], no_id);
    nodes += result.regions[r].nodes;
    energy += result.regions[r].energy;
  }
  EXPECT_EQ(nodes, mesh.vertex_count());
  EXPECT_NEAR(energy, result.energy, 1e-12 * energy);
  EXPECT_LE(result.energy, result.initial_energy);
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    const InputId parent = result.parent[v];
    if (parent == no_id) continue;
    EXPECT_EQ(result.region[parent], result.region[v]);
    const double edge = (mesh.positions[v] - mesh.positions[parent]).norm();
    EXPECT_NEAR(result.distance[v], result.distance[parent] + edge, 1e-6);
  }
}

TEST(Library, InTheMixedGraphTrianglesCountAfterVertices) {
  const Mesh mesh = icosphere(80);
  RelaxOptions options = with_seeds(5);
  options.graph = GraphKind::mixed;
  const Tessellation result = relax(mesh, options);
  EXPECT_EQ(result.region.size(), mesh.vertex_count() + mesh.triangle_count());
}

TEST(Library, VoronoiKeepsTheSeedsAsTheyAre) {
  const Mesh mesh = icosphere(320);
  RelaxOptions options;
  options.first_seeds = {7, 3, 100};
  const Tessellation result = voronoi(mesh, options);
  for (std::size_t r = 0; r < 3; ++r) EXPECT_EQ(result.regions[r].seed, options.first_seeds[r]);
  EXPECT_EQ(result.energy, result.initial_energy);
}

TEST(Library, FirstSeedsAreThoseOfARelaxation) {
  const Mesh mesh = torus(2000, 1);
  for (const SeedInit init : {SeedInit::random, SeedInit::farthest, SeedInit::automatic}) {
    RelaxOptions options = with_seeds(20);
    options.init = init;
    const std::vector<InputId> seeds = first_seeds(mesh, options);
    EXPECT_EQ(std::set<InputId>(seeds.begin(), seeds.end()).size(), 20U);
    options.greedy = GreedyMode::extended;
    const Tessellation whole = relax(mesh, options);
    RelaxOptions given;
    given.first_seeds = seeds;
    EXPECT_EQ(relax(mesh, given).fingerprint, whole.fingerprint);
  }
}

TEST(Library, DistancesAreThoseOfTheDiagramAndInfiniteElsewhere) {
  Mesh mesh = icosphere(320);
  RelaxOptions options;
  options.first_seeds = {7, 3, 100};
  EXPECT_EQ(distances(mesh, options), voronoi(mesh, options).distance);
  const VertexId own = static_cast<VertexId>(mesh.vertex_count());
  for (const Vec3& p : two_triangles().positions) mesh.positions.push_back(p + Vec3(5, 5, 5));
  mesh.triangles.push_back({own, own + 1, own + 2});
  const std::vector<double> found = distances(mesh, options);
  ASSERT_EQ(found.size(), mesh.vertex_count());
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(found[v] == infinite, v >= own);
  EXPECT_EQ(found[3], 0);
}

TEST(Library, ATraceHasAStepForEachEnergy) {
  RelaxOptions options = with_seeds(30);
  options.init = SeedInit::random;
  const Tessellation result = relax(creature(5000, 1), options);
  ASSERT_GT(result.trace.size(), 2U);
  EXPECT_EQ(result.trace.front().energy, result.initial_energy);
  EXPECT_EQ(result.trace.front().phase, Phase::greedy);
  EXPECT_EQ(result.trace.back().phase, Phase::precise);
  EXPECT_EQ(result.trace.back().seeds_moved, 0U);
  for (const TessellationStep& step : result.trace) {
    EXPECT_GE(step.energy, result.energy);
    EXPECT_GT(step.node_visits, 0U);
    EXPECT_GE(step.seconds, 0);
  }
}

TEST(Library, FieldsOfASphereAreTangentAndIsotropic) {
  const Mesh mesh = icosphere(1000);
  const std::vector<TangentSpace> curvature = curvature_field(mesh);
  const std::vector<TangentSpace> crosses = cross_field(mesh);
  ASSERT_EQ(curvature.size(), mesh.vertex_count());
  ASSERT_EQ(crosses.size(), mesh.vertex_count());
  for (VertexId v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(curvature[v].tangent_magnitude, curvature[v].bitangent_magnitude, 0.2);
    EXPECT_EQ(crosses[v].tangent_magnitude, 1);
    EXPECT_NEAR(crosses[v].tangent.dot(mesh.positions[v]), 0, 0.05);
    EXPECT_NEAR(crosses[v].tangent.dot(crosses[v].bitangent), 0, 1e-9);
  }
  EXPECT_THROW(curvature_field({}), InvalidInput);
  EXPECT_THROW(cross_field({}), InvalidInput);
}

TEST(Library, AVertexOfNoTriangleHasNoRegion) {
  Mesh mesh = two_triangles();
  mesh.positions.push_back({5, 5, 5});
  const Tessellation result = relax(mesh, with_seeds(1));
  EXPECT_EQ(result.region[4], no_id);
  EXPECT_EQ(result.distance[4], infinite);
  EXPECT_EQ(result.parent[4], no_id);
}

TEST(Library, ProgressIsReportedAndMayEndTheWork) {
  const Mesh mesh = creature(5000, 1);
  RelaxOptions options = with_seeds(30);
  options.init = SeedInit::random;
  std::size_t calls = 0;
  options.progress = [&](const Progress& progress) {
    EXPECT_GT(progress.energy, 0);
    return ++calls < 3;
  };
  const Tessellation stopped = relax(mesh, options);
  EXPECT_EQ(calls, 3U);
  EXPECT_EQ(stopped.stop_reason, StopReason::interrupted);
  EXPECT_LE(stopped.energy, stopped.initial_energy);
  options.progress = [](const Progress&) -> bool { throw std::runtime_error("from the callback"); };
  EXPECT_THROW(relax(mesh, options), std::runtime_error);
}

TEST(Library, ARemeshIsAManifoldWithSeedsAsVertices) {
  const Mesh mesh = torus(3000, 1);
  const Tessellation tessellation = relax(mesh, with_seeds(60));
  const Dual made = dual(mesh, tessellation);
  EXPECT_TRUE(made.is_manifold && made.has_input_topology && made.is_input_manifold);
  EXPECT_EQ(made.violations_left, 0U);
  ASSERT_EQ(made.seeds.size(), made.mesh.vertex_count());
  ASSERT_EQ(made.seeds.size(), 60 + made.seeds_added);
  for (std::size_t v = 0; v < made.seeds.size(); ++v) {
    EXPECT_EQ(made.mesh.positions[v], mesh.positions[made.seeds[v]]);
  }
  for (std::size_t r = 0; r < 60; ++r) EXPECT_EQ(made.seeds[r], tessellation.regions[r].seed);
  EXPECT_EQ(find_topology(made.mesh).parts, find_topology(mesh).parts);
  EXPECT_GT(quality(made.mesh).mean_quality, 0.5);
}

TEST(Library, AMeshWrittenAndReadIsTheSame) {
  const TemporaryFolder folder;
  const Mesh mesh = icosphere(100);
  write(folder.path() / "sphere.off", mesh);
  const LoadedMesh loaded = read(folder.path() / "sphere.off");
  EXPECT_EQ(loaded.mesh.positions, mesh.positions);
  EXPECT_EQ(loaded.mesh.triangles, mesh.triangles);
}

// A wrong call, and what its sentence must name.
struct WrongCall {
  const char* name;
  std::function<void()> call;
  const char* named;

  friend std::ostream& operator<<(std::ostream& out, const WrongCall& wrong) {
    return out << wrong.name;
  }
};

class LibraryRefuses : public testing::TestWithParam<WrongCall> {};

TEST_P(LibraryRefuses, WithASentence) {
  try {
    GetParam().call();
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(GetParam().named), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

void tessellate_moved(double coordinate) {
  Mesh mesh = two_triangles();
  mesh.positions[2].y() = coordinate;
  relax(mesh, with_seeds(1));
}

void tessellate_from(std::vector<InputId> seeds, const Mesh& mesh = two_triangles()) {
  RelaxOptions options;
  options.first_seeds = std::move(seeds);
  relax(mesh, options);
}

void tessellate_in(std::vector<TangentSpace> field) {
  RelaxOptions options = with_seeds(1);
  options.field = std::move(field);
  relax(two_triangles(), options);
}

TangentSpace space(double magnitude) {
  return {{1, 0, 0}, {0, 1, 0}, magnitude, 1};
}

Mesh with_triangle(Triangle triangle) {
  Mesh mesh = two_triangles();
  mesh.triangles.push_back(triangle);
  return mesh;
}

Mesh with_a_loose_triangle() {
  Mesh mesh = two_triangles();
  mesh.positions.insert(mesh.positions.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  mesh.triangles.push_back({4, 5, 6});
  return mesh;
}

const WrongCall wrong_calls[] = {
    {"EmptyMesh", [] { relax({}, with_seeds(1)); }, "no triangles"},
    {"NotANumber", [] { tessellate_moved(std::nan("")); }, "vertex 2"},
    {"Infinite", [] { tessellate_moved(infinite); }, "vertex 2"},
    {"TooLarge", [] { tessellate_moved(1e80); }, "vertex 2"},
    {"IdOutOfRange",
     [] {
       relax(with_triangle({0, 1, 4}), with_seeds(1));
     },
     "vertex 4"},
    {"NoId",
     [] {
       relax(with_triangle({0, no_id, 1}), with_seeds(1));
     },
     "triangle 2"},
    {"NothingButRepeatedVertices",
     [] {
       relax({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}}, with_seeds(1));
     },
     "three different vertices"},
    {"DistancesFromNowhere", [] { distances(two_triangles(), with_seeds(1)); }, "from where"},
    {"NoSeeds", [] { relax(two_triangles(), {}); }, "seed_count"},
    {"SeedsTwice",
     [] {
       RelaxOptions options = with_seeds(1);
       options.first_seeds = {0};
       relax(two_triangles(), options);
     },
     "one of seed_count, first_seeds"},
    {"SeedsAsIdsAndPositions",
     [] {
       RelaxOptions options;
       options.first_seeds = {0};
       options.first_positions = {{0, 0, 0}};
       relax(two_triangles(), options);
     },
     "one of seed_count, first_seeds"},
    {"PositionNowhere",
     [] {
       RelaxOptions options;
       options.first_positions = {{0, std::numeric_limits<double>::quiet_NaN(), 0}};
       relax(two_triangles(), options);
     },
     "first_positions"},
    {"MoreSeedsThanNodes", [] { relax(two_triangles(), with_seeds(5)); }, "more seeds (5)"},
    {"FewerSeedsThanComponents", [] { relax(with_a_loose_triangle(), with_seeds(1)); },
     "components"},
    {"UnknownSeed",
     [] {
       tessellate_from({0, 4});
     },
     "first_seeds[1] = 4"},
    {"RepeatedSeed",
     [] {
       tessellate_from({1, 0, 1});
     },
     "first_seeds[2] = 1"},
    {"SeedOfNoTriangle",
     [] {
       Mesh mesh = two_triangles();
       mesh.positions.push_back({9, 9, 9});
       tessellate_from({4}, mesh);
     },
     "first_seeds[0] = 4"},
    {"ComponentWithoutSeed", [] { tessellate_from({0}, with_a_loose_triangle()); },
     "connected component"},
    {"FieldOfAnotherLength",
     [] {
       tessellate_in({space(1), space(1)});
     },
     "4 vertices"},
    {"FieldNotFinite",
     [] {
       tessellate_in({space(1), space(1), space(infinite), space(1)});
     },
     "field[2]"},
    {"FieldNegative",
     [] {
       tessellate_in({space(1), space(1), space(1), space(-1)});
     },
     "field[3]"},
    {"RemeshOfNothing", [] { dual(two_triangles(), Tessellation{}); }, "tessellation"},
    {"RemeshOfAnotherMesh",
     [] { dual(with_a_loose_triangle(), relax(two_triangles(), with_seeds(1))); }, "another mesh"},
    {"RemeshOfTheSameSizes",
     [] {
       const Tessellation tessellation = relax(two_triangles(), with_seeds(1));
       Mesh other = two_triangles();
       std::swap(other.triangles[0], other.triangles[1]);
       dual(other, tessellation);
     },
     "another mesh"},
    {"RemeshOfAMeshWithAsManyPlaces",
     [] {
       RelaxOptions options = with_seeds(1);
       options.graph = GraphKind::mixed;
       const Tessellation tessellation = relax(two_triangles(), options);
       Mesh other = two_triangles();
       other.positions.pop_back();
       other.triangles = {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}};
       dual(other, tessellation);
     },
     "another mesh"},
    {"TopologyOfNotANumber",
     [] {
       Mesh mesh = two_triangles();
       mesh.positions[0].z() = std::nan("");
       find_topology(mesh);
     },
     "vertex 0"},
    {"NoSuchFormat", [] { write("mesh.xyz", two_triangles()); }, "mesh.xyz"},
    {"WritingAnInvalidMesh",
     [] {
       write("no_such_folder/m.ply", with_triangle({0, 1, 9}));
     },
     "vertex 9"},
};

INSTANTIATE_TEST_SUITE_P(Calls, LibraryRefuses, testing::ValuesIn(wrong_calls),
                         [](const auto& test) { return test.param.name; });

TEST(Library, AMeshWithoutTrianglesHasNoQualityAndNoParts) {
  EXPECT_TRUE(std::isnan(quality({}).mean_quality));
  EXPECT_TRUE(find_topology(Mesh{}).parts.empty());
  EXPECT_TRUE(self_intersections({}).empty());
}

TEST(Library, DirectionsOfAFieldMayHaveAnyLength) {
  const Mesh mesh = torus(500, 1);
  RelaxOptions options = with_seeds(9);
  options.field.assign(mesh.vertex_count(), space(2));
  const Tessellation expected = relax(mesh, options);
  for (TangentSpace& each : options.field) each.tangent *= 1000;
  EXPECT_EQ(relax(mesh, options).fingerprint, expected.fingerprint);
}

TEST(Library, PropertiesAreInterpolatedWhereTheyFit) {
  const Mesh mesh = two_triangles();
  const std::vector<Property> q = {{"q", std::vector<double>(mesh.vertex_count(), 3)}};
  const std::vector<SurfacePoint> places = {{0, {0.5, 0.25, 0.25}}, {1, {1, 0, 0}}};
  EXPECT_EQ(std::get<std::vector<double>>(values_at(mesh, q, places).at(0).values),
            (std::vector<double>{3, 3}));
  const std::vector<SurfacePoint> beyond = {{2, {1, 0, 0}}};
  EXPECT_THROW((void)values_at(mesh, q, beyond), InvalidInput);
  const std::vector<Property> too_few = {{"q", std::vector<double>{3}}};
  EXPECT_THROW((void)values_at(mesh, too_few, places), InvalidInput);
}

TEST(Library, AMissingFileIsAnIoError) {
  EXPECT_THROW(read("no/such/mesh.ply"), IoError);
  EXPECT_THROW(write("no/such/mesh.ply", two_triangles()), IoError);
}

}  // namespace
}  // namespace geolloyd

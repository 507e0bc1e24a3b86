// Fingerprints that must come out everywhere: any machine, compiler, level of optimisation. A
// change of the canonical definition, or of a generated mesh, changes them, and nothing else may.
#include <gtest/gtest.h>

#include "core/mesh_graph.h"
#include "core/reference_engine.h"
#include "core/relaxation.h"
#include "core/seeds.h"
#include "core/shapes.h"

namespace geolloyd {
namespace {

std::uint64_t fingerprint_of(GraphKind kind) {
  const Mesh mesh = creature(20000, 1);
  MeshGraphOptions options;
  options.kind = kind;
  const MeshGraph made = make_mesh_graph(mesh, find_edges(mesh), options);
  const auto seeds =
      choose_seeds(made.graph, connected_components(made.graph), SeedInit::farthest, 100, 1);
  const auto engine = make_reference_engine(made.graph);
  return relax(made.graph, *engine, seeds, {}).fingerprint;
}

TEST(Golden, FingerprintsAreThoseOnRecord) {
  EXPECT_EQ(fingerprint_of(GraphKind::vertex), 0xa8823d227735104aU);
  EXPECT_EQ(fingerprint_of(GraphKind::vertex_dense), 0xfd99dbda0ee06e03U);
  EXPECT_EQ(fingerprint_of(GraphKind::triangle), 0x4617d6a3f5b55650U);
  EXPECT_EQ(fingerprint_of(GraphKind::triangle_dense), 0x1e5c5b16bd7690f9U);
  EXPECT_EQ(fingerprint_of(GraphKind::mixed), 0x909f6a3f2fc60961U);
}

}  // namespace
}  // namespace geolloyd

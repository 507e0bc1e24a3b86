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
  EXPECT_EQ(fingerprint_of(GraphKind::vertex), 0x519ef75dd6009831U);
  EXPECT_EQ(fingerprint_of(GraphKind::vertex_dense), 0x625a7f65e8c59be2U);
  EXPECT_EQ(fingerprint_of(GraphKind::triangle), 0x02d2674e98a720b1U);
  EXPECT_EQ(fingerprint_of(GraphKind::triangle_dense), 0x25b38523f1a1d12bU);
  EXPECT_EQ(fingerprint_of(GraphKind::mixed), 0xc8a6648e12f34f4fU);
}

}  // namespace
}  // namespace geolloyd

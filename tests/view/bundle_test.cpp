// Bundles, read again by a reader that knows no more than the format.
#include "tools/view/bundle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/shapes/shapes.h"
#include "tests/view/bundle_reader.h"

namespace geolloyd {
namespace {

TEST(Placement, PutsAMeshIntoABallWhereverItIs) {
  for (const double scale : {1e-70, 1.0, 3e5, 1e74}) {
    for (const double shift : {0.0, 7.0}) {
      Mesh mesh = torus(300, 1);
      for (Vec3& p : mesh.positions) p = scale * (p + Vec3::Constant(shift));
      const Placement placement = placement_of(mesh);
      double farthest = 0;
      for (const Vec3& p : mesh.positions) farthest = std::max(farthest, norm(placement(p)));
      EXPECT_LE(farthest, 1 + 1e-9) << scale;
      EXPECT_GT(farthest, 0.5) << scale;
    }
  }
}

TEST(Placement, IsUsableWhereAllIsInOnePlace) {
  const Mesh mesh = {{{3, 4, 5}, {3, 4, 5}, {3, 4, 5}}, {{0, 1, 2}}};
  EXPECT_EQ(norm(placement_of(mesh)(mesh.positions[0])), 0);
  EXPECT_GT(placement_of({}).scale, 0);
}

TEST(Bundle, IsReadAgain) {
  Bundle bundle;
  bundle.title = "a \"scan\"";
  bundle.placement = {{1, 2, 3}, 4};
  bundle.info["energy"] = 0.125;
  bundle.add_places("places", std::vector<Vec3>{{1, 2, 3}, {5, 2, -1}});
  bundle.add_ids("few", {1, 2, no_id}, 3);
  bundle.add_ids("many", {1, 70000, no_id}, 70001, "vertex");
  bundle.arrays.push_back({"bytes", std::vector<std::uint8_t>{1, 2, 255}, 3, "", false});
  const BundleReader read(encode(bundle));
  EXPECT_EQ(read.header()["title"], bundle.title);
  EXPECT_EQ(read.header()["scale"], 4.0);
  EXPECT_EQ(read.header()["info"]["energy"], 0.125);
  EXPECT_EQ(read.array("places"), (std::vector<double>{0, 0, 0, 1, 0, -1}));
  EXPECT_EQ(read.array("few"), (std::vector<double>{1, 2, 65535}));
  EXPECT_EQ(read.array("many"), (std::vector<double>{1, 70000, 4294967295.0}));
  EXPECT_EQ(read.entry("many")["per"], "vertex");
  EXPECT_EQ(read.array("bytes"), (std::vector<double>{1, 2, 255}));
}

TEST(Bundle, KeepsIdsApartFromNoneAtTheLimitOfSixteenBits) {
  for (const std::size_t count : {std::size_t{65534}, std::size_t{65535}, std::size_t{65536}}) {
    Bundle bundle;
    bundle.add_ids("ids", {static_cast<std::uint32_t>(count - 1), no_id}, count);
    const BundleReader read(encode(bundle));
    EXPECT_NE(read.array("ids")[0], read.array("ids")[1]) << count;
    EXPECT_EQ(read.array("ids")[0], static_cast<double>(count - 1));
  }
}

TEST(Bundle, QuantisedPlacesAreWithinAStep) {
  Bundle bundle;
  const Mesh mesh = creature(500, 2);
  bundle.placement = placement_of(mesh);
  bundle.add_places("places", mesh.positions);
  const std::vector<double> exact = BundleReader(encode(bundle)).array("places");
  quantise(bundle.arrays[0]);
  const BundleReader read(encode(bundle));
  const std::vector<double> steps = read.array("places");
  ASSERT_EQ(steps.size(), exact.size());
  const double step = read.entry("places")["step"][0];
  const double origin = read.entry("places")["origin"][0];
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ASSERT_NEAR(origin + step * steps[i], exact[i], 0.51 * step);
  }
}

TEST(Bundle, NamesThatAreNoTextHurtNothing) {
  Bundle bundle;
  bundle.title = "\xff</script>\x80";
  EXPECT_NE(BundleReader(encode(bundle)).header()["title"].get<std::string>().find("script"),
            std::string::npos);
}

}  // namespace
}  // namespace geolloyd

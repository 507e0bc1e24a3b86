// Pages as files: what a browser finds in them. What it shows is tested in one: page_test.mjs.
#include "tools/view/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/shapes/shapes.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tests/support/temporary_folder.h"
#include "tests/view/bundle_reader.h"
#include "tools/view/layers.h"
#include "tools/view/simplify.h"

namespace geolloyd {
namespace {

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  return bytes;
}

// What is between the first `begin` and the `end` after it.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

Bundle bundle_with(const Mesh& mesh) {
  Bundle bundle;
  bundle.title = "creature";
  bundle.placement = placement_of(mesh);
  add_mesh(bundle, mesh);
  std::vector<std::uint32_t> region(mesh.vertex_count());
  for (std::size_t v = 0; v < region.size(); ++v) region[v] = mesh.positions[v].x() > 0 ? 1 : 0;
  bundle.add_ids("parent", region, region.size(), "vertex");
  bundle.add_ids("region", std::move(region), 2, "vertex");
  return bundle;
}

TEST(Page, MakesTextHarmless) {
  EXPECT_EQ(html_text("</title><b a='\"&"), "&lt;/title&gt;&lt;b a=&#39;&quot;&amp;");
}

class PageFile : public testing::Test {
 protected:
  void SetUp() override {
    try {
      check_viewer();
    } catch (const InvalidInput&) {
      GTEST_SKIP() << "built without the viewer";
    }
  }

  [[nodiscard]] std::string page(const Bundle& bundle,
                                 std::size_t most_bytes = most_page_bytes) const {
    summary_ = write_page(folder_.path() / "page.html", bundle, most_bytes);
    return read_file(folder_.path() / "page.html");
  }

  static BundleReader bundle_in(const std::string& page) {
    return BundleReader(decoded(between(page, "id=\"bundle\">", "</script>")));
  }

  TemporaryFolder folder_;
  mutable std::string summary_;
};

TEST_F(PageFile, HasItsBundleAndAsksForNothingElse) {
  Bundle bundle = bundle_with(creature(800, 1));
  bundle.title = "</script><script>alert(1)</script>@BUNDLE@";
  const std::string text = page(bundle);
  EXPECT_EQ(decoded(between(text, "id=\"bundle\">", "</script>")), encode(bundle));
  EXPECT_EQ(between(text, "<title>", "</title>"), html_text(bundle.title));
  EXPECT_EQ(text.find("<script>alert"), std::string::npos);
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(text.find(" src="), std::string::npos);
  EXPECT_EQ(text.find("@SCRIPT@"), std::string::npos);
}

TEST_F(PageFile, OfALargeMeshIsRoundedFirstThenSimplified) {
  const Mesh mesh = creature(20'000, 1);
  const Bundle bundle = bundle_with(mesh);
  const std::size_t whole = page(bundle).size();
  EXPECT_EQ(summary_.find("rounded"), std::string::npos);

  const std::size_t rounded = page(bundle, whole - 10'000).size();
  EXPECT_LT(rounded, whole - 10'000);
  EXPECT_NE(summary_.find("rounded"), std::string::npos);
  EXPECT_EQ(summary_.find("simplified"), std::string::npos);

  const std::size_t most = whole - (whole - page({}).size()) / 2;
  const std::string simplified = page(bundle, most);
  EXPECT_LT(simplified.size(), most);
  EXPECT_GT(simplified.size(), most - most / 5);
  EXPECT_NE(summary_.find("simplified from 21,276"), std::string::npos) << summary_;
  const BundleReader read = bundle_in(simplified);
  EXPECT_FALSE(read.header()["arrays"].contains("parent"));
  EXPECT_EQ(read.header()["info"]["notes"].size(), 2U);
}

TEST(Simplify, KeepsVerticesOfTheMeshAndWhatBelongsToThem) {
  const Mesh mesh = creature(8000, 1);
  Bundle bundle = bundle_with(mesh);
  const BundleReader whole(encode(bundle));
  simplify(bundle, 500);
  const BundleReader read(encode(bundle));
  const std::vector<double> places = read.array("positions");
  const std::vector<double> region = read.array("region");
  const std::vector<double> corners = read.array("triangles");
  ASSERT_EQ(places.size(), 3 * region.size());
  EXPECT_LE(region.size(), 500U);
  EXPECT_GT(region.size(), 300U);
  EXPECT_LT(*std::max_element(corners.begin(), corners.end()), static_cast<double>(region.size()));
  // In the order of the mesh: each is found after the one before.
  const std::vector<double> old_places = whole.array("positions");
  const std::vector<double> old_region = whole.array("region");
  std::size_t v = 0;
  for (std::size_t i = 0; i < region.size(); ++i, ++v) {
    while (v < old_region.size() &&
           !std::equal(&places[3 * i], &places[3 * i] + 3, &old_places[3 * v])) {
      ++v;
    }
    ASSERT_LT(v, old_region.size());
    ASSERT_EQ(region[i], old_region[v]);
  }
}

TEST(Simplify, LeavesOneVertexAndNoTriangle) {
  Bundle bundle = bundle_with(icosphere(100));
  simplify(bundle, 1);
  const BundleReader read(encode(bundle));
  EXPECT_EQ(read.array("region").size(), 1U);
  EXPECT_EQ(read.array("triangles").size(), 0U);
}

}  // namespace
}  // namespace geolloyd

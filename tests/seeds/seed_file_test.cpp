#include "core/seeds/seed_file.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// A unit square of two triangles, a vertex of no triangle (4), and a triangle apart (5, 6, 7).
const Mesh square_and_more{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 2}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
    {{0, 1, 2}, {0, 2, 3}, {5, 6, 7}}};

class SeedFile : public testing::Test {
 protected:
  // Input ids of what is read.
  std::vector<std::uint32_t> read(const std::string& text, GraphKind kind = GraphKind::vertex,
                                  SeedsBy by = SeedsBy::id) {
    MeshGraphOptions options;
    options.kind = kind;
    const MeshGraph made = make_mesh_graph(square_and_more, find_edges(square_and_more), options);
    const GivenSeeds seeds = parse_seeds(text, "s.txt", by, made, connected_components(made.graph));
    fit_ = seeds.fit;
    std::vector<std::uint32_t> ids;
    for (const NodeId s : seeds.nodes) ids.push_back(made.input_id[s]);
    return ids;
  }

  void expect_refused(const std::string& text, const std::string& message,
                      GraphKind kind = GraphKind::vertex, SeedsBy by = SeedsBy::id) {
    try {
      read(text, kind, by);
      FAIL() << "accepted: " << text;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("s.txt: " + message), std::string::npos)
          << error.what();
    }
  }

  std::optional<PositionFit> fit_;  // of what was read last
};

using Ids = std::vector<std::uint32_t>;

TEST_F(SeedFile, HoldsInputIds) {
  EXPECT_EQ(read("3\n6\n0\n"), (Ids{3, 6, 0}));
  EXPECT_EQ(read("# two\r\n\r\n 3 \r\n5"), (Ids{3, 5}));
  EXPECT_EQ(read("\xef\xbb\xbf"
                 "3\n5\n"),
            (Ids{3, 5}));  // a byte order mark
}

TEST_F(SeedFile, CountsTrianglesFromZeroOrInTheMixedGraphAfterTheVertices) {
  EXPECT_EQ(read("2\n1\n", GraphKind::triangle), (Ids{2, 1}));
  EXPECT_EQ(read("9\n10\n1\n", GraphKind::mixed), (Ids{9, 10, 1}));
}

TEST_F(SeedFile, HoldsPositionsThatStandForTheNearestNode) {
  EXPECT_EQ(read("0.9 0.8 0.3\n5,0.6,0\n"), (Ids{2, 7}));
  EXPECT_EQ(read("0.6 0.3 0\n9 9 9\n", GraphKind::triangle), (Ids{0, 2}));
}

TEST_F(SeedFile, TakesATableByPositionIfAskedTo) {
  const std::string header = "input_id,kind,x,y,z,nodes,area,energy\n";
  const std::string rows = "77,triangle,0.1,1,0,4,1,2\n3,vertex,5,0.8,0,3,1,1\n";
  EXPECT_EQ(read(header + rows, GraphKind::vertex, SeedsBy::position), (Ids{3, 7}));
  ASSERT_TRUE(fit_);
  EXPECT_NEAR(fit_->farthest, 0.2, 1e-12);
  EXPECT_EQ(fit_->left_out, 0U);
  EXPECT_EQ(read("z,name,y,x\n0,a,1,0\n0,b,1,5\n"), (Ids{3, 7}));  // has no ids
  EXPECT_EQ(read("0 1 0\n5 1 0\n", GraphKind::vertex, SeedsBy::position), (Ids{3, 7}));
  read("3\n6\n0\n");
  EXPECT_FALSE(fit_);
}

TEST_F(SeedFile, LeavesOutPositionsAtTheNodeOfAnEarlierOneAndCountsThem) {
  EXPECT_EQ(read("0 0 0\n0.1 0 0\n5 0 0\n0 0.2 0\n"), (Ids{0, 5}));
  ASSERT_TRUE(fit_);
  EXPECT_EQ(fit_->left_out, 2U);
  EXPECT_NEAR(fit_->farthest, 0.2, 1e-12);
}

// The first is as far from 0 as from 1, the second from 0, 1, 2 and 3; all of triangle 2 are
// behind.
TEST_F(SeedFile, OfNodesEquallyNearTheOneWithTheSmallestIdIsTaken) {
  EXPECT_EQ(read("0.5 -1 0\n5 0 0\n"), (Ids{0, 5}));
  EXPECT_EQ(read("5 0 0\n0.5 0.5 0\n"), (Ids{5, 0}));
  EXPECT_EQ(read("1.5 0.5 0\n5.5 0.5 0\n"), (Ids{1, 5}));
}

TEST_F(SeedFile, TakenByPositionIsRefusedWithTheLineWhereItIsWrong) {
  const auto refused = [&](const std::string& text, const std::string& message) {
    expect_refused(text, message, GraphKind::vertex, SeedsBy::position);
  };
  refused("", "line 1: no seeds");
  refused("input_id,kind,x,y,z\n", "line 2: no seeds");
  refused("input_id,kind,x,y\n3,vertex,0,1\n", "line 1: no column z: seeds by position need");
  refused("input_id,kind\n3,vertex\n", "line 1: no column x: seeds by position need x, y and z");
  refused("input_id,kind,x,y,z\n3,vertex,0,nan,0\n", "line 2: coordinate is not a finite number");
  refused("input_id,kind,x,y,z\n3,vertex,0,1\n", "line 2: 4 values where the table has 5 columns");
  refused("input_id,kind,x,y,z\n3,vertex,0,1,a\n", "line 2: expected a coordinate, found 'a'");
  refused("3\n6\n", "line 1: a list of input ids has no positions");
  refused("0 0 0\n", "1 of 2 connected components have no seed");
}

TEST_F(SeedFile, HasAtMostAsManySeedsAsLines) {
  EXPECT_EQ(most_seeds("# two\r\n\r\n 3 \r\n5"), 2U);
  EXPECT_EQ(most_seeds("0.9 0.8 0.3\n\n5,0.6,0\n"), 2U);
  EXPECT_EQ(most_seeds("input_id,kind\n3,vertex\n6,vertex\n"), 3U);  // and the names of columns
  EXPECT_EQ(most_seeds(""), 0U);
}

TEST_F(SeedFile, MayBeAWrittenTable) {
  const std::string header = "input_id,kind,x,y,z,nodes,area,energy\n";
  EXPECT_EQ(read(header + "3,vertex,0,1,0,4,1,2\n6,vertex,6,0,0,3,1,1\n"), (Ids{3, 6}));
  EXPECT_EQ(read(header + "9,triangle,0,1,0,4,1,2\n6,vertex,6,0,0,3,1,1\n", GraphKind::mixed),
            (Ids{9, 6}));
  EXPECT_EQ(read("input_id,kind\n3,vertex\n6,vertex\n"), (Ids{3, 6}));
  expect_refused(header + "0,vertex,0,1,0,4,1,2\n", "line 2: seed of kind 'vertex'",
                 GraphKind::triangle);
  expect_refused(header + "3,vertex,0,1,0,4,1,2\n6,vertex,6,0,0,3,1\n",
                 "line 3: 7 values where the table has 8 columns: is the file complete?");
}

// A table that was cut off is refused, or it ends with one of its lines.
TEST_F(SeedFile, NoPartOfALineIsTakenForTheWhole) {
  const std::string lines =
      "input_id,kind,x,y,z,nodes,area,energy\n6,vertex,6,0,0,3,1,1\n3,vertex,0,1,0,4,1,2\n";
  const std::string last = "2,vertex,1,1,0,4,1,2\n";
  EXPECT_EQ(read(lines + last), (Ids{6, 3, 2}));
  for (std::size_t size = 1; size + 2 < last.size(); ++size) {
    expect_refused(lines + last.substr(0, size), "line 4: ");
  }
}

TEST_F(SeedFile, IsRefusedInAMessageThatPrints) {
  const std::string header = "input_id,kind\n";
  expect_refused(header + "3,\x01z\xff\n", "line 2: seed of kind '?z?' where");
  expect_refused(header + "3," + std::string(100, 'x') + "\n",
                 "line 2: seed of kind '" + std::string(40, 'x') + "...' where");
}

TEST_F(SeedFile, IsRefusedWithTheLineWhereItIsWrong) {
  expect_refused("", "line 1: no seeds");
  expect_refused("# nothing\n", "line 2: no seeds");
  expect_refused("0\nx\n", "line 2: ");
  expect_refused("0\n8\n", "line 2: input id 8 is none of this graph's, which are 0 to 7");
  expect_refused("0\n-1\n", "line 2: input id -1");
  expect_refused("0\n99999999999999999999\n", "line 2: ");
  expect_refused("0\n4\n", "line 2: input id 4 has no region");
  expect_refused("0\n5\n0\n", "line 3: the same node as the seed on line 1");
  expect_refused("0 0 0\n1 1\n", "line 2: ");
  expect_refused("0 0 0\n1 1 nan\n", "line 2: coordinate is not a finite number");
  expect_refused("0 0 0\n1e160 1 1\n", "line 2: coordinate is not a finite number");
  expect_refused("0 0 0\n1 1 1 1\n", "line 2: expected three coordinates");
  expect_refused("0\n5 5\n", "line 2: expected one input id");
}

TEST_F(SeedFile, MustReachEveryComponent) {
  expect_refused("0\n2\n", "1 of 2 connected components have no seed");
}

}  // namespace
}  // namespace geolloyd

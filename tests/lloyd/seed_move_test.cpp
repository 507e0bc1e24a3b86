#include "core/lloyd/seed_move.h"

#include <gtest/gtest.h>

#include "tests/support/naive.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

SubtreeSums naive_sums(const Graph& graph, const Partition& partition) {
  SubtreeSums sums;
  for (NodeId v = 0; v < graph.node_count(); ++v) {
    const naive::Sums s = naive::subtree(graph, partition, v);
    sums.cost.push_back(s.cost);
    sums.mass.push_back(s.mass);
  }
  return sums;
}

template <class Check>
void for_random_partitions(Check&& check) {
  for (std::uint64_t random_seed = 0; random_seed < 150; ++random_seed) {
    SCOPED_TRACE(random_seed);
    const Graph graph = random_graph(random_seed, 20);
    const std::vector<NodeId> seeds = random_nodes(random_seed, 20, 1 + random_seed % 5);
    const Partition partition = naive::partition(graph, seeds);
    const SubtreeSums sums = naive_sums(graph, partition);
    for (const bool extended : {false, true}) {
      for (const NodeId seed : seeds) {
        check(SeedMoveView{graph, partition, sums, extended}, seed, random_seed);
      }
    }
  }
}

TEST(SeedMove, HeuristicAgreesWithBruteForce) {
  for_random_partitions([](const SeedMoveView& view, NodeId seed, std::uint64_t) {
    for (const NodeId v : naive::neighbours_in_region(view.graph, view.partition, seed)) {
      ASSERT_EQ(heuristic(view, seed, v),
                naive::heuristic(view.graph, view.partition, seed, v, view.extended));
    }
  });
}

TEST(SeedMove, GreedyCandidateAgreesWithBruteForce) {
  for_random_partitions([](const SeedMoveView& view, NodeId seed, std::uint64_t) {
    const auto nodes = naive::neighbours_in_region(view.graph, view.partition, seed);
    ASSERT_EQ(greedy_candidate(view, seed),
              naive::largest_heuristic(view.graph, view.partition, seed, nodes, view.extended));
  });
}

TEST(SeedMove, PreciseCandidateAgreesWithBruteForce) {
  for_random_partitions([](const SeedMoveView& view, NodeId seed, std::uint64_t random_seed) {
    // Scores from a few values, so that ties come up; about half of the nodes have one.
    std::vector<Score> score(view.graph.node_count(), never_scored);
    std::map<NodeId, Score> known;
    for (NodeId v = 0; v < score.size(); ++v) {
      const std::uint64_t bits = random_bits(random_seed, v);
      if (v != seed && bits % 2 == 0) continue;
      score[v] = known[v] = (bits >> 32) % 4;
    }
    ASSERT_EQ(precise_candidate(view, score, seed),
              naive::precise_candidate(view.graph, view.partition, known, seed, view.extended));
  });
}

// A star: seed 0 in the middle, arms of different weight.
class Star : public testing::Test {
 protected:
  const Graph graph_ =
      make_graph(std::vector<UndirectedArc>{{0, 1, 1}, {0, 2, 1}, {2, 3, 1}, {0, 4, 1}},
                 std::vector<double>(5, 1.0));
  const Partition partition_ = naive::partition(graph_, {0});
  const SubtreeSums sums_ = naive_sums(graph_, partition_);
  const SeedMoveView view_{graph_, partition_, sums_, false};
  std::vector<Score> score_ = std::vector<Score>(5, never_scored);
};

TEST_F(Star, TheGreedySeedGoesToTheHeaviestArm) {
  EXPECT_EQ(greedy_candidate(view_, 0), 2U);
}

TEST_F(Star, ALowerScoreBeatsEveryHeuristic) {
  score_[0] = 10;
  score_[4] = 9;
  EXPECT_EQ(precise_candidate(view_, score_, 0), 4U);
}

TEST_F(Star, TheLowestScoreWinsAndTheSmallerNodeOfEquals) {
  score_[0] = 10;
  score_[1] = 9;
  score_[2] = 7;
  score_[4] = 7;
  EXPECT_EQ(precise_candidate(view_, score_, 0), 2U);
}

TEST_F(Star, ASeedWhoseNeighboursAllScoredHigherOrEqualStays) {
  score_[0] = 10;
  score_[1] = 10;
  score_[2] = 11;
  score_[4] = 12;
  EXPECT_EQ(precise_candidate(view_, score_, 0), no_id);
}

TEST_F(Star, TheHeuristicChoosesAmongNeverScoredOnesOnly) {
  score_[0] = 10;
  score_[2] = 11;
  EXPECT_EQ(precise_candidate(view_, score_, 0), 1U);
}

}  // namespace
}  // namespace geolloyd

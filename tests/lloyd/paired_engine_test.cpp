#include "core/lloyd/paired_engine.h"

#include <gtest/gtest.h>

#include "core/lloyd/reference_engine.h"
#include "core/lloyd/relaxation.h"
#include "tests/support/random_graph.h"

namespace geolloyd {
namespace {

// An engine that goes wrong in one place, from its n-th partition on.
class Faulty final : public Engine {
 public:
  enum class Fault { key, parent, score, candidate, rest, microsteps };

  Faulty(const Graph& graph, Fault fault, int after)
      : true_(make_reference_engine(graph)), fault_(fault), left_(after) {}

  void partition(std::span<const NodeId> seeds) override {
    true_->partition(seeds);
    partition_ = true_->current();
    scores_.assign(true_->region_scores().begin(), true_->region_scores().end());
    if (--left_ > 0) return;
    if (fault_ == Fault::key) ++partition_.key[7];
    if (fault_ == Fault::parent) partition_.parent[7] = 3;
    if (fault_ == Fault::score) ++scores_[1];
  }
  [[nodiscard]] std::span<const Score> region_scores() const override { return scores_; }
  [[nodiscard]] std::uint64_t state_digest(std::span<const NodeId> seeds) const override {
    return true_->state_digest(seeds);
  }
  std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) override {
    std::vector<NodeId> candidates = true_->greedy_candidates(seeds, extended);
    if (left_ <= 0 && fault_ == Fault::candidate) candidates[1] = 99;
    return candidates;
  }
  std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions& options,
                                   const KeepGoing& keep_going) override {
    std::vector<Microstep> microsteps = true_->macrostep(seeds, options, keep_going);
    if (left_ <= 0 && fault_ == Fault::rest) seeds[1] = 99;
    if (left_ <= 0 && fault_ == Fault::microsteps) ++microsteps[0].seeds_moved;
    return microsteps;
  }
  [[nodiscard]] const Partition& current() const override { return partition_; }
  [[nodiscard]] const KernelSeconds& seconds() const override { return true_->seconds(); }

 private:
  std::unique_ptr<Engine> true_;
  Fault fault_;
  int left_;
  Partition partition_;
  std::vector<Score> scores_;
};

std::string complaint(Faulty::Fault fault, int after, NodeId& node) {
  const Graph graph = grid_graph(10, 10);
  const auto reference = make_reference_engine(graph);
  Faulty faulty(graph, fault, after);
  PairedEngine pair(*reference, faulty);
  try {
    relax(graph, pair, {0, 1, 2}, {});
  } catch (const Disagreement& difference) {
    node = difference.node;
    return difference.what();
  }
  return "";
}

TEST(PairedEngine, NamesTheFirstStepNodeAndValueThatDiffer) {
  NodeId node = no_id;
  EXPECT_EQ(complaint(Faulty::Fault::key, 3, node).substr(0, 53),
            "after 2 greedy steps and 0 macrosteps: nearest seed: ");
  EXPECT_EQ(node, 7U);
  EXPECT_NE(
      complaint(Faulty::Fault::parent, 1, node).find("0 greedy steps and 0 macrosteps: parent"),
      std::string::npos);
  EXPECT_EQ(node, 7U);
  EXPECT_NE(complaint(Faulty::Fault::score, 1, node).find("score of its region, seed 1"),
            std::string::npos);
  EXPECT_EQ(node, 1U);
  EXPECT_NE(complaint(Faulty::Fault::candidate, 1, node).find("greedy candidate, seed 1"),
            std::string::npos);
  EXPECT_NE(complaint(Faulty::Fault::rest, 1, node).find("seed after the macrostep"),
            std::string::npos);
  EXPECT_NE(complaint(Faulty::Fault::microsteps, 1, node).find("microsteps"), std::string::npos);
}

TEST(PairedEngine, IsSilentWhereBothAgree) {
  const Graph graph = grid_graph(10, 10);
  const auto one = make_reference_engine(graph);
  const auto other = make_reference_engine(graph);
  const auto alone = make_reference_engine(graph);
  PairedEngine pair(*one, *other);
  EXPECT_EQ(relax(graph, pair, {0, 1, 2}, {}).fingerprint,
            relax(graph, *alone, {0, 1, 2}, {}).fingerprint);
  EXPECT_GT(pair.expected_seconds(), 0);
  EXPECT_GT(pair.tested_seconds(), 0);
}

}  // namespace
}  // namespace geolloyd

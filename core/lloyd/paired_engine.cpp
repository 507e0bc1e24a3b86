#include "core/lloyd/paired_engine.h"

#include <utility>

#include "core/base/stopwatch.h"

namespace geolloyd {
namespace {

std::string text_of(std::uint32_t id) {
  return id == no_id ? "none" : std::to_string(id);
}

std::string text_of(Score score) {
  std::string digits;
  for (; score > 0 || digits.empty(); score /= 10) {
    digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(score % 10)));
  }
  return digits;
}

std::string text_of(Key key) {
  if (key == unreached) return "none";
  return "region " + text_of(region_of(key)) + " at " + std::to_string(distance_of(key)) + " ticks";
}

}  // namespace

void PairedEngine::partition(std::span<const NodeId> seeds) {
  {
    const Timed timed(expected_seconds_);
    expected_.partition(seeds);
  }
  {
    const Timed timed(tested_seconds_);
    tested_.partition(seeds);
  }
  compare_partitions();
  compare("score of its region", expected_.region_scores(), tested_.region_scores(), seeds);
}

std::span<const Score> PairedEngine::region_scores() const {
  return expected_.region_scores();
}

std::uint64_t PairedEngine::state_digest(std::span<const NodeId> seeds) const {
  const std::uint64_t expected = expected_.state_digest(seeds);
  const std::uint64_t tested = tested_.state_digest(seeds);
  if (expected != tested) {
    differ(no_id, "digest of the state", std::to_string(expected), std::to_string(tested));
  }
  return expected;
}

std::vector<NodeId> PairedEngine::greedy_candidates(std::span<const NodeId> seeds, bool extended) {
  std::vector<NodeId> expected;
  std::vector<NodeId> tested;
  {
    const Timed timed(expected_seconds_);
    expected = expected_.greedy_candidates(seeds, extended);
  }
  {
    const Timed timed(tested_seconds_);
    tested = tested_.greedy_candidates(seeds, extended);
  }
  compare<NodeId>("greedy candidate", expected, tested, seeds);
  ++greedy_steps_;
  return expected;
}

std::vector<Microstep> PairedEngine::macrostep(std::vector<NodeId>& seeds,
                                               const MacrostepOptions& options,
                                               const KeepGoing& keep_going) {
  const std::vector<NodeId> before = seeds;
  bool goes_on = true;
  const auto ask = [&](std::uint32_t seeds_moving) {
    return goes_on = goes_on && keep_going(seeds_moving);
  };
  std::vector<NodeId> others = seeds;
  std::vector<Microstep> expected;
  {
    const Timed timed(expected_seconds_);
    expected = expected_.macrostep(seeds, options, ask);
  }
  std::vector<Microstep> tested;
  SeedTrails trails;
  {
    MacrostepOptions same = options;
    if (options.trails != nullptr) same.trails = &trails;
    const Timed timed(tested_seconds_);
    tested = tested_.macrostep(others, same, ask);
  }
  if (!goes_on) return expected;
  compare<NodeId>("seed after the macrostep", seeds, others, before);
  if (expected != tested) {
    differ(no_id, "number of microsteps, or what they moved", std::to_string(expected.size()),
           std::to_string(tested.size()));
  }
  if (options.trails != nullptr && *options.trails != trails) {
    differ(no_id, "trails of seeds", "those of the one engine", "others");
  }
  ++macrosteps_;
  return expected;
}

void PairedEngine::differ(NodeId node, const std::string& what, const std::string& expected,
                          const std::string& tested) const {
  throw Disagreement("after " + std::to_string(greedy_steps_) + " greedy steps and " +
                         std::to_string(macrosteps_) + " macrosteps: " + what + ": expected " +
                         expected + ", got " + tested,
                     node);
}

template <class Value>
void PairedEngine::compare(const char* what, std::span<const Value> expected,
                           std::span<const Value> tested, std::span<const NodeId> seeds) const {
  if (expected.size() != tested.size()) {
    differ(no_id, std::string("number of values, ") + what, std::to_string(expected.size()),
           std::to_string(tested.size()));
  }
  for (std::size_t r = 0; r < expected.size(); ++r) {
    if (expected[r] == tested[r]) continue;
    differ(seeds[r], std::string(what) + ", seed " + std::to_string(r), text_of(expected[r]),
           text_of(tested[r]));
  }
}

void PairedEngine::compare_partitions() const {
  const Partition& expected = expected_.current();
  const Partition& tested = tested_.current();
  for (NodeId v = 0; v < expected.key.size(); ++v) {
    if (expected.key[v] != tested.key[v]) {
      differ(v, "nearest seed", text_of(expected.key[v]), text_of(tested.key[v]));
    }
    if (expected.parent[v] != tested.parent[v]) {
      differ(v, "parent", text_of(expected.parent[v]), text_of(tested.parent[v]));
    }
  }
}

}  // namespace geolloyd

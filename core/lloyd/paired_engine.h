#pragma once

#include <string>

#include "core/base/disagreement.h"
#include "core/graph/graph.h"
#include "core/lloyd/engine.h"

namespace geolloyd {

/// Has two engines do everything, compares all they give, node by node, and goes on with it. Throws
/// Disagreement at the first difference, which names step, place and both values.
class PairedEngine final : public Engine {
 public:
  PairedEngine(Engine& expected, Engine& tested) : expected_(expected), tested_(tested) {}

  void partition(std::span<const NodeId> seeds) override;
  [[nodiscard]] std::span<const Score> region_scores() const override;
  [[nodiscard]] std::uint64_t state_digest(std::span<const NodeId> seeds) const override;
  std::vector<NodeId> greedy_candidates(std::span<const NodeId> seeds, bool extended) override;
  std::vector<Microstep> macrostep(std::vector<NodeId>& seeds, const MacrostepOptions& options,
                                   const KeepGoing& keep_going) override;
  [[nodiscard]] const Partition& current() const override { return expected_.current(); }
  [[nodiscard]] const KernelSeconds& seconds() const override { return expected_.seconds(); }

  /// Wall time each has taken so far.
  [[nodiscard]] double expected_seconds() const { return expected_seconds_; }
  [[nodiscard]] double tested_seconds() const { return tested_seconds_; }

 private:
  [[noreturn]] void differ(NodeId node, const std::string& what, const std::string& expected,
                           const std::string& tested) const;
  template <class Value>
  void compare(const char* what, std::span<const Value> expected, std::span<const Value> tested,
               std::span<const NodeId> seeds) const;
  void compare_partitions() const;

  Engine& expected_;
  Engine& tested_;
  double expected_seconds_ = 0;
  double tested_seconds_ = 0;
  std::uint32_t greedy_steps_ = 0;
  std::uint32_t macrosteps_ = 0;
};

}  // namespace geolloyd

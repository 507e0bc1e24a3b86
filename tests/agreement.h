#pragma once

#include <gtest/gtest.h>

#include "core/reference_engine.h"
#include "core/relaxation.h"
#include "parallel/parallel_engine.h"

namespace geolloyd {

inline constexpr Backend all_backends[] = {Backend::tbb, Backend::openmp};
inline constexpr Frontier all_frontiers[] = {Frontier::heap, Frontier::delta, Frontier::regions,
                                             Frontier::automatic};

inline Relaxation relax_by_reference(const Graph& graph, const std::vector<NodeId>& seeds,
                                     const RelaxationOptions& options) {
  const auto engine = make_reference_engine(graph);
  return relax(graph, *engine, seeds, options);
}

inline Relaxation relax_in_parallel(Scheduler& scheduler, Frontier frontier, const Graph& graph,
                                    const std::vector<NodeId>& seeds,
                                    const RelaxationOptions& options) {
  const auto engine = make_parallel_engine(scheduler, graph, frontier);
  return relax(graph, *engine, seeds, options);
}

/// Everything but times.
inline void expect_same(const Relaxation& expected, const Relaxation& tested) {
  ASSERT_EQ(expected.steps.size(), tested.steps.size());
  for (std::size_t i = 0; i < expected.steps.size(); ++i) {
    const Step& e = expected.steps[i];
    const Step& t = tested.steps[i];
    ASSERT_EQ(e.phase, t.phase) << "step " << i;
    ASSERT_EQ(e.state, t.state) << "step " << i;
    ASSERT_EQ(e.score, t.score) << "step " << i;
    ASSERT_EQ(e.seeds_moved, t.seeds_moved) << "step " << i;
    ASSERT_EQ(e.node_visits, t.node_visits) << "step " << i;
    ASSERT_EQ(e.microsteps, t.microsteps) << "step " << i;
  }
  ASSERT_EQ(expected.fingerprint, tested.fingerprint);
  ASSERT_EQ(expected.end, tested.end);
  ASSERT_EQ(expected.seeds, tested.seeds);
  ASSERT_EQ(expected.partition.key, tested.partition.key);
  ASSERT_EQ(expected.partition.parent, tested.partition.parent);
  ASSERT_EQ(expected.region_score, tested.region_score);
}

}  // namespace geolloyd

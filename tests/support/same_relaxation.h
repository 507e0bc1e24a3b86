#pragma once

#include <gtest/gtest.h>

#include "core/lloyd/relaxation.h"

namespace geolloyd {

/// Everything but times.
inline void expect_same(const Relaxation& expected, const Relaxation& tested) {
  ASSERT_EQ(expected.steps.size(), tested.steps.size());
  for (std::size_t i = 0; i < expected.steps.size(); ++i) {
    const Step& e = expected.steps[i];
    const Step& t = tested.steps[i];
    ASSERT_EQ(e.phase, t.phase) << "step " << i;
    ASSERT_EQ(e.state, t.state) << "step " << i;
    ASSERT_EQ(e.score, t.score) << "step " << i;
    ASSERT_EQ(e.energy, t.energy) << "step " << i;
    ASSERT_EQ(e.seeds_moved, t.seeds_moved) << "step " << i;
    ASSERT_EQ(e.node_visits, t.node_visits) << "step " << i;
    ASSERT_EQ(e.microsteps, t.microsteps) << "step " << i;
  }
  ASSERT_EQ(expected.fingerprint, tested.fingerprint);
  ASSERT_EQ(expected.stop_reason, tested.stop_reason);
  ASSERT_EQ(expected.seeds, tested.seeds);
  ASSERT_EQ(expected.partition.key, tested.partition.key);
  ASSERT_EQ(expected.partition.parent, tested.partition.parent);
  ASSERT_EQ(expected.region_score, tested.region_score);
}

}  // namespace geolloyd

#pragma once

#include <array>
#include <vector>

#include "core/surface/flips/glide_patch.h"

namespace geolloyd {

/// Edges to flip one after the other.
using FlipPath = std::vector<std::array<VertexId, 2>>;

/// One vertex less, or one more, or neither; then flips.
struct PatchChange {
  std::array<VertexId, 2> collapse = {no_id, no_id};  ///< an edge
  GlidePatch::Split split = {no_id, no_id, no_id};
  FlipPath flips;

  [[nodiscard]] bool collapses() const { return collapse[0] != no_id; }
  [[nodiscard]] bool splits() const { return split.vertex != no_id; }
};

/// Paths of flips that start at the centre of a patch and lower the sum of squares of excess: an
/// irregular vertex, or a pair, glides through the remesh until it meets another one. No flip of a
/// path raises the sum. The shortest ones of those met first, shortest first.
std::vector<PatchChange> find_glide_paths(GlidePatch patch);

/// Collapses of an edge near the centre of a patch, or splits of a vertex, each with a path of
/// flips if it needs one to lower the sum.
std::vector<PatchChange> find_collapses(const GlidePatch& patch);
std::vector<PatchChange> find_splits(const GlidePatch& patch);

}  // namespace geolloyd
